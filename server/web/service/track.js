// One predictor followed live: its connection, its newest prediction, and how long answers take.

import { median } from "../circle/geometry.js";
import { token } from "./http.js";
import { connect } from "/pointpred.js";

const WORDS = {
  connecting: "Connecting…",
  open: "Connected.",
  waiting: "The service does not answer. Trying again…",
  idle: "Paused. Move to connect again.",
  refused: "The service refused the connection.",
  closed: "Not connected.",
};

/** What to say of a connection. */
export const words = (state) => WORDS[state] ?? state;

/** A connection to the service with one predictor. */
export class Track {
  /** @type {import("/pointpred.js").Prediction|null} */ latest = null;
  /** When `latest` came, on the page's clock, ms. */ at = -Infinity;
  /** Predictions received. */ received = 0;
  /** The newest error. @type {string|null} */ fault = null;
  #delays = [];

  /**
   * @param {string} predictor
   * @param {{state?: (state: string) => void, prediction?: (one: object) => void, score?: (one: object) => void,
   *   choice?: (one: object) => void, error?: (one: object) => void}} told
   */
  constructor(predictor, told = {}, options = {}) {
    this.predictor = predictor;
    this.connection = connect(undefined, { predictor, pointer: false, token, ...options });
    this.connection.on("prediction", (prediction) => {
      this.latest = prediction;
      this.at = performance.now();
      this.received += 1;
      this.#delays.push([this.at, this.connection.delayMs]);
      if (this.#delays.length > 4000) this.#delays.splice(0, 2000);
      told.prediction?.(prediction);
    });
    this.connection.on("state", (state) => {
      if (state === "open") this.fault = null;
      told.state?.(state);
    });
    this.connection.on("error", (error) => {
      this.fault = error.message;
      told.error?.(error);
    });
    for (const name of ["score", "choice"]) if (told[name]) this.connection.on(name, told[name]);
    told.state?.(this.connection.state);
  }

  /** The median delay of the last second, ms; NaN where nothing came. */
  delay() {
    const since = performance.now() - 1000;
    while (this.#delays.length && this.#delays[0][0] < since) this.#delays.shift();
    return median(this.#delays.map(([, ms]) => ms).filter((ms) => ms !== null));
  }

  /** Whose the newest prediction is: the service answers in order, so that a change holds from its welcome on. */
  get speaker() {
    return this.connection.welcome?.predictor ?? this.predictor;
  }

  /** Goes on with another predictor. */
  choose(predictor) {
    this.predictor = predictor;
    this.latest = null;
    this.connection.configure({ predictor });
  }

  /** Goes on with these parameters, and the others as they are usually. @param {Object<string, number>} parameters */
  configure(predictor, parameters) {
    this.connection.configure({ predictor, parameters });
  }

  close() {
    this.connection.close();
  }
}
