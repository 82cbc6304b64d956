// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: kinematic, corrected by what the person's earlier movements taught. */
export function build(options?: BuildOptions<"kinematic-adaptive">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
export { onPlace } from "../index.js";
