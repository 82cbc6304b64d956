// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: constant acceleration over a fixed horizon, filtered. */
export function build(options?: BuildOptions<"kalman">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
