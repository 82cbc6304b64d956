// Where predictions come from: a predictor in the page, or a service.

/**
 * A predictor that is not loaded yet.
 * @typedef {{name: string, service?: string, open: (onAnswer: (row: number[]) => void) => Promise<Opened>}} Predictor
 *   `service`: the address of the service that predicts
 * @typedef {{name: string, open: () => Promise<Opened>}} InPage a predictor that answers to each event at once
 * @typedef {{add: (row: number[], begins: boolean) => number[]|null, flush: () => boolean, close: () => void, ready?: Promise<void>}} Opened
 *   `ready`: settles when its predictions can come, if that is later
 */

/** A predictor, which is loaded when it is first needed. Until then it predicts nothing. */
export class Source {
  /** Settles when predictions can come: the predictor is loaded, or the service has answered. @type {Promise<void>} */ ready;
  /** The predictor, null until it is loaded. @type {Opened|null} */ opened = null;
  #closed = false;

  /**
   * @param {Predictor} predictor
   * @param {(row: number[]) => void} onAnswer a prediction has come that `add` did not return, as a row
   */
  constructor(predictor, onAnswer) {
    this.ready = this.#open(predictor, onAnswer);
    this.ready.catch(reportError);
  }

  async #open(predictor, onAnswer) {
    const opened = await predictor.open(onAnswer);
    if (this.#closed) return opened.close();
    this.opened = opened;
    return opened.ready;
  }

  /**
   * Uses one event.
   * @param {number[]} row t, x, y, dx, dy, buttons @param {boolean} begins whether a movement begins with it
   * @returns {number[]|null} the row of the prediction made at it, if there is one now
   */
  add(row, begins) {
    return this.opened?.add(row, begins) ?? null;
  }

  /** The events of a dispatch are complete. @returns {boolean} whether `onAnswer` will be called with their prediction */
  flush() {
    return this.opened?.flush() ?? false;
  }

  /** Ends it for good. */
  close() {
    this.#closed = true;
    this.opened?.close();
  }
}
