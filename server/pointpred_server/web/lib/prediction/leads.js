// How long before it was needed something was proposed, over the newest movements.

import { claimed } from "./row.js";

const MOST = 1000;

/** The median; the mean of the two middle values if their number is even; NaN of no values. @param {number[]} values @returns {number} */
export function median(values) {
  if (values.length === 0) return NaN;
  const sorted = [...values].sort((one, other) => one - other),
    middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** The newest leads, s. */
export class Leads {
  #values = [];

  add(lead_s) {
    this.#values.push(lead_s);
    if (this.#values.length > MOST) this.#values.shift();
  }

  get median() {
    return claimed(median(this.#values));
  }

  /** The least, the median and the largest, and how many; null where there is none. */
  get summary() {
    const { length } = this.#values,
      of = (measure) => (length ? measure(...this.#values) : null);
    return { count: length, least: of(Math.min), median: this.median, most: of(Math.max) };
  }
}
