// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: learned from people: endpoint, region, tail and time left from the movement so far. */
export function build(options?: BuildOptions<"kinematic">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
