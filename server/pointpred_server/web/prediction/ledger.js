// The only ledgers of the page: what became of proposals over movements, and of callbacks that fired for elements.

import { NOBODY } from "../laws/targets/rectangles.js";
import * as law from "../laws/targets/ledger.js";
import { claimed } from "./row.js";

const MOST_NAMES = 500; // names beyond are counted in the totals only

/** The median; the mean of the two middle values if their number is even; NaN of no values. @param {number[]} values @returns {number} */
export function median(values) {
  if (values.length === 0) return NaN;
  const sorted = [...values].sort((one, other) => one - other), middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/** What the page's own function returns; its error is logged, and keeps nothing else from being called. */
export function attempt(call) {
  try {
    return call();
  } catch (error) {
    reportError(error);
    return undefined;
  }
}

/** The newest leads, s: how long before it was needed something was proposed. */
class Leads {
  #values = [];

  add(lead_s) {
    this.#values.push(lead_s);
    if (this.#values.length > law.LATEST) this.#values.shift();
  }

  get median() {
    return claimed(median(this.#values));
  }

  /** The least, the median and the largest, and how many; null where there is none. */
  get summary() {
    const { length } = this.#values, of = (measure) => (length ? measure(...this.#values) : null);
    return { count: length, least: of(Math.min), median: this.median, most: of(Math.max) };
  }
}

/**
 * @typedef {{proposed: number, hit: boolean, wasted: number, retracted: number, lead_entry_s: number|null,
 *   lead_click_s: number|null, entered: number}} Movement hit: when the cursor first entered the target (or clicked beside
 *   it), a proposal of it stood; wasted: proposals of other targets; leads in s; entered: targets proposed because the
 *   cursor had gone into them, in none of the other counts
 */

/** Counts proposals over movements; those of a movement without a known target count as wasted. */
export class Ledger {
  /** Counts of all movements. */ movements = 0; proposed = 0; right = 0; hits = 0; wasted = 0; retracted = 0; entered = 0;
  #movement = new Float64Array(law.STATES); #rows = []; #places = new Map(); #entryLeads = new Leads(); #clickLeads = new Leads();

  constructor() {
    this.drop();
  }

  /** Notes a proposal; it takes the place of one that stands. @param {number} t s @param {unknown} id */
  propose(t, id) {
    const place = this.#rowOf(id);
    law.propose(this.#movement, this.#rows, t, place);
  }

  /** Notes that a target was proposed because the cursor had gone into it. */
  proposeEntered() {
    this.#movement[law.ENTERED] += 1;
  }

  /**
   * Notes that the proposal that stands ended; where it does not stand, nothing is noted.
   * @param {number} t s @param {unknown} id @param {boolean} [released] with its movement, when the button came up: no retraction
   */
  withdraw(t, id, released = false) {
    law.withdraw(this.#movement, t, this.#places.get(id) ?? NOBODY, released);
  }

  /** Notes that the cursor went into a target; only the first time in a movement counts. @param {number} t s @param {unknown} id */
  enter(t, id) {
    const place = this.#rowOf(id);
    law.enter(this.#movement, this.#rows, t, place);
  }

  /** Closes the movement at its click. @param {number} t s @param {unknown} id of the target it was for, null: unknown @returns {Movement} */
  finish(t, id) {
    const place = id === null ? NOBODY : this.#places.get(id) ?? NOBODY;
    const [right, ...leads] = law.close(this.#movement, this.#rows, t, place);
    const proposed = this.#movement[law.PROPOSED], [lead_entry_s, lead_click_s] = leads.map(claimed);
    const done = { proposed, hit: lead_click_s !== null, wasted: proposed - right, retracted: this.#movement[law.RETRACTED],
      lead_entry_s, lead_click_s, entered: this.#movement[law.ENTERED] };
    this.add(done);
    this.drop();
    return done;
  }

  /** Adds a movement that somebody else has judged. @param {Partial<Movement>} movement at least `proposed`, `hit`, `wasted` and `lead_entry_s` */
  add({ proposed, hit, wasted, retracted = 0, lead_entry_s, lead_click_s = null, entered = 0 }) {
    this.movements += 1;
    this.proposed += proposed;
    this.right += proposed - wasted;
    this.hits += Number(hit);
    this.wasted += wasted;
    this.retracted += retracted;
    this.entered += entered;
    if (lead_entry_s !== null) this.#entryLeads.add(lead_entry_s);
    if (lead_click_s !== null) this.#clickLeads.add(lead_click_s);
  }

  /** Forgets the movement that goes on: it ended without a click. */
  drop() {
    [this.#rows, this.#places] = [[], new Map()];
    law.begin(this.#movement, this.#rows);
  }

  /** The counts, with shares and the medians of the leads; null where there is nothing to count. */
  get summary() {
    const over = (count, all) => (all ? count / all : null);
    const { movements, proposed, right, hits, wasted, retracted, entered } = this;
    return { movements, proposed, right, hit: hits, wasted, retracted, entered, precision: over(right, proposed),
      coverage: over(hits, movements), proposals_a_movement: over(proposed, movements),
      median_lead_entry_s: this.#entryLeads.median, median_lead_click_s: this.#clickLeads.median };
  }

  /** The row of a target, a new one where it has none; NOBODY beyond the most of one movement: ids are the caller's. */
  #rowOf(id) {
    const place = this.#places.get(id) ?? NOBODY;
    if (place !== NOBODY || this.#rows.length === law.LATEST) return place;
    this.#places.set(id, this.#rows.length);
    return this.#rows.push(Float64Array.of(0, NaN, NaN)) - 1;
  }
}

/** Counts of one name, or of all. */
class Counts {
  fired = 0; hit = 0; withheld = 0; withdrawn = 0; leads = new Leads();

  /** @returns {import("../index.d.ts").Counts} */
  summary() {
    const { fired, hit, withheld, withdrawn } = this;
    return { fired, hit, wasted: fired - hit, withheld, withdrawn, lead_s: this.leads.summary };
  }
}

/** Counts the firings of registered elements, and which of these were used. */
export class FiringLedger {
  #all = new Counts(); #names = new Map(); #open = new WeakMap(); #listeners = new Set();

  /** @param {import("../intent/registration.js").Registration} registration @param {import("../index.d.ts").Firing} firing */
  fire(registration, firing) {
    for (const counts of this.#countsOf(registration)) counts.fired += 1;
    const { element } = registration;
    this.#open.set(element, (this.#open.get(element) ?? new Map()).set(registration, firing));
    this.#tell("fired", registration, firing);
  }

  /** A firing that is not made, to save data. */
  withhold(registration, cause) {
    for (const counts of this.#countsOf(registration)) counts.withheld += 1;
    this.#tell("withheld", registration, cause);
  }

  /** A highlight has ended; whether the element was activated meanwhile is already counted. */
  withdraw(registration, firing, t) {
    for (const counts of this.#countsOf(registration)) counts.withdrawn += 1;
    this.#open.get(registration.element)?.delete(registration);
    this.#tell("withdrawn", registration, { ...firing, t });
  }

  /** The user activates an element, by a click or a key. @param {Element} element @param {number} t s */
  activate(element, t) {
    const open = this.#open.get(element);
    this.#open.delete(element);
    for (const [registration, firing] of open ?? []) {
      const lead_s = Math.max(0, t - firing.t);
      for (const counts of this.#countsOf(registration)) {
        counts.hit += 1;
        counts.leads.add(lead_s);
      }
      this.#tell("hit", registration, { ...firing, t, lead_s });
    }
  }

  /** Calls `listener` with each entry from now on. @param {(entry: import("../index.d.ts").LedgerEntry) => void} listener @returns {() => void} */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** @returns {import("../index.d.ts").LedgerSummary} */
  summary() {
    const names = Object.fromEntries([...this.#names].map(([name, counts]) => [name, counts.summary()]));
    return { ...this.#all.summary(), names };
  }

  #countsOf({ name }) {
    if (!name) return [this.#all];
    if (!this.#names.has(name) && this.#names.size < MOST_NAMES) this.#names.set(name, new Counts());
    return this.#names.has(name) ? [this.#all, this.#names.get(name)] : [this.#all];
  }

  #tell(kind, { element, name, options: { policy } }, { reason, p, t, lead_s = null }) {
    for (const listener of this.#listeners) attempt(() => listener({ kind, element, name, policy, reason, p, t, lead_s }));
  }
}
