// Written by `make laws` from the registry: change that and run it again.
import type { BuildOptions, Pipeline } from "../index.js";

/** A pipeline of this predictor: as far as the session's earlier movement whose speed profile is most alike. */
export function build(options?: BuildOptions<"ktm">): Promise<Pipeline>;
export * from "../intent/one-predictor.js";
