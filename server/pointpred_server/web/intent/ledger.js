// What has fired so far: hits, unused firings and lead times.

import { median } from "../prediction/median.js";
import { claimed } from "../prediction/row.js";
import { attempt } from "./attempt.js";

const MOST_LEADS = 1000; // the newest leads, of which the median is taken
const MOST_NAMES = 500; // names beyond are counted in the totals only

/** Counts of one name, or of all. */
class Counts {
  fired = 0; hit = 0; withheld = 0; withdrawn = 0; leads = [];

  addLead(lead_s) {
    this.hit += 1;
    this.leads.push(lead_s);
    if (this.leads.length > MOST_LEADS) this.leads.shift();
  }

  /** @returns {import("../index.d.ts").Counts} */
  summary() {
    const { fired, hit, withheld, withdrawn } = this;
    return { fired, hit, wasted: fired - hit, withheld, withdrawn, lead_s: quantiles(this.leads) };
  }
}

/** The ledger of the page. */
class Ledger {
  #all = new Counts(); #names = new Map(); #open = new WeakMap(); #listeners = new Set();

  /** @param {import("./registration.js").Registration} registration @param {import("../index.d.ts").Firing} firing */
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
      for (const counts of this.#countsOf(registration)) counts.addLead(lead_s);
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

/** The least, the median and the largest, and how many; null where there is none. */
function quantiles(values) {
  const { length } = values, of = (measure) => (length ? measure(...values) : null);
  return { count: length, least: of(Math.min), median: claimed(median(values)), most: of(Math.max) };
}

export const ledger = new Ledger();
