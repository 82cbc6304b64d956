// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: no prediction: the cursor's own position. */
export function build(options?: BuildOptions<"hold">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
