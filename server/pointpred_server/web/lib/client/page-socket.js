// A session in the page, with the interface of a socket to the service: the connection need not know which it has.

import { Reconnecting } from "./reconnecting.js";

/** One session at a time. What is sent is answered after the code that runs now, events as they are and answers as objects. */
export class PageSocket extends Reconnecting {
  #handlers;
  /** @type {import("../prediction/session.js").PageSession|null} */ #session = null;
  #attempt = 0;
  #waiting = [];
  #heard = [];
  #runs = false;

  /** @param {{onOpen: () => void, onMessage: (message: object) => void, onClose: () => void}} handlers */
  constructor(handlers) {
    super();
    this.#handlers = handlers;
  }

  get isOpen() {
    return this.#session !== null;
  }

  /** What the newest prediction knows beyond one law. @returns {import("../prediction/mixture.js").Mixture|null} */
  get mixture() {
    return this.#session?.mixture ?? null;
  }

  /** Nothing is held back. */
  get bufferedAmount() {
    return 0;
  }

  /** Loads the session's modules, and opens one. */
  async open() {
    this.begin();
    const attempt = ++this.#attempt;
    try {
      const { PageSession } = await import("../prediction/session.js");
      if (attempt !== this.#attempt) return;
      const heard = [];
      [this.#waiting, this.#heard] = [[], heard];
      this.#session = new PageSession((message) => heard.push(message));
      this.opened = true;
      this.#handlers.onOpen();
    } catch (error) {
      console.error(error);
      if (attempt === this.#attempt) this.#end();
    }
  }

  /** Events as they are sent: all of them at once. @param {import("../index.d.ts").EventRow[]} rows */
  frames(rows) {
    return [
      { frame: rows, last: /** @type {import("../index.d.ts").EventRow} */ (rows.at(-1))[0], count: rows.length },
    ];
  }

  /** @param {string|import("../index.d.ts").EventRow[]} frame a message as JSON, or rows of events */
  send(frame) {
    this.#waiting.push(frame);
    if (this.#runs) return;
    this.#runs = true;
    queueMicrotask(() => this.#run());
  }

  /** Ends the session without calling `onClose`. */
  close() {
    this.cancelRetry();
    this.#attempt += 1;
    this.#session = null;
  }

  /** Takes in what waits, one after the other, and passes the answers on. */
  async #run() {
    while (this.#waiting.length && this.#session !== null) {
      const session = this.#session,
        frame = this.#waiting.shift();
      if (Array.isArray(frame)) session.receiveRows(frame);
      else await session.receive(JSON.parse(frame));
      if (session !== this.#session) continue;
      for (const message of this.#heard.splice(0)) if (session === this.#session) this.#handlers.onMessage(message);
      if (session === this.#session && session.ended !== null) this.#end();
    }
    this.#runs = false;
  }

  #end() {
    this.end();
    this.#session = null;
    this.#handlers.onClose();
  }
}
