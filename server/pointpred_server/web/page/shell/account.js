// What became of proposals over movements, in a sentence.

import { count, median, number } from "./numbers.js";

/** Counts movements: how many were proposed in time, how early, and how many proposals were wrong. */
export class Account {
  #movements = 0;
  #proposed = 0;
  #wasted = 0;
  #leads = []; // s, of the movements that were proposed in time

  /** @param {{proposed: number, wasted: number, lead_entry_s: number|null}} movement */
  add({ proposed, wasted, lead_entry_s: lead }) {
    this.#movements += 1;
    this.#proposed += proposed;
    this.#wasted += wasted;
    if (lead !== null) this.#leads.push(lead);
  }

  /** Empty before the first movement. */
  get text() {
    if (this.#movements === 0) return "";
    const hits = this.#leads.length,
      early = hits ? `, ${number(1000 * median(this.#leads), 0, "ms")} early` : "";
    return `Proposed in time: ${hits} of ${count(this.#movements, "movement")}${early}; ${this.#wasted} of ${count(this.#proposed, "proposal")} wrong.`;
  }
}
