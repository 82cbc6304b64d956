// Pipelines by name, of all predictors.

import { REGISTRY } from "../laws/registry.js";
import { assemble } from "./assembly.js";

/**
 * A fresh pipeline for a name of the registry, as `assemble` makes it.
 * @param {string} name @param {import("./assembly.js").BuildOptions & Object<string, unknown>} [options]
 * @returns {Promise<import("./pipeline.js").Pipeline>}
 */
export const build = (name, options) => assemble(REGISTRY, name, options);
