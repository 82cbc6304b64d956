// What became of the service's proposals, counted in the page: how many, right in time, wrong, and how early.

import { median } from "../circle/geometry.js";
import { count, number } from "./elements.js";

/** Counts proposals over movements that end with a click on a target. */
export class Ledger {
  movements = 0; proposed = 0; hits = 0; wasted = 0;
  #leads = []; #made = []; #standing = null; #entered = new Map();

  /** @param {import("/pointpred.js").Choice} choice */
  take({ id, action, t, reason }) {
    if (reason === "entered") return; // no prediction
    if (action === "propose") this.#standing = { id, t };
    else if (this.#standing?.id === id) this.#standing = null;
    if (action === "propose") this.#made.push(id);
  }

  /** The id of the target that is predicted now. @returns {string|null} */
  get standing() {
    return this.#standing?.id ?? null;
  }

  /** The pointer went into a target; only the first time in a movement counts. @param {string} id @param {number} t s */
  enter(id, t) {
    if (!this.#entered.has(id)) this.#entered.set(id, this.#standing?.id === id ? t - this.#standing.t : null);
  }

  /**
   * The movement ended with a click. @param {string|null} id of the target; null: on none of them
   * @returns {number|null} by how much the target was proposed before the pointer was there, s; null where it was not
   */
  finish(id) {
    const lead = this.#entered.get(id) ?? null;
    if (id !== null) {
      this.add({ fired: this.#made.length, hit: lead !== null, wasted: this.#made.filter((one) => one !== id).length, lead_s: lead });
    }
    [this.#made, this.#entered] = [[], new Map()];
    return lead;
  }

  /** Adds a movement that the service itself counted. @param {{fired?: number|null, hit?: boolean|null, wasted?: number|null, lead_s?: number|null}} score */
  add({ fired, hit, wasted, lead_s: lead }) {
    if (fired == null) return;
    this.movements += 1;
    this.proposed += fired;
    this.hits += Number(hit);
    this.wasted += wasted;
    if (lead !== null) this.#leads.push(lead);
  }

  /** In words. */
  get words() {
    if (this.movements === 0) return "";
    const early = this.#leads.length ? `, ${number(1000 * median(this.#leads), 0, "ms")} early` : "";
    return `Proposed in time: ${this.hits} of ${count(this.movements, "movement")}${early}; ${this.wasted} of ${count(this.proposed, "proposal")} wrong.`;
  }
}
