// What developers ask of a page: what has fired, and a picture of what is predicted.

import { needDocument } from "../client/document.js";
import { ledger as theLedger } from "./registration.js";

/** What has fired so far: hits, unused firings and lead times. @returns {import("../index.d.ts").LedgerSummary} */
export const ledger = () => theLedger.summary();

/** Calls `listener` with each entry of the ledger from now on. @param {(entry: import("../index.d.ts").LedgerEntry) => void} listener @returns {() => void} stops it */
export const onLedger = (listener) => theLedger.subscribe(listener);

/** Shows developers what is predicted; loads its module first. @returns {Promise<() => void>} hides it */
export async function showOverlay() {
  needDocument("showOverlay");
  const overlay = await import("./overlay/overlay.js");
  return overlay.showOverlay();
}
