// Which elements a prefetch fires for, by the law of `pointpred/targets/prefetch.py`.

import { ARMED, ENTERED, FITTED, PREDICTED, step } from "../laws/targets/prefetch.js";

const SETTINGS = Float64Array.from(FITTED);
const NEVER = 1; // the highest threshold: fires at entry only

/** Knows of each element whether it has fired in this movement. */
export class PrefetchPolicy {
  #states = new WeakMap(); // by entry

  /**
   * The elements that fire now; called once a frame.
   * @param {Float64Array} memory of the cursor, `STATES` of the law @param {import("./entries.js").Entry[]} entries that are looked at
   * @param {Float64Array[]} table their rows @param {Float64Array} shares theirs, and that of none of them
   * @returns {import("./entries.js").Entry[]}
   */
  fire(memory, entries, table, shares) {
    const thresholds = Float64Array.from(entries, ({ prefetchFrom }) => Math.min(prefetchFrom, NEVER));
    const states = Float64Array.from(entries, (entry) => this.#states.get(entry) ?? ARMED);
    const count = step(memory, [table, thresholds, new Float64Array(entries.length), states], shares, SETTINGS);
    entries.forEach((entry, i) => this.#states.set(entry, states[i]));
    return count === 0 ? [] : entries.filter((_, i) => states[i] === PREDICTED || states[i] === ENTERED);
  }
}
