// Attempts to open a connection again: each waits longer than the one before.

const FIRST_WAIT_MS = 250;
const LONGEST_WAIT_MS = 8000;
const STEADY_MS = 2000; // a session that lasts this long resets the waits

/** The waits between attempts. */
export class Retries {
  #attempts = 0;
  #timer;
  #sessionAt = Infinity;

  /** Whether a session has begun since the newest attempt. */
  get hasSession() {
    return this.#sessionAt < Infinity;
  }

  /** An attempt begins: there is no session. */
  begin() {
    this.cancel();
    this.#sessionAt = Infinity;
  }

  /** A session has begun: if it lasts, the next wait is the shortest again. */
  beginSession() {
    this.#sessionAt = performance.now();
  }

  /** The connection is lost. */
  end() {
    if (performance.now() - this.#sessionAt > STEADY_MS) this.#attempts = 0;
  }

  /** Calls `open` after a wait. @param {() => void} open */
  retry(open) {
    const wait = Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** this.#attempts++) * (0.75 + 0.5 * Math.random());
    this.#timer = setTimeout(open, wait);
  }

  /** Gives up waiting for the next attempt. */
  cancel() {
    clearTimeout(this.#timer);
  }
}
