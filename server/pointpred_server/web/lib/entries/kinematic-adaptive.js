// Written by `make laws` from the registry: change that and run it again.
import { inPage } from "../intent/page-source.js";
import { prefetchLinkWith } from "../intent/prefetch-link.js";
import { onIntentWith, registerWith } from "../intent/register.js";
import { assemble } from "../prediction/assembly.js";
import { loadStages, REGISTRY } from "../laws/only/kinematic-adaptive.js";
import { loadStages as loadFirst } from "../laws/only/minimum-jerk.js";
import { smallFirst } from "../intent/small-first.js";
import { onPlaceWith } from "../intent/places.js";

const OFFER = { of: () => smallFirst(inPage("minimum-jerk", loadFirst), inPage("kinematic-adaptive", loadStages)) };
export const onIntent = /* @__PURE__ */ onIntentWith(OFFER);
export const register = /* @__PURE__ */ registerWith(OFFER);
export const prefetchLink = /* @__PURE__ */ prefetchLinkWith(onIntent);
export const build = (options) => assemble(REGISTRY, "kinematic-adaptive", options);
export { ledger, onLedger } from "../intent/reports.js";
export { showOverlay } from "../intent/overlay/overlay.js";
export const onPlace = /* @__PURE__ */ onPlaceWith(build);
