// One registration of an element: whether it may fire now, and what it has begun by firing.

import { attempt, FiringLedger } from "./firing-ledger.js";

const MARKS = ["data-target", "data-predicted"]; // attributes for style sheets
const SLOW = /2g/; // connections too slow to load anything ahead

/**
 * The options of a registration, with their defaults.
 * @typedef {Required<Omit<import("../index.d.ts").IntentOptions, "hitSlop"|"onError"|"service">> & Pick<import("../index.d.ts").IntentOptions, "onError"|"service">
 *   & {hitSlop: Required<import("../index.d.ts").Sides>}} Options `predictor`: where there is a choice
 */

/** What has fired in this page. */
export const ledger = new FiringLedger();

/** Whether nothing shall be loaded ahead: `Save-Data`, a 2G connection, or the media feature `prefers-reduced-data`. */
function isReduced() {
  const { saveData, effectiveType = "" } =
    /** @type {{connection?: {saveData?: boolean, effectiveType?: string}} & Navigator} */ (navigator).connection ?? {};
  return saveData || SLOW.test(effectiveType) || matchMedia("(prefers-reduced-data: reduce)").matches;
}

/** An element, what is called for it, and the state of that. */
export class Registration {
  /** The newest firing, until it is withdrawn. @type {import("../index.d.ts").Firing|null} */ firing = null;
  #callback;
  #firedAt = -Infinity;
  #firedIn = -1;
  #withheld = false;
  #end = new AbortController();
  /** @type {(() => unknown)|null} */ #cleanup = null;
  #waiting = 0;

  /**
   * @param {Element} element @param {import("../index.d.ts").IntentCallback|null} callback @param {Options} options
   * @param {() => object} [subject] what its callback is for; a hit of one is a hit of all that have the same
   */
  constructor(element, callback, options, subject = () => element) {
    this.element = element;
    this.#callback = callback;
    this.options = options;
    this.subject = subject;
    this.about = { element: new WeakRef(element), name: options.name || element.id, policy: options.policy };
  }

  /** @param {"prefetch"|"highlight"} policy */
  follows(policy) {
    return this.#callback !== null && this.options.priority > 0 && this.options.policy === policy;
  }

  /**
   * Whether a firing is allowed now.
   * @param {number} t s @param {number} visit the number of the movement, the key press or the touch: one fires once in each
   */
  mayFire(t, visit) {
    const { policy, once, again_s, enabled } = this.options;
    if (this.#callback === null || this.firing?.policy === "highlight") return false;
    if (this.#withheld && isReduced()) return false;
    if (policy === "prefetch" && this.#firedIn === visit) return false;
    if (once && t - this.#firedAt < again_s) return false;
    /** @type {any} */
    const answer = typeof enabled === "function" ? attempt(() => enabled(this.element), this.#fail) : enabled;
    return answer && !answer.then; // a promise is no answer
  }

  /**
   * Calls the callback, unless data shall be saved.
   * @param {import("./tracker.js").Cause} cause @param {number} visit
   */
  fire(cause, visit) {
    const { policy, saveData } = this.options;
    this.#withheld = policy === "prefetch" && saveData === "respect" && isReduced();
    if (this.#withheld) return ledger.withhold(this, cause);
    this.#finish(); // what the firing before has begun
    const end = new AbortController();
    [this.#firedAt, this.#firedIn, this.#end, this.#cleanup] = [cause.t, visit, end, null];
    this.firing = { ...this.about, ...cause, element: this.element, signal: end.signal };
    this.#mark(cause.reason);
    ledger.fire(this, cause);
    const answer = attempt(() => this.#callback(this.firing), this.#fail);
    Promise.resolve(answer).then(
      (late) => this.#take(late, end),
      () => {}, // told already
    );
  }

  /** An entry fires when the pointer has stayed for a while, if it is asked to; anything else at once. @param {(t: number) => void} fire */
  afterDwell(reason, t, fire) {
    const { dwell_s } = this.options;
    if (reason !== "entered" || dwell_s === 0) return fire(t);
    this.cancel();
    this.#waiting = setTimeout(() => fire(t + dwell_s), 1000 * dwell_s);
  }

  /** The pointer has not stayed. */
  cancel() {
    clearTimeout(this.#waiting);
  }

  /** The firing no longer holds. @param {number} t s */
  withdraw(t) {
    this.cancel();
    if (this.firing === null) return;
    const { firing } = this;
    this.firing = null;
    ledger.withdraw(this, firing, t);
    this.#finish();
  }

  /** Nothing is called any more. */
  stop() {
    this.cancel();
    if (this.firing?.policy === "highlight") this.withdraw(performance.now() / 1000);
    else this.#finish();
    this.#callback = null;
  }

  /** An answer of the callback: what cleans up is called when its firing ends, or at once if it has. */
  #take(answer, end) {
    if (typeof answer !== "function") return;
    if (end.signal.aborted) attempt(answer, this.#fail);
    else if (end === this.#end) this.#cleanup = answer;
  }

  #finish() {
    this.#end.abort();
    if (this.options.attributes) for (const name of MARKS) this.element.removeAttribute(name);
    const cleanup = this.#cleanup;
    this.#cleanup = null;
    if (cleanup) attempt(cleanup, this.#fail);
  }

  #mark(reason) {
    if (!this.options.attributes) return;
    this.element.setAttribute(MARKS[0], reason);
    if (reason === "predicted") this.element.setAttribute(MARKS[1], "");
  }

  /** An error of the page's own function. */
  #fail = (error) => {
    const { onError } = this.options;
    if (error?.name === "AbortError") return; // something was ended on purpose
    if (onError) attempt(() => onError(error, this.firing));
    else reportError(error);
  };
}
