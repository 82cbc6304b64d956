// What can be set of a predictor, as `pointpred.registry.describe` gives it in Python.

import { DIFFERENTIATORS, GAINS, PREDICTORS } from "../../lib/laws/registry.js";
import { DIFFERENTIATORS as OF_DIFFERENTIATORS, PREDICTORS as OF_PREDICTORS } from "./descriptions.js";

/**
 * @typedef {{name: string, unit: string, low: number, high: number, default: number|null, meaning: string,
 *   of: "predictor"|"differentiator"}} Described a parameter; its bounds are closed
 */

/**
 * A predictor of the registry: the parameters are its own, then those of its differentiator. Only its modules are loaded.
 * @param {string} name @returns {Promise<{name: string, title: string, reference: string, differentiator: string, parameters: Described[]}>}
 */
export async function describe(name) {
  const { differentiator, preset = {}, load } = PREDICTORS[name],
    { title, reference, meanings } = OF_PREDICTORS[name];
  const [own, shared] = await Promise.all([load(), DIFFERENTIATORS[differentiator].load()]);
  const described =
    (of, words) =>
    ({ name: parameter, unit = "", low, high, default: initial }) => ({
      name: parameter,
      unit,
      low,
      high,
      default: preset[parameter] ?? GAINS[parameter] ?? initial,
      meaning: words[parameter],
      of,
    });
  const names = own.parameters.map((one) => one.name); // one value serves both where they have the same name
  const others = shared.parameters.filter((one) => !names.includes(one.name));
  const parameters = [
    ...own.parameters.map(described("predictor", meanings)),
    ...others.map(described("differentiator", OF_DIFFERENTIATORS[differentiator].meanings)),
  ];
  return { name, title, reference, differentiator, parameters };
}
