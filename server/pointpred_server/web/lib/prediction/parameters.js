// The values of a stage's parameters: the given ones, the registry's or the defaults, checked as in Python.

import { ParameterError } from "./errors.js";
import { general, nearest, quoted } from "./words.js";

/**
 * @typedef {{name: string, unit?: string, low: number, high: number, default?: number|null, whole?: boolean,
 *   absent?: number|null}} Parameter bounds are closed; absent: what stands for null, null where a number is needed
 */

/**
 * The values of parameters in their order, null replaced by what stands for it; throws a ParameterError.
 * @param {Parameter[]} parameters @param {Object<string, unknown>} given by name @returns {Float64Array}
 */
export const valuesOf = (parameters, given) =>
  Float64Array.from(parameters, (one) => {
    const value = given[one.name] === undefined ? one.default : given[one.name];
    check(one, value);
    return /** @type {number} */ (value ?? one.absent);
  });

/** Throws a ParameterError for a value that is not a number within the bounds. @param {Parameter} parameter @param {unknown} value */
export function check({ name, unit, low, high, whole, absent = null }, value) {
  if (value === null && absent !== null) return;
  const refuse = (must) => {
    throw new ParameterError(`${name} must ${must}, received ${quoted(value)}`, { field: name, value });
  };
  if (typeof value !== "number") return refuse(unit ? `be a number (${unit})` : "be a number");
  if (!(value >= low && value <= high)) refuse(`lie in [${general(low)}, ${general(high)}]${unit ? ` ${unit}` : ""}`);
  if (whole && !Number.isInteger(value)) refuse("be a whole number");
}

/**
 * The error for a word that names nothing, with a code such as `unknown_predictor`.
 * @param {string} kind such as "predictor" or "parameter of hold" @param {string} field @param {unknown} word @param {string[]} known
 * @param {unknown} [value] what was received, if it is not the word
 */
export function unknown(kind, field, word, known, value = word) {
  const near = nearest(String(word), known);
  const hint = near === null ? "." : `; did you mean '${near}'?`;
  const message = `unknown ${kind} ${quoted(word)}${hint} Known: ${known.join(", ")}`;
  return new ParameterError(message, { code: `unknown_${kind.split(" ")[0]}`, field, value });
}
