// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: where a quadratic of speed over distance returns to zero. */
export function build(options?: BuildOptions<"kep-quadratic">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
