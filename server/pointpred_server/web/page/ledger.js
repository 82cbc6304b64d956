// Counts what became of the proposals: how many there were, how many were right or wrong, and how early.

import { count, median, number } from "./numbers.js";

/** Counts proposals over movements that end with a click on a target. */
export class Ledger {
  movements = 0; proposals = 0; hits = 0; wasted = 0;
  #leads = []; #proposedIds = []; #current = null; #entries = new Map();

  /** @param {import("../pointpred.js").Choice} choice */
  addChoice({ id, action, t, reason }) {
    if (reason === "entered") return; // not a prediction
    if (action === "propose") this.#current = { id, t };
    else if (this.#current?.id === id) this.#current = null;
    if (action === "propose") this.#proposedIds.push(id);
  }

  /** The id of the target that is predicted now. @returns {string|null} */
  get proposed() {
    return this.#current?.id ?? null;
  }

  /** The pointer has entered a target; only the first time in a movement counts. @param {string} id @param {number} t s */
  enter(id, t) {
    if (!this.#entries.has(id)) this.#entries.set(id, this.#current?.id === id ? t - this.#current.t : null);
  }

  /**
   * The movement has ended with a click. @param {string|null} id of the target; null: no target
   * @returns {number|null} how long before the pointer entered the target it was proposed, s; null if it was not
   */
  endMovement(id) {
    const lead = this.#entries.get(id) ?? null;
    if (id !== null) {
      this.addScore({ fired: this.#proposedIds.length, hit: lead !== null, wasted: this.#proposedIds.filter((one) => one !== id).length, lead_s: lead });
    }
    [this.#proposedIds, this.#entries] = [[], new Map()];
    return lead;
  }

  /** Adds a scored movement. @param {{fired?: number|null, hit?: boolean|null, wasted?: number|null, lead_s?: number|null}} score */
  addScore({ fired, hit, wasted, lead_s: lead }) {
    if (fired == null) return;
    this.movements += 1;
    this.proposals += fired;
    this.hits += Number(hit);
    this.wasted += wasted;
    if (lead !== null) this.#leads.push(lead);
  }

  /** The counts as a sentence; empty before the first movement. */
  get summary() {
    if (this.movements === 0) return "";
    const early = this.#leads.length ? `, ${number(1000 * median(this.#leads), 0, "ms")} early` : "";
    return `Proposed in time: ${this.hits} of ${count(this.movements, "movement")}${early}; ${this.wasted} of ${count(this.proposals, "proposal")} wrong.`;
  }
}
