// The ledger of what fired: the callbacks of registered elements, and which of these were used.

import { Leads } from "../prediction/leads.js";

const MOST_NAMES = 500; // names beyond are counted in the totals only

/**
 * What the page's own function returns. Its error, also of a promise that it returns, is logged unless something else takes
 * it, and keeps nothing else from being called.
 */
export function attempt(call, onError = reportError) {
  try {
    const answer = call();
    if (typeof answer?.then === "function") answer.then(undefined, onError);
    return answer;
  } catch (error) {
    onError(error);
    return undefined;
  }
}

/** Counts of one name, or of all. */
class Counts {
  withheld = 0;
  withdrawn = 0;
  leads = new Leads();
  #reasons = {};

  /** @param {string} reason @param {"fired"|"hit"} what */
  add(reason, what) {
    this.#reasons[reason] ??= { fired: 0, hit: 0 };
    this.#reasons[reason][what] += 1;
  }

  /** @returns {import("../index.d.ts").Counts} */
  summary() {
    const { withheld, withdrawn } = this,
      reasons = {},
      all = { fired: 0, hit: 0, wasted: 0 };
    for (const [reason, { fired, hit }] of Object.entries(this.#reasons)) {
      reasons[reason] = { fired, hit, wasted: fired - hit };
      for (const what in all) all[what] += reasons[reason][what];
    }
    return { ...all, withheld, withdrawn, lead_s: this.leads.summary, reasons };
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
    for (const counts of this.#countsOf(registration)) counts.add(firing.reason, "fired");
    const subject = registration.subject();
    this.#open.set(subject, (this.#open.get(subject) ?? new Map()).set(registration, firing));
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
    this.#open.get(registration.subject())?.delete(registration);
    this.#tell("withdrawn", registration, { ...firing, t });
  }

  /** The user activates the element of a registration, by a click or a key. @param {number} t s */
  activate(activated, t) {
    const subject = activated.subject(),
      open = this.#open.get(subject);
    this.#open.delete(subject);
    for (const [registration, firing] of open ?? []) {
      const lead_s = Math.max(0, t - firing.t);
      for (const counts of this.#countsOf(registration)) {
        counts.add(firing.reason, "hit");
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

  #tell(kind, { element, name, options: { policy } }, { reason, p, score, threshold, t, lead_s = null }) {
    const entry = { kind, element, name, policy, reason, p, score, threshold, t, lead_s };
    for (const listener of this.#listeners) attempt(() => listener(entry));
  }
}
