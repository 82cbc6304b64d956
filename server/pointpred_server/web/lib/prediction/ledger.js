// What became of proposals over movements: targets have numbers, and the account is that of the laws.

import * as law from "../laws/targets/ledger.js";
import { NOBODY } from "../laws/targets/rectangles.js";
import { keyOf } from "./blake2b.js";
import { Leads } from "./leads.js";
import { claimed } from "./row.js";

/** Where the account begins. */
const TOTALS = /** @type {const} */ (["movements", "proposed", "right", "hits", "wasted", "retracted", "entered"]);

/**
 * @typedef {{proposed: number, hit: boolean, wasted: number, retracted: number, lead_entry_s: number|null,
 *   lead_click_s: number|null, entered: number}} Movement hit: when the cursor first entered the target (or clicked beside
 *   it), a proposal of it stood; wasted: proposals of other targets; leads in s; entered: targets proposed because the
 *   cursor had gone into them, in none of the other counts
 */

/** Counts proposals over movements; those of a movement without a known target count as wasted. */
export class Ledger {
  account = new Float64Array(law.STATES);
  #rows = [];
  #entryLeads = new Leads();
  #clickLeads = new Leads();

  constructor() {
    this.drop();
  }

  /** Notes a proposal; it takes the place of one that stands. @param {number} t s @param {unknown} id */
  propose(t, id) {
    law.note_proposal(this.account, this.withRoom(1), t, keyOf(String(id)));
  }

  /**
   * Notes that the proposal that stands ended; where it does not stand, nothing is noted.
   * @param {number} t s @param {unknown} id @param {boolean} [released] with its movement, when the button came up: no retraction
   */
  withdraw(t, id, released = false) {
    law.note_end(this.account, this.#rows, t, keyOf(String(id)), released);
  }

  /** Notes that the cursor went into a target; only the first time in a movement counts. @param {number} t s @param {unknown} id */
  enter(t, id) {
    law.note_entry(this.account, this.withRoom(1), t, keyOf(String(id)));
  }

  /** Closes the movement at its click. @param {number} t s @param {unknown} id of the target it was for, null: unknown @returns {Movement} */
  finish(t, id) {
    return this.close(t, id === null ? NOBODY : keyOf(String(id)));
  }

  /** `finish` for the number of a target, NOBODY for none. @param {number} t s @param {number} key @returns {Movement} */
  close(t, key) {
    const [proposed, wasted, retracted, entered, entry, click] = law.finish(this.account, this.#rows, t, key);
    const [lead_entry_s, lead_click_s] = [claimed(entry), claimed(click)];
    this.#lead(lead_entry_s, lead_click_s);
    return { proposed, hit: lead_entry_s !== null, wasted, retracted, lead_entry_s, lead_click_s, entered };
  }

  /** Adds a movement that a service has judged. @param {{proposed: number, hit: boolean, wasted: number, lead_entry_s: number|null}} movement */
  add({ proposed, hit, wasted, lead_entry_s }) {
    law.add(this.account, [proposed, Number(hit), wasted, 0, 0]);
    this.#lead(lead_entry_s, null);
  }

  /** Forgets the movement that goes on: it ended without a click. */
  drop() {
    law.drop(this.account);
  }

  /** The rows of the account, with room for so many more targets of this movement. @param {number} count */
  withRoom(count) {
    const needed = Math.min(/** @type {number} */ (this.account.at(-1)) + count, law.LATEST); // ids are the caller's
    while (this.#rows.length < needed) this.#rows.push(new Float64Array(law.FIELDS));
    return this.#rows;
  }

  /** The counts, with shares and the medians of the leads; null where there is nothing to count. */
  get summary() {
    const { hits: hit, ...counts } = /** @type {Record<typeof TOTALS[number], number>} */ (
      Object.fromEntries(TOTALS.map((name, i) => [name, this.account[i]]))
    );
    const { movements, proposed, right } = counts,
      over = (part, all) => (all ? part / all : null);
    return {
      ...counts,
      hit,
      precision: over(right, proposed),
      coverage: over(hit, movements),
      proposals_a_movement: over(proposed, movements),
      median_lead_entry_s: this.#entryLeads.median,
      median_lead_click_s: this.#clickLeads.median,
    };
  }

  #lead(entry_s, click_s) {
    if (entry_s !== null) this.#entryLeads.add(entry_s);
    if (click_s !== null) this.#clickLeads.add(click_s);
  }
}
