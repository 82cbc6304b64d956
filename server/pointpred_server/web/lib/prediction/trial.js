// The trial that a client marks: its events are kept until it ends.

import { TRIAL_COLUMNS } from "../laws/messages.js";
import { ProtocolError } from "./messages.js";

/** A longer trial is not scored, so that memory stays bounded. */
export const MOST_EVENTS = 100_000;

/** The events of the running trial. */
export class TrialBuffer {
  /** Whether a trial runs. */ running = false;
  /** The target that the start named, if it did. @type {{x: number, y: number}|null} */ goal = null;
  #rows = [];
  #count = 0;
  #conditions = {};
  /** @type {string[]|null} */ #names = null;

  /** A trial starts; one that was running is dropped. Throws a ProtocolError. @param {{x: number, y: number}|null} goal @param {object} conditions */
  start(goal, conditions) {
    this.#check(conditions);
    [this.running, this.goal, this.#rows, this.#count, this.#conditions] = [true, goal, [], 0, conditions];
  }

  /** What the running trial was, at its end: the first one of a session names all conditions. Throws a ProtocolError. @param {object} conditions */
  describe(conditions) {
    this.#check(conditions);
    this.#names ??= Object.keys({ ...this.#conditions, ...conditions });
  }

  #check(conditions) {
    for (const name of Object.keys(conditions)) {
      if (!TRIAL_COLUMNS.includes(name) && (this.#names ?? [name]).includes(name)) continue;
      const sentence = `'${name}' is a column of every table of trials, or no condition of this session's first trial`;
      throw new ProtocolError("bad_field", sentence, `$.conditions.${name}`, { field: name });
    }
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
