// The pointing task: turns presses into trials, on circles of ISO 9241-411 and between two bars.

/**
 * @typedef {import("../../lib/index.d.ts").EventRow} Row
 * @typedef {{x: number, y: number, width: number, height: number|null}} Place a target: its centre and size, px; a circle has no height
 * @typedef {{phase: string, block: number, task: string, distance: number, width: number, height: number|null, movements: number,
 *   places: [number, number][], rest?: boolean}} Sequence movements under one condition: a click on the first place begins it, then
 *   each follows in turn; places are px from the middle of the picture
 * @typedef {{sequence: Sequence, number: number, from: [number, number], target: [number, number], start: Row, end: Row,
 *   hit: boolean, clicks: number, lost: number, rows: Row[]}} Trial `number` counts the movements of its sequence from 1; `hit`: its
 *   first click was inside; `rows`: after `start`, up to `end`, but for those `lost`
 */

const MOST_ROWS = 60_000; // of one movement: memory stays bounded

/** The radius of a circle on which an odd number of targets taken in turn are `distance` apart. */
export const radiusFor = (distance, count) => distance / (2 * Math.cos(Math.PI / (2 * count)));

/**
 * Centres of the targets of ISO 9241-411 in the order they are taken: each lies across from the one before.
 * @param {number} distance px between targets taken in turn
 * @param {[number, number]} centre of the circle, px
 * @param {number} count of targets, odd, so that the order across the circle visits all
 * @returns {[number, number][]}
 */
export function circle(distance, centre, count = 13) {
  if (!Number.isInteger(count) || count < 3 || count % 2 === 0) {
    throw new RangeError(`the number of targets must be odd and at least 3, received ${count}`);
  }
  const radius = radiusFor(distance, count);
  return Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * ((k * (Math.floor(count / 2) + 1)) % count)) / count;
    return [centre[0] + radius * Math.sin(angle), centre[1] - radius * Math.cos(angle)];
  });
}

/** Sequences of movements. A movement begins where the one before has ended; the first, and one that is resumed, with a click on its start. */
export class PointingTask {
  /** @type {Trial[]} */ trials = [];
  /** Presses beside a start, which begin nothing. */ misplaced = 0;
  /** Whether every sequence is done. */ done = false;
  #at = 0; // of the sequences
  #movement = 1; // that comes, or is in progress
  /** @type {Row|null} */ #startRow = null;
  #rows = [];
  #lost = 0;
  #clicks = 0;

  /**
   * @param {Sequence[]} sequences
   * @param {[number, number]} centre the middle of the picture, px
   * @param {"go-on"|"repeat"|"until-inside"} onError what follows a click beside the target
   */
  constructor(sequences, centre, onError = "go-on") {
    this.sequences = sequences;
    this.centre = centre;
    this.onError = onError;
  }

  /** The sequence that comes, or is in progress; the last one at the end. */
  get sequence() {
    return this.sequences[this.#at];
  }

  /** The sequence, and the movement in it, that comes or is in progress, both from 1; null at the end. @returns {[number, number]|null} */
  get next() {
    return this.done ? null : [this.#at + 1, this.#movement];
  }

  /** Movements in all sequences. */
  get total() {
    return this.sequences.reduce((sum, { movements }) => sum + movements, 0);
  }

  /** Movements before this one in all sequences. */
  get before() {
    const whole = this.sequences.slice(0, this.#at).reduce((sum, { movements }) => sum + movements, 0);
    return this.done ? this.total : whole + this.#movement - 1;
  }

  /** Whether a movement is in progress; otherwise the next press begins one. */
  get running() {
    return this.#startRow !== null;
  }

  /** The centres of the targets, px of the picture. @returns {[number, number][]} */
  get places() {
    return this.sequence.places.map(([x, y]) => [this.centre[0] + x, this.centre[1] + y]);
  }

  /** The index of the target to select now. */
  get current() {
    return this.#index(this.running ? 0 : 1);
  }

  /** The target to select now. @returns {Place} */
  get goal() {
    const [x, y] = this.places[this.current];
    return { x, y, width: this.sequence.width, height: this.sequence.height };
  }

  /** Goes on at a movement, which begins with a click on its start; null: all is done. @param {[number, number]|null} next the sequence and the movement in it, from 1 */
  resume(next) {
    this.done = next === null;
    if (next !== null) [this.#at, this.#movement] = [next[0] - 1, next[1]];
    this.#startRow = null;
  }

  /** Drops the movement in progress: it begins again with a click on its start. */
  interrupt() {
    this.#startRow = null;
  }

  /** Adds samples. @param {Row[]} rows */
  move(rows) {
    if (!this.running) return;
    const room = MOST_ROWS - 1 - this.#rows.length; // one is for the end
    this.#rows.push(...rows.slice(0, room));
    this.#lost += Math.max(0, rows.length - Math.max(0, room));
  }

  /**
   * Adds a selection; its row has already been passed to `move`.
   * @param {Row} row
   * @returns {Trial|null} the trial that it has ended
   */
  select(row) {
    if (this.done) return null;
    const inside = this.#isInside(row);
    if (!this.running) {
      if (inside) this.#begin(row);
      else this.misplaced += 1;
      return null;
    }
    this.#clicks += 1;
    if (!inside && this.onError === "until-inside") return null;
    const trial = this.#trial(row, inside && this.#clicks === 1);
    this.trials.push(trial);
    if (!trial.hit && this.onError === "repeat") this.interrupt();
    else this.#goOn(row);
    return trial;
  }

  /** @param {Row} row */
  #isInside([, x, y]) {
    const { x: left, y: top, width, height } = this.goal;
    const [dx, dy] = [x - left, y - top];
    return height === null ? Math.hypot(dx, dy) <= width / 2 : 2 * Math.abs(dx) <= width && 2 * Math.abs(dy) <= height;
  }

  /** The index of the place of this movement, or of one some movements before. */
  #index(before) {
    return (this.#movement - before) % this.sequence.places.length;
  }

  #begin(row) {
    this.#startRow = row;
    [this.#rows, this.#lost, this.#clicks] = [[], 0, 0];
  }

  #goOn(row) {
    this.#movement += 1;
    if (this.#movement <= this.sequence.movements) return this.#begin(row);
    this.#startRow = null;
    if (this.#at + 1 === this.sequences.length) this.done = true;
    else [this.#at, this.#movement] = [this.#at + 1, 1];
  }

  /** @param {Row} row @param {boolean} hit @returns {Trial} */
  #trial(row, hit) {
    if (this.#lost > 0) this.#rows.push(row);
    return {
      sequence: this.sequence,
      number: this.#movement,
      from: this.places[this.#index(1)],
      target: this.places[this.#index(0)],
      start: /** @type {Row} */ (this.#startRow),
      end: row,
      hit,
      clicks: this.#clicks,
      lost: Math.max(0, this.#lost - 1),
      rows: this.#rows,
    };
  }
}
