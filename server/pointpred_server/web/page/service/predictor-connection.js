// A connection with one predictor, in the page or at the service: its newest prediction, and how long answers take.

import { connect } from "../../lib/pointpred.js";
import { write } from "../shell/elements.js";
import { median } from "../shell/numbers.js";
import { inPage, token } from "./service.js";

const PAGE_TEXTS = {
  connecting: "Loading the predictor…",
  open: "Predicted in this page.",
  waiting: "The predictor could not be loaded. Trying again…",
  refused: "The predictor cannot be used.",
  closed: "Not predicting.",
};
const SERVICE_TEXTS = {
  connecting: "Connecting…",
  open: "Predicted by the service.",
  waiting: "The service does not answer. Trying again…",
  idle: "Paused. Move to connect again.",
  refused: "The service refused the connection.",
  closed: "Not connected.",
};
const MOST_DELAYS = 4000;

/**
 * @typedef {import("../../lib/index.d.ts").Messages} Messages
 * @typedef {Messages["prediction"] & {mixture?: import("../../lib/prediction/mixture.js").Mixture|null}} Prediction with what the
 *   page knows beyond one law
 * @typedef {{[Name in "state"|"prediction"|"score"|"choice"|"cursor"|"error"]?: (message: Messages[Name]) => void}} Handlers
 */

/** The state of a connection in words. */
export const stateText = (state) => (inPage() ? PAGE_TEXTS : SERVICE_TEXTS)[state] ?? state;

/** A connection with one predictor; the page sends the events. */
export class PredictorConnection {
  /** @type {Prediction|null} */ latest = null;
  /** When `latest` was received, on the page's clock, ms. */ at = -Infinity;
  /** The newest error. @type {string|null} */ error = null;
  #connection;
  #delays = [];

  /**
   * @param {string} predictor
   * @param {Handlers} handlers
   * @param {import("../../lib/index.d.ts").ConnectOptions} options
   */
  constructor(predictor, handlers = {}, options = {}) {
    this.predictor = predictor;
    this.#connection = connect(undefined, { predictor, pointer: false, token, page: inPage(), ...options });
    this.#connection.on("prediction", (prediction) => {
      this.latest = { ...prediction, mixture: this.#connection.mixture };
      this.at = performance.now();
      this.#delays.push([this.at, this.#connection.delayMs]);
      if (this.#delays.length > MOST_DELAYS) this.#delays.splice(0, MOST_DELAYS / 2);
      handlers.prediction?.(prediction);
    });
    this.#connection.on("state", (state) => {
      if (state === "open") this.error = null;
      handlers.state?.(state);
    });
    this.#connection.on("error", (error) => {
      this.error = error.message;
      handlers.error?.(error);
    });
    for (const name of ["score", "choice", "cursor"]) if (handlers[name]) this.#connection.on(name, handlers[name]);
    handlers.state?.(this.state);
  }

  get state() {
    return this.#connection.state;
  }

  /** The median delay of the last second, ms; NaN if there was no prediction. */
  delay() {
    const since = performance.now() - 1000;
    while (this.#delays.length && this.#delays[0][0] < since) this.#delays.shift();
    return median(this.#delays.map(([, ms]) => ms).filter((ms) => ms !== null));
  }

  /** The predictor of the newest prediction: answers come in order, so a change is in force from its welcome on. */
  get activePredictor() {
    return this.#connection.welcome?.predictor ?? this.predictor;
  }

  /** @param {import("../../lib/index.d.ts").EventRow[]} rows */
  send(rows) {
    this.#connection.send(rows);
  }

  /** @param {import("../../lib/index.d.ts").NamedTarget[]} list */
  setTargets(list) {
    this.#connection.targets(list);
  }

  /** @param {"start"|"end"} action @param {import("../../lib/index.d.ts").Goal} goal */
  trial(action, goal) {
    this.#connection.trial(action, goal);
  }

  /** Changes the predictor. */
  choose(predictor) {
    this.predictor = predictor;
    this.latest = null;
    this.#connection.configure({ predictor });
  }

  /** Changes parameters; the others have their defaults. @param {Object<string, number>} parameters */
  configure(predictor, parameters) {
    this.#connection.configure({ predictor, parameters });
  }

  /** @param {import("../../lib/index.d.ts").ConnectOptions["assist"]} assist */
  setAssistance(assist) {
    this.#connection.configure({ assist });
  }

  close() {
    this.#connection.close();
  }
}

/** The line that shows the state of a connection. */
export class ConnectionStatus {
  #line;

  /** @param {HTMLElement} line */
  constructor(line) {
    this.#line = line;
  }

  /** The state of the connection; empty if there is none. @returns {string} */
  get state() {
    return this.#line.dataset.state ?? "";
  }

  /**
   * @param {string|undefined} state of the connection, undefined if there is none
   * @param {{error?: string|null, disconnected?: string}} about the newest error; the text if there is no connection
   */
  show(state, { error, disconnected }) {
    this.#line.dataset.state = state ?? "";
    const text = state === undefined ? disconnected : stateText(state);
    if (text !== undefined) write(this.#line, error && state !== "open" ? `${text} ${error}` : text);
  }
}
