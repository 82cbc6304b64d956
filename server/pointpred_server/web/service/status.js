// The line that shows the state of a connection, and what the service still compiles before it can answer.

import { write } from "../page/elements.js";
import { compilingProgress, onCompiling, pollCompiling } from "./compiling.js";
import { inPage } from "./place.js";
import { stateText } from "./predictor-connection.js";

/** One status line; it is updated while the service compiles. */
export class ConnectionStatus {
  #line; #shown = {};

  /** @param {HTMLElement} line */
  constructor(line) {
    this.#line = line;
    onCompiling(() => this.#write());
  }

  /** The state of the connection; empty if there is none. @returns {string} */
  get state() {
    return this.#line.dataset.state ?? "";
  }

  /**
   * @param {string|undefined} state of the connection, undefined if there is none
   * @param {{predictor: string, error?: string|null, disconnected?: string}} about the newest error; the text if there is no connection
   */
  show(state, about) {
    this.#shown = { state, ...about };
    this.#line.dataset.state = state ?? "";
    if (state === "connecting" && !inPage()) pollCompiling();
    this.#write();
  }

  #write() {
    const { state, predictor, error, disconnected } = this.#shown;
    const compiling = state === "connecting" || state === "open" ? compilingProgress(predictor, state === "open") : null; // none in the page
    const text = compiling?.text ?? (state === undefined ? disconnected : stateText(state));
    this.#line.dataset.compiling = compiling?.state ?? "";
    if (text !== undefined) write(this.#line, error && state !== "open" ? `${text} ${error}` : text);
  }
}
