// How long before it was needed something was proposed.

import { claimed } from "./row.js";

/** The median; the mean of the two middle values if their number is even; NaN of no values. @param {number[]} values @returns {number} */
export function median(values) {
  if (values.length === 0) return NaN;
  const sorted = [...values].sort((one, other) => one - other),
    middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** The least, the median and the largest of leads, s, and how many; null where there is none. @param {number[]} leads */
export function leadsOf(leads) {
  const of = (measure) => (leads.length ? measure(...leads) : null);
  return { count: leads.length, least: of(Math.min), median: claimed(median(leads)), most: of(Math.max) };
}
