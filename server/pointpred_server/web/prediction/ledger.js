// The outcome of each proposal: hit, wasted or retracted, and its lead time; as `pointpred/targets/ledger.py`.

import { median } from "./median.js";
import { claimed } from "./row.js";

const LATEST = 1000; // movements of which the lead is remembered, and targets of one movement

/**
 * @typedef {{proposed: number, hit: boolean, wasted: number, retracted: number, lead_entry_s: number|null,
 *   lead_click_s: number|null, entered: number}} Movement hit: when the cursor first entered the target (or clicked beside
 *   it), a proposal of it stood; wasted: proposals of other targets; leads in s; entered: targets proposed because the
 *   cursor had gone into them, in none of the other counts
 */

/** Counts proposals over movements; those of a movement without a known target count as wasted. */
export class Ledger {
  /** Counts of all movements. */ movements = 0; proposed = 0; right = 0; hits = 0; wasted = 0; retracted = 0; entered = 0;
  #leads = []; #made; #standing; #ended; #entries; #withdrawn; #atEntry;

  constructor() {
    this.drop();
  }

  /** Notes a proposal; it takes the place of one that stands. @param {number} t s @param {unknown} id */
  propose(t, id) {
    remember(this.#made, id, (this.#made.get(id) ?? 0) + 1);
    this.#standing = { id, t };
  }

  /** Notes that a target was proposed because the cursor had gone into it. */
  proposeEntered() {
    this.#atEntry += 1;
  }

  /** Notes that the proposal that stands was withdrawn; where it does not stand, nothing is noted. @param {unknown} id */
  retract(id) {
    if (this.#since(id) === null) return;
    this.#withdrawn += 1;
    this.#standing = null;
  }

  /** Notes that the proposal that stands ended with its movement, when the button came up: no retraction. @param {number} t s @param {unknown} id */
  end(t, id) {
    const since = this.#since(id);
    if (since !== null) [this.#standing, this.#ended] = [null, { t, id, since }];
  }

  /** Notes that the cursor went into a target; only the first time in a movement counts. @param {number} t s @param {unknown} id */
  enter(t, id) {
    if (!this.#entries.has(id)) remember(this.#entries, id, { t, since: this.#since(id) });
  }

  /** Closes the movement at its click. @param {number} t s @param {unknown} id of the target it was for, null: unknown @returns {Movement} */
  finish(t, id) {
    const made = [...this.#made.values()].reduce((sum, count) => sum + count, 0);
    const right = id === null ? 0 : this.#made.get(id) ?? 0;
    const { t: at, since } = id === null ? { t, since: null } : this.#entries.get(id) ?? { t, since: this.#until(t, id) };
    const leads = since === null ? [null, null] : [at - since, t - since];
    if (since !== null) this.#leads.push(leads);
    if (this.#leads.length > LATEST) this.#leads.shift();
    const done = { proposed: made, hit: since !== null, wasted: made - right, retracted: this.#withdrawn,
      lead_entry_s: leads[0], lead_click_s: leads[1], entered: this.#atEntry };
    this.movements += 1;
    this.right += right;
    this.hits += Number(done.hit);
    for (const name of ["proposed", "wasted", "retracted", "entered"]) this[name] += done[name];
    this.drop();
    return done;
  }

  /** Forgets the movement that goes on: it ended without a click. */
  drop() {
    [this.#made, this.#entries, this.#standing, this.#ended] = [new Map(), new Map(), null, null];
    [this.#withdrawn, this.#atEntry] = [0, 0];
  }

  /** The counts, with shares and the medians of the leads; null where there is nothing to count. */
  get summary() {
    const over = (count, all) => (all ? count / all : null);
    const { movements, proposed, right, hits, wasted, retracted, entered } = this;
    return { movements, proposed, right, hit: hits, wasted, retracted, entered, precision: over(right, proposed),
      coverage: over(hits, movements), proposals_a_movement: over(proposed, movements),
      median_lead_entry_s: claimed(median(this.#leads.map(([entry]) => entry))),
      median_lead_click_s: claimed(median(this.#leads.map(([, click]) => click))) };
  }

  #since(id) {
    return this.#standing !== null && this.#standing.id === id ? this.#standing.t : null;
  }

  /** Since when a target has been proposed, where its proposal stands or ended just now. */
  #until(t, id) {
    const ended = this.#ended;
    return ended !== null && ended.t === t && ended.id === id ? ended.since : this.#since(id);
  }
}

/** Notes a value, and forgets the oldest target where there are too many: ids are the caller's. */
function remember(noted, id, value) {
  noted.set(id, value);
  if (noted.size > LATEST) noted.delete(noted.keys().next().value);
}
