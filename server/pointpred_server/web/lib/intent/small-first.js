// A small predictor predicts until a larger one is loaded.

const PATIENCE_MS = 2000; // of a page that is never idle

/** When the page has nothing else to do; some browsers do not tell. */
const idle = () =>
  new Promise((resolve) => (globalThis.requestIdleCallback ?? setTimeout)(resolve, { timeout: PATIENCE_MS }));

/**
 * @param {import("./source.js").InPage} small @param {import("./source.js").InPage} large loaded once the page is idle
 * @returns {import("./source.js").InPage} the large one, before which the small one predicts, until the end of a movement
 */
export const smallFirst = (small, large) => ({
  name: large.name,
  open: async () => new Both(small.name, await small.open(), large),
});

class Both {
  /** The name of the predictor that predicts now. @type {string} */ predictor;
  /** Settles when the large one is loaded. @type {Promise<void>} */ ready;
  #opened;
  /** @type {{opened: import("./source.js").Opened, name: string}|null} */ #next = null;
  #closed = false;

  constructor(name, opened, large) {
    [this.predictor, this.#opened] = [name, opened];
    this.ready = this.#load(large);
  }

  async #load({ name, open }) {
    await idle();
    if (this.#closed) return;
    const opened = await open();
    this.#next = { opened, name };
  }

  /** As `Source` does; a predictor takes over at the begin of a movement only. */
  add(row, begins) {
    if (begins && this.#next !== null) {
      this.#opened.close();
      ({ opened: this.#opened, name: this.predictor } = this.#next);
      this.#next = null;
    }
    return this.#opened.add(row);
  }

  flush() {
    return this.#opened.flush();
  }

  close() {
    this.#closed = true;
    this.#opened.close();
  }
}
