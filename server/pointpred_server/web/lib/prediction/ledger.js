// What became of proposals over movements: targets have numbers, and the account is that of the laws.

import * as law from "../laws/targets/ledger.js";
import { claimed } from "./row.js";

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

  constructor() {
    this.drop();
  }

  /** Closes the movement at its click. @param {number} t s @param {number} key the number of the target it was for, NOBODY: unknown @returns {Movement} */
  close(t, key) {
    const [proposed, wasted, retracted, entered, entry, click] = law.finish(this.account, this.#rows, t, key);
    const [lead_entry_s, lead_click_s] = [claimed(entry), claimed(click)];
    return { proposed, hit: lead_entry_s !== null, wasted, retracted, lead_entry_s, lead_click_s, entered };
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
}
