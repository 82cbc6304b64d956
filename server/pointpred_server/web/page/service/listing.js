// The predictors that can be chosen, and what can be set of each.

import { DIFFERENTIATORS, GAINS, PREDICTORS, RECOMMENDED } from "../../lib/laws/registry.js";
import { DIFFERENTIATORS as OF_DIFFERENTIATORS, PREDICTORS as OF_PREDICTORS } from "./descriptions.js";
import { inPage, read } from "./service.js";

/**
 * @typedef {{name: string, unit: string, low: number, high: number, default: number|null, meaning: string,
 *   of: "predictor"|"differentiator"}} Described a parameter; its bounds are closed
 * @typedef {{name: string, title: string, parameters?: Described[]}} Listed
 * @typedef {{recommended: string, predictors: Listed[]}} Listing
 */

const OWN = {
  recommended: RECOMMENDED,
  predictors: Object.entries(OF_PREDICTORS).map(([name, { title }]) => ({ name, title })),
};
/** @type {Promise<Listing>|null} */
let requested = null;

/** The predictors of the page, or those of the service where that predicts; these are requested once, and again after a failure. @returns {Promise<Listing>} */
export async function predictors() {
  if (inPage()) return OWN;
  return (requested ??= read("/v1/predictors")
    .then((answer) => ({ recommended: RECOMMENDED, ...answer }))
    .catch((error) => {
      requested = null;
      throw error;
    }));
}

/** A predictor with its parameters. @param {Listed} predictor @returns {Promise<Listed>} */
export const withParameters = async (predictor) => (predictor.parameters ? predictor : describe(predictor.name));

/**
 * A predictor of the registry, as `pointpred.registry.describe` gives it in Python: the parameters are its own, then those of its differentiator. Only its modules are loaded.
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
