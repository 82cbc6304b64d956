// What can be opened again: each attempt waits longer than the one before.

const FIRST_WAIT_MS = 250;
const LONGEST_WAIT_MS = 8000;
const STEADY_MS = 2000; // a session that lasts this long resets the waits

/** A socket to the service, or what stands for one in the page: one session at a time. */
export class Reconnecting {
  /** Whether the newest attempt was ever open: if not, it was refused, or what it needs cannot be reached. */ opened = false;
  #attempts = 0;
  #timer;
  #sessionAt = Infinity;

  /** Whether what is sent now goes out. */
  get isOpen() {
    return false;
  }

  /** Whether a session has begun since the newest attempt, and goes on. */
  get hasSession() {
    return this.isOpen && this.#sessionAt < Infinity;
  }

  /** An attempt begins: there is no session. */
  begin() {
    this.cancelRetry();
    this.opened = false;
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
  cancelRetry() {
    clearTimeout(this.#timer);
  }
}
