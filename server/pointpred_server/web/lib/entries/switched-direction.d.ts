// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: one sub-movement after the other along its direction: doubling, then an approach that converges. */
export function build(options?: BuildOptions<"switched-direction">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
