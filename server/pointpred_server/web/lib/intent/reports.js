// What has fired in this page, counted.

import { leadsOf } from "../prediction/leads.js";
import { ledger as theLedger } from "./registration.js";

const MOST_LEADS = 1000;
const MOST_NAMES = 500; // names beyond are counted in the totals only

/**
 * Counts of one name, or of all; `leads`: from firing to use, s, of the newest hits.
 * @typedef {{withheld: number, withdrawn: number, leads: number[], reasons: Object<string, {fired: number, hit: number}>}} Counted
 */

/** @returns {Counted} */
const nothing = () => ({ withheld: 0, withdrawn: 0, leads: [], reasons: {} });

const all = nothing();
/** @type {Map<string, Counted>} */
const names = new Map();
theLedger.countWith(count);

/** @param {import("../index.d.ts").LedgerEntry} entry */
function count({ kind, name, reason, lead_s }) {
  for (const counts of countsOf(name)) {
    if (kind === "withheld" || kind === "withdrawn") counts[kind] += 1;
    else (counts.reasons[reason] ??= { fired: 0, hit: 0 })[kind] += 1;
    if (lead_s === null) continue;
    counts.leads.push(lead_s);
    if (counts.leads.length > MOST_LEADS) counts.leads.shift();
  }
}

function countsOf(name) {
  if (name && !names.has(name) && names.size < MOST_NAMES) names.set(name, nothing());
  return name && names.has(name) ? [all, /** @type {Counted} */ (names.get(name))] : [all];
}

/** What has fired so far: hits, unused firings and lead times. @returns {import("../index.d.ts").LedgerSummary} */
export function ledger() {
  const byName = Object.fromEntries([...names].map(([name, counts]) => [name, summaryOf(counts)]));
  return { ...summaryOf(all), names: byName };
}

/** @param {Counted} counts @returns {import("../index.d.ts").Counts} */
function summaryOf({ withheld, withdrawn, leads, reasons }) {
  const by = {},
    total = { fired: 0, hit: 0, wasted: 0 };
  for (const [reason, { fired, hit }] of Object.entries(reasons)) {
    by[reason] = { fired, hit, wasted: fired - hit };
    for (const count in total) total[count] += by[reason][count];
  }
  return { ...total, withheld, withdrawn, lead_s: leadsOf(leads), reasons: by };
}

/** Calls `listener` with each entry of the ledger from now on. @param {(entry: import("../index.d.ts").LedgerEntry) => void} listener @returns {() => void} stops it */
export const onLedger = (listener) => theLedger.subscribe(listener);
