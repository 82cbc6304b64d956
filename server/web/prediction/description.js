// What can be set of a predictor, as `pointpred.registry.describe` gives it in Python.

import { DIFFERENTIATORS, GAINS, PREDICTORS } from "../laws/registry.js";

/**
 * @typedef {{name: string, unit: string, low: number, high: number, default: number|null, meaning: string,
 *   of: "predictor"|"differentiator"}} Described a parameter; its bounds are closed
 */

/**
 * A predictor of the registry: the parameters are its own, then those of its differentiator. Only its modules are loaded.
 * @param {string} name @returns {Promise<{name: string, title: string, reference: string, differentiator: string, parameters: Described[]}>}
 */
export async function describe(name) {
  const { title, reference, differentiator, preset, load } = PREDICTORS[name];
  const [own, shared] = await Promise.all([load(), DIFFERENTIATORS[differentiator].load()]);
  const described = (of) => ({ name: parameter, unit, low, high, default: initial, meaning }) =>
    ({ name: parameter, unit, low, high, default: preset[parameter] ?? GAINS[parameter] ?? initial, meaning, of });
  const names = own.parameters.map((one) => one.name); // one value serves both where they have the same name
  const others = shared.parameters.filter((one) => !names.includes(one.name));
  const parameters = [...own.parameters.map(described("predictor")), ...others.map(described("differentiator"))];
  return { name, title, reference, differentiator, parameters };
}
