// The trial that a client marks: its events are kept until it ends.

/** A longer trial is not scored, so that memory stays bounded. */
export const MOST_EVENTS = 100_000;

/** The events of the running trial. */
export class TrialBuffer {
  /** Whether a trial runs. */ running = false;
  /** The target that the start named, if it did. @type {object|null} */ goal = null;
  #rows = []; #count = 0;

  /** A trial starts; one that was running is dropped. @param {object|null} goal */
  start(goal) {
    [this.running, this.goal, this.#rows, this.#count] = [true, goal, [], 0];
  }

  /** Adds an event while a trial runs. @param {number[]} row */
  add(row) {
    if (!this.running) return;
    this.#count += 1;
    if (this.#count <= MOST_EVENTS) this.#rows.push(row);
  }

  /** Ends the trial. @returns {{rows: number[][], count: number}} */
  end() {
    const ended = { rows: this.#rows, count: this.#count };
    [this.running, this.goal, this.#rows, this.#count] = [false, null, [], 0];
    return ended;
  }
}
