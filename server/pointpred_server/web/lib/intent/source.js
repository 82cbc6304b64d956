// Where predictions come from: a predictor in the page, or a service.

import { RECOMMENDED } from "../laws/registry.js";
import { isRefused } from "../prediction/row.js";

const SMALL = ["minimum-jerk", "switched-direction", "switched", "linear", "hold"]; // need little code and no coefficients
const FIRST = SMALL[0]; // predicts until the recommended one is loaded
const PATIENCE_MS = 2000; // of a page that is never idle

/** What opens any predictor of the registry; it rejects for any other. */
const inPage = ({ build }) => ({
  async open(predictor) {
    const pipeline = await build(predictor);
    const add = (row) => {
      const answer = pipeline.advance(row);
      return isRefused(answer) ? null : answer;
    };
    return { add, flush: () => false, close() {} };
  },
});

/** When the page has nothing else to do; some browsers do not tell. */
const idle = () =>
  new Promise((resolve) => (globalThis.requestIdleCallback ?? setTimeout)(resolve, { timeout: PATIENCE_MS }));

/**
 * A predictor, which is loaded when it is first needed. Until then it predicts nothing; but before the recommended one, which is
 * loaded once the page is idle, a small one predicts, and goes on to the end of a movement.
 */
export class Source {
  /** Settles when this predictor's predictions can come: it is loaded, or the service has answered. @type {Promise<void>} */ ready;
  /** The name of the predictor that predicts now; null while none is loaded. @type {string|null} */ predictor = null;
  #loaded = null;
  #next = null;
  #closed = false;

  /**
   * @param {string} predictor a name of the registry @param {string|undefined} service its address, if the service predicts
   * @param {(row: number[]) => void} onAnswer a prediction has come that `add` did not return, as a row
   */
  constructor(predictor, service, onAnswer) {
    this.ready =
      predictor === RECOMMENDED && service === undefined ? this.#loadBoth() : this.#load(predictor, service, onAnswer);
    this.ready.catch(reportError);
  }

  async #loadBoth() {
    await this.#load(FIRST);
    await idle();
    if (!this.#closed) await this.#load(RECOMMENDED);
  }

  async #load(predictor, service, onAnswer) {
    const { open } = await (service !== undefined
      ? import("./service-source.js")
      : SMALL.includes(predictor)
        ? import("./small-source.js")
        : import("../prediction/build.js").then(inPage));
    const loaded = await open(predictor, service, onAnswer);
    if (this.#closed) return loaded.close();
    this.#next = { loaded, predictor };
    if (this.#loaded === null) this.#goOver();
    return loaded.ready;
  }

  #goOver() {
    this.#loaded?.close();
    ({ loaded: this.#loaded, predictor: this.predictor } = this.#next);
    this.#next = null;
  }

  /**
   * Uses one event.
   * @param {number[]} row t, x, y, dx, dy, buttons @param {boolean} begins whether a movement begins with it: only then another predictor
   *   takes over
   * @returns {number[]|null} the row of the prediction made at it, if there is one now
   */
  add(row, begins) {
    if (begins && this.#next !== null) this.#goOver();
    return this.#loaded?.add(row) ?? null;
  }

  /** The events of a dispatch are complete. @returns {boolean} whether `onAnswer` will be called with their prediction */
  flush() {
    return this.#loaded?.flush() ?? false;
  }

  /** Ends it for good. */
  close() {
    this.#closed = true;
    this.#loaded?.close();
  }
}
