// One registration of an element: whether it may fire now, and what it has begun by firing.

import { attempt, FiringLedger } from "./firing-ledger.js";

const SLOW = ["slow-2g", "2g"]; // connections too slow to load anything ahead

/** What has fired in this page. */
export const ledger = new FiringLedger();

/** Whether nothing shall be loaded ahead: `Save-Data`, a 2G connection, or the media feature `prefers-reduced-data`. */
function isReduced() {
  const { saveData = false, effectiveType = "" } = navigator.connection ?? {};
  return saveData || SLOW.includes(effectiveType) || matchMedia("(prefers-reduced-data: reduce)").matches;
}

/** An element, what is called for it, and the state of that. */
export class Registration {
  /** The newest firing, until it is withdrawn. @type {import("../index.d.ts").Firing|null} */ firing = null;
  #callback;
  #firedAt = -Infinity;
  #firedIn = -1;
  #withheld = false;
  #end = new AbortController();
  #cleanup = null;

  /** @param {Element} element @param {import("../index.d.ts").IntentCallback|null} callback @param {object} options with their defaults */
  constructor(element, callback, options) {
    [this.element, this.#callback, this.options] = [element, callback, options];
    this.name = options.name || element.id;
  }

  /** @param {"prefetch"|"highlight"} policy */
  follows(policy) {
    return this.#callback !== null && this.options.policy === policy;
  }

  /**
   * Whether a firing is allowed now.
   * @param {number} t s @param {number} visit the number of the movement, the key press or the touch: one fires once in each
   */
  mayFire(t, visit) {
    if (this.#callback === null || this.firing?.policy === "highlight") return false;
    if (this.#withheld && isReduced()) return false;
    if (this.options.policy === "prefetch" && this.#firedIn === visit) return false;
    return this.#firedAt === -Infinity || !this.options.once || t - this.#firedAt >= this.options.again_s;
  }

  /**
   * Calls the callback, unless data shall be saved.
   * @param {{reason: string, p: number, t: number, remaining_s: number|null}} cause @param {number} visit
   */
  fire(cause, visit) {
    const { policy, saveData } = this.options;
    this.#withheld = policy === "prefetch" && saveData === "respect" && isReduced();
    if (this.#withheld) return ledger.withhold(this, cause);
    [this.#firedAt, this.#firedIn, this.#end] = [cause.t, visit, new AbortController()];
    this.firing = { element: this.element, name: this.name, policy, ...cause, signal: this.#end.signal };
    ledger.fire(this, this.firing);
    const answer = attempt(() => this.#callback(this.firing));
    this.#cleanup = typeof answer === "function" ? answer : null;
  }

  /** The firing no longer holds. @param {number} t s */
  withdraw(t) {
    if (this.firing === null) return;
    const { firing } = this;
    this.firing = null;
    ledger.withdraw(this, firing, t);
    this.#finish();
  }

  /** Nothing is called any more. */
  stop() {
    if (this.firing?.policy === "highlight") this.withdraw(performance.now() / 1000);
    else this.#finish();
    this.#callback = null;
  }

  #finish() {
    this.#end.abort();
    const cleanup = this.#cleanup;
    this.#cleanup = null;
    if (cleanup) attempt(cleanup);
  }
}
