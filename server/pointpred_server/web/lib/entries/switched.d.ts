// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: doubling while the hand accelerates, DREM while it corrects; tuned. */
export function build(options?: BuildOptions<"switched">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
