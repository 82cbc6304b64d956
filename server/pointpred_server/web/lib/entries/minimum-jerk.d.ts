// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: minimum-jerk inversion, no training. */
export function build(options?: BuildOptions<"minimum-jerk">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
