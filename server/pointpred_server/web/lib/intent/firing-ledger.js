// The ledger of what fired: the callbacks of registered elements, and which of these were used.

const MOST_LEADS = 1000;
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

/**
 * Counts of one name, or of all; `leads`: from firing to use, s, of the newest hits.
 * @returns {{withheld: number, withdrawn: number, leads: number[], reasons: Object<string, {fired: number, hit: number}>}}
 */
const nothing = () => ({ withheld: 0, withdrawn: 0, leads: [], reasons: {} });

/** Counts the firings of registered elements, and which of these were used. */
export class FiringLedger {
  all = nothing();
  /** @type {Map<string, ReturnType<typeof nothing>>} */ names = new Map();
  #open = new WeakMap();
  #listeners = new Set();

  /** @param {import("./registration.js").Registration} registration @param {import("../index.d.ts").Firing} firing */
  fire(registration, firing) {
    for (const counts of this.#countsOf(registration)) reasonOf(counts, firing).fired += 1;
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
        reasonOf(counts, firing).hit += 1;
        counts.leads.push(lead_s);
        if (counts.leads.length > MOST_LEADS) counts.leads.shift();
      }
      this.#tell("hit", registration, { ...firing, t, lead_s });
    }
  }

  /** Calls `listener` with each entry from now on. @param {(entry: import("../index.d.ts").LedgerEntry) => void} listener @returns {() => void} */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #countsOf({ name }) {
    if (!name) return [this.all];
    if (!this.names.has(name) && this.names.size < MOST_NAMES) this.names.set(name, nothing());
    return this.names.has(name) ? [this.all, this.names.get(name)] : [this.all];
  }

  #tell(kind, { element, name, options: { policy } }, { reason, p, score, threshold, t, lead_s = null }) {
    const entry = { kind, element, name, policy, reason, p, score, threshold, t, lead_s };
    for (const listener of this.#listeners) attempt(() => listener(entry));
  }
}

const reasonOf = ({ reasons }, { reason }) => (reasons[reason] ??= { fired: 0, hit: 0 });
