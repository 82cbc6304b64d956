/**
 * What the movement of a user is heading for, called before it gets there: mouse and pen, keyboard, touch and scroll.
 *
 *     import { onIntent } from "pointpred/intent";
 *     const stop = onIntent(document.querySelector("#cart"), () => import("./cart.js"));
 *
 * Everything runs in the page. Types and every option: `../index.d.ts`.
 */

export { onPlace } from "./places.js";
export { prefetchLink } from "./prefetch-link.js";
export { onIntent, register } from "./register.js";

import { ledger as theLedger } from "./registration.js";

/** What has fired so far: hits, unused firings and lead times. @returns {import("../index.d.ts").LedgerSummary} */
export const ledger = () => theLedger.summary();

/** Calls `listener` with each entry of the ledger from now on. @param {(entry: import("../index.d.ts").LedgerEntry) => void} listener @returns {() => void} stops it */
export const onLedger = (listener) => theLedger.subscribe(listener);

/** Shows developers what is predicted; loads its module first. @returns {Promise<() => void>} hides it */
export const showOverlay = async () => (await import("./overlay/overlay.js")).showOverlay();
