// The line that shows the state of a connection.

import { write } from "../shell/elements.js";
import { stateText } from "./predictor-connection.js";

/** One status line. */
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
