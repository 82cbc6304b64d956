// The line that says how a connection stands, and what the service still compiles before it can answer.

import { askCompiling, compilingWords, whileCompiling } from "./compiling.js";
import { write } from "../page/elements.js";
import { words } from "./track.js";

/** One such line; it is written anew while the service compiles. */
export class Status {
  #line; #stands = {};

  /** @param {HTMLElement} line */
  constructor(line) {
    this.#line = line;
    whileCompiling(() => this.#write());
  }

  /** Of the connection; empty where there is none. @returns {string} */
  get state() {
    return this.#line.dataset.state ?? "";
  }

  /**
   * @param {string|undefined} state of the connection, undefined where there is none
   * @param {{predictor: string, fault?: string|null, without?: string}} about what went wrong; the words without a connection
   */
  say(state, about) {
    this.#stands = { state, ...about };
    this.#line.dataset.state = state ?? "";
    if (state === "connecting") askCompiling();
    this.#write();
  }

  #write() {
    const { state, predictor, fault, without } = this.#stands;
    const compiling = state === "connecting" || state === "open" ? compilingWords(predictor, state === "open") : "";
    const said = compiling || (state === undefined ? without : words(state));
    if (said !== undefined) write(this.#line, fault && state !== "open" ? `${said} ${fault}` : said);
  }
}
