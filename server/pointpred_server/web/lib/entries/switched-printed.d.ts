// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: switched with the gains, threshold and bound as printed. */
export function build(options?: BuildOptions<"switched-printed">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
