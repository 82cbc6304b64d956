// The ledger of what fired: the callbacks of registered elements, and which of these were used.

import { Leads } from "../prediction/leads.js";

const MOST_NAMES = 500; // names beyond are counted in the totals only

/** What the page's own function returns; its error is logged, and keeps nothing else from being called. */
export function attempt(call) {
  try {
    return call();
  } catch (error) {
    reportError(error);
    return undefined;
  }
}

/** Counts of one name, or of all. */
class Counts {
  fired = 0;
  hit = 0;
  withheld = 0;
  withdrawn = 0;
  leads = new Leads();

  /** @returns {import("../index.d.ts").Counts} */
  summary() {
    const { fired, hit, withheld, withdrawn } = this;
    return { fired, hit, wasted: fired - hit, withheld, withdrawn, lead_s: this.leads.summary };
  }
}

/** Counts the firings of registered elements, and which of these were used. */
export class FiringLedger {
  #all = new Counts();
  #names = new Map();
  #open = new WeakMap();
  #listeners = new Set();

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
    for (const listener of this.#listeners)
      attempt(() => listener({ kind, element, name, policy, reason, p, t, lead_s }));
  }
}
