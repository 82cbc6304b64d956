// Where predictions come from: a predictor in the page, or a service.

const PATIENCE_MS = 2000; // of a page that is never idle

/**
 * A predictor that is not loaded yet.
 * @typedef {{name: string, service?: string, first?: Predictor, open: (onAnswer: (row: number[]) => void) => Promise<Opened>}} Predictor
 *   `service`: the address of the service that predicts; `first` predicts until this one is loaded, once the page is idle
 * @typedef {{add: (row: number[]) => number[]|null, flush: () => boolean, close: () => void, ready?: Promise<void>}} Opened
 *   `ready`: settles when its predictions can come, if that is later
 */

/** When the page has nothing else to do; some browsers do not tell. */
const idle = () =>
  new Promise((resolve) => (globalThis.requestIdleCallback ?? setTimeout)(resolve, { timeout: PATIENCE_MS }));

/**
 * A predictor, which is loaded when it is first needed. Until then it predicts nothing; but before one that is loaded when the page
 * is idle another one predicts, and goes on to the end of a movement.
 */
export class Source {
  /** Settles when this predictor's predictions can come: it is loaded, or the service has answered. @type {Promise<void>} */ ready;
  /** The name of the predictor that predicts now; null while none is loaded. @type {string|null} */ predictor = null;
  #loaded = null;
  #next = null;
  #closed = false;

  /**
   * @param {Predictor} predictor
   * @param {(row: number[]) => void} onAnswer a prediction has come that `add` did not return, as a row
   */
  constructor(predictor, onAnswer) {
    this.ready = predictor.first ? this.#loadBoth(predictor) : this.#load(predictor, onAnswer);
    this.ready.catch(reportError);
  }

  async #loadBoth(predictor) {
    await this.#load(predictor.first);
    await idle();
    if (!this.#closed) await this.#load(predictor);
  }

  async #load({ name, open }, onAnswer) {
    const loaded = await open(onAnswer);
    if (this.#closed) return loaded.close();
    this.#next = { loaded, predictor: name };
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
