// What has fired in this page.

import { leadsOf } from "../prediction/leads.js";
import { ledger as theLedger } from "./registration.js";

/** What has fired so far: hits, unused firings and lead times. @returns {import("../index.d.ts").LedgerSummary} */
export function ledger() {
  const names = Object.fromEntries([...theLedger.names].map(([name, counts]) => [name, summaryOf(counts)]));
  return { ...summaryOf(theLedger.all), names };
}

/** @returns {import("../index.d.ts").Counts} */
function summaryOf({ withheld, withdrawn, leads, reasons }) {
  const by = {},
    all = { fired: 0, hit: 0, wasted: 0 };
  for (const [reason, { fired, hit }] of Object.entries(reasons)) {
    by[reason] = { fired, hit, wasted: fired - hit };
    for (const count in all) all[count] += by[reason][count];
  }
  return { ...all, withheld, withdrawn, lead_s: leadsOf(leads), reasons: by };
}

/** Calls `listener` with each entry of the ledger from now on. @param {(entry: import("../index.d.ts").LedgerEntry) => void} listener @returns {() => void} stops it */
export const onLedger = (listener) => theLedger.subscribe(listener);
