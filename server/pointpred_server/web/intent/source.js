// Where predictions come from: a predictor in the page, or a service.

import { isRefused } from "../prediction/row.js";

const SMALL = ["minimum-jerk", "switched-direction", "switched", "linear", "hold"]; // need little code and no coefficients

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

/** A predictor, which is loaded when it is first needed. Until then it predicts nothing. */
export class Source {
  /** Settles when predictions can come: the predictor is loaded, or the service has answered. @type {Promise<void>} */ ready;
  #loaded = null; #closed = false;

  /**
   * @param {string} predictor a name of the registry @param {string|undefined} service its address, if the service predicts
   * @param {(row: number[]) => void} onAnswer a prediction has come that `add` did not return, as a row
   */
  constructor(predictor, service, onAnswer) {
    this.ready = this.#load(predictor, service, onAnswer);
    this.ready.catch(reportError);
  }

  async #load(predictor, service, onAnswer) {
    const { open } = await (service !== undefined ? import("./service-source.js")
      : SMALL.includes(predictor) ? import("./small-source.js") : import("../prediction/build.js").then(inPage));
    const loaded = await open(predictor, service, onAnswer);
    if (this.#closed) return loaded.close();
    this.#loaded = loaded;
    return loaded.ready;
  }

  /** Uses one event. @param {number[]} row t, x, y, dx, dy, buttons @returns {number[]|null} the row of the prediction made at it, if there is one now */
  add(row) {
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
