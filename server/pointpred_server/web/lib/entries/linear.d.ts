// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: constant velocity over a fixed horizon. */
export function build(options?: BuildOptions<"linear">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
