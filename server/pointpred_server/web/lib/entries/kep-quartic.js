// Written by `make laws` from the registry: change that and run it again.
import { inPage } from "../intent/page-source.js";
import { prefetchLinkWith } from "../intent/prefetch-link.js";
import { onIntentWith, registerWith } from "../intent/register.js";
import { assemble } from "../prediction/assembly.js";
import { loadStages, REGISTRY } from "../laws/only/kep-quartic.js";

const OFFER = { of: () => inPage("kep-quartic", loadStages) };
export const onIntent = /* @__PURE__ */ onIntentWith(OFFER);
export const register = /* @__PURE__ */ registerWith(OFFER);
export const prefetchLink = /* @__PURE__ */ prefetchLinkWith(onIntent);
export const build = (options) => assemble(REGISTRY, "kep-quartic", options);
export { ledger, onLedger } from "../intent/reports.js";
export { showOverlay } from "../intent/overlay/overlay.js";
