// The ledger of what fired: the callbacks of registered elements, and which of these were used.

/**
 * @typedef {import("./registration.js").Registration} Registration
 * @typedef {import("./tracker.js").Cause} Cause
 * @typedef {import("../index.d.ts").LedgerEntry} LedgerEntry
 * @typedef {{element: WeakRef<Element>} & Pick<LedgerEntry, "name"|"policy">} About what stays of a registration that has
 *   stopped; an element is not held
 */

const MOST_KEPT = 1000;

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

/** Whether an error only says that something was ended on purpose, such as by the signal of a firing. @param {any} error */
export const isAbort = (error) => error?.name === "AbortError";

/** Tells of the firings of registered elements, and which of these were used. */
export class FiringLedger {
  /** Firings that are not used yet, by what they are for. @type {WeakMap<object, Map<About, Cause>>} */
  #open = new WeakMap();
  #listeners = new Set();
  #count = (entry) => this.#keep(entry);
  #kept = [];

  /** @param {Registration} registration @param {Cause} cause */
  fire(registration, cause) {
    const subject = registration.subject();
    this.#open.set(subject, (this.#open.get(subject) ?? new Map()).set(registration.about, cause));
    this.#tell("fired", registration.about, cause);
  }

  /** A firing that is not made, to save data. @param {Registration} registration @param {Cause} cause */
  withhold(registration, cause) {
    this.#tell("withheld", registration.about, cause);
  }

  /** A highlight has ended; whether the element was activated meanwhile is already told. @param {Registration} registration @param {Cause} cause @param {number} t s */
  withdraw(registration, cause, t) {
    this.#open.get(registration.subject())?.delete(registration.about);
    this.#tell("withdrawn", registration.about, { ...cause, t });
  }

  /** The user activates the element of a registration, by a click or a key. @param {Registration} activated @param {number} t s */
  activate(activated, t) {
    const subject = activated.subject(),
      open = this.#open.get(subject);
    this.#open.delete(subject);
    for (const [about, cause] of open ?? [])
      this.#tell("hit", about, { ...cause, t, lead_s: Math.max(0, t - cause.t) });
  }

  /** Calls `listener` with each entry from now on. @param {(entry: LedgerEntry) => void} listener @returns {() => void} */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Calls `count` with each entry, first with those that were kept for it. @param {(entry: LedgerEntry) => void} count */
  countWith(count) {
    this.#count = count;
    this.#kept.splice(0).forEach(count);
  }

  /** What nothing counts yet. */
  #keep(entry) {
    if (this.#kept.push({ ...entry, element: null }) > MOST_KEPT) this.#kept.shift();
  }

  /** @param {LedgerEntry["kind"]} kind @param {About} about @param {Cause & {lead_s?: number|null}} cause */
  #tell(kind, about, { reason, p, score, threshold, t, lead_s = null }) {
    const element = about.element.deref() ?? null,
      entry = { kind, ...about, element, reason, p, score, threshold, t, lead_s };
    this.#count(entry);
    for (const listener of this.#listeners) attempt(() => listener(entry));
  }
}
