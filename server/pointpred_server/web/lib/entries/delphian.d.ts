// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: once past the speed peak, as far as a line through the peak speed says. */
export function build(options?: BuildOptions<"delphian">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
