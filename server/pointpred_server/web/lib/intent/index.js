/**
 * What the movement of a user is heading for, called before it gets there: mouse and pen, keyboard, touch and scroll.
 *
 *     import { onIntent } from "pointpred/intent";
 *     const stop = onIntent(document.querySelector("#cart"), () => import("./cart.js"));
 *
 * Everything runs in the page. Types and every option: `../index.d.ts`. The predictor is chosen by an option among all of them;
 * each is loaded when it is needed.
 */

import { loadStages as loadFirst } from "../laws/only/minimum-jerk.js";
import { RECOMMENDED, REGISTRY } from "../laws/registry.js";
import { inPage } from "./page-source.js";
import { onPlaceWith } from "./places.js";
import { prefetchLinkWith } from "./prefetch-link.js";
import { onIntentWith, registerWith } from "./register.js";
import { smallFirst } from "./small-first.js";
import { usualStages } from "./usual-stages.js";

/** @type {import("./register.js").Offer} */
const OFFER = {
  defaults: { predictor: RECOMMENDED, service: undefined },
  choices: { predictor: Object.keys(REGISTRY.PREDICTORS) },
  of({ predictor, service }) {
    if (service !== undefined) return served(predictor, service);
    const chosen = inPage(predictor, () => usualStages(REGISTRY, predictor));
    return predictor === RECOMMENDED ? smallFirst(inPage("minimum-jerk", loadFirst), chosen) : chosen;
  },
};

/** @param {string} name @param {string} service @returns {import("./source.js").Predictor} */
const served = (name, service) => ({
  name,
  service,
  open: async (onAnswer) => (await import("./service-source.js")).open(name, service, onAnswer),
});

const build = async (options) => (await import("../prediction/build.js")).build(RECOMMENDED, options);

/** @type {typeof import("../index.d.ts").onIntent} */
export const onIntent = /* @__PURE__ */ onIntentWith(OFFER);
/** @type {typeof import("../index.d.ts").register} */
export const register = /* @__PURE__ */ registerWith(OFFER);
/** @type {typeof import("../index.d.ts").prefetchLink} */
export const prefetchLink = /* @__PURE__ */ prefetchLinkWith(onIntent);
/** @type {typeof import("../index.d.ts").onPlace} */
export const onPlace = /* @__PURE__ */ onPlaceWith(build);
export { ledger, onLedger } from "./reports.js";

/** Shows developers what is predicted; loads its module first. @returns {Promise<() => void>} hides it */
export const showOverlay = async () => (await import("./overlay/overlay.js")).showOverlay();
