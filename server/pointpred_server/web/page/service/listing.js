// The predictors that can be chosen, and what can be set of each.

import { RECOMMENDED } from "../../lib/laws/registry.js";
import { describe } from "./description.js";
import { PREDICTORS } from "./descriptions.js";
import { read } from "./http.js";
import { inPage } from "./place.js";

/**
 * @typedef {{name: string, title: string, parameters?: import("./description.js").Described[]}} Listed
 * @typedef {{recommended: string, predictors: Listed[]}} Listing
 */

const OWN = {
  recommended: RECOMMENDED,
  predictors: Object.entries(PREDICTORS).map(([name, { title }]) => ({ name, title })),
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
