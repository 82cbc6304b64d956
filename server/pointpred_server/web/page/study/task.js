// The multidirectional task of ISO 9241-411: turns presses into trials.

/**
 * @typedef {import("../../lib/index.d.ts").EventRow} Row
 * @typedef {import("../../lib/index.d.ts").Goal} Goal
 * @typedef {{block: number, number: number, from: [number, number], target: [number, number], width: number,
 *   distance: number, start: Row, end: Row, hit: boolean, rows: Row[]}} Trial `rows`: after `start`, up to `end`
 */

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

/** Blocks of movements between targets; a block begins with a click on its first target and visits all of them. */
export class CircleTask {
  /** @type {Trial[]} */ trials = [];
  /** Presses beside the first target of a block, which do not begin it. */ misplaced = 0;
  block = 1;
  done = false;
  /** @type {Row|null} */ #startRow = null;
  #rows = [];
  #position = 0;

  /**
   * @param {{targets: number, distance: number, width: number, blocks: number, centre: [number, number]}} settings
   */
  constructor(settings) {
    this.settings = settings;
    this.places = circle(settings.distance, settings.centre, settings.targets);
  }

  /** Movements in all blocks. */
  get total() {
    return this.settings.targets * this.settings.blocks;
  }

  /** Whether a movement is in progress; otherwise the next press begins a block. */
  get running() {
    return this.#startRow !== null;
  }

  /** The index of the target to select now. */
  get current() {
    return this.#position % this.settings.targets;
  }

  /** The target to select now. @returns {Goal} */
  get goal() {
    const [x, y] = this.places[this.current];
    return { x, y, width: this.settings.width };
  }

  /** Adds samples. @param {Row[]} rows */
  move(rows) {
    if (this.running) this.#rows.push(...rows);
  }

  /**
   * Adds a selection; its row has already been passed to `move`.
   * @param {Row} row
   * @returns {Trial|null} the trial that it has ended
   */
  select(row) {
    if (this.done) return null;
    if (!this.running) {
      if (this.#isHit(row)) this.#begin(row);
      else this.misplaced += 1;
      return null;
    }
    const trial = this.#trial(row);
    this.trials.push(trial);
    if (this.#position < this.settings.targets) this.#begin(row);
    else this.#endBlock();
    return trial;
  }

  /** @param {Row} row */
  #isHit([, x, y]) {
    const goal = this.goal;
    return Math.hypot(x - goal.x, y - goal.y) <= goal.width / 2;
  }

  #begin(row) {
    this.#startRow = row;
    this.#rows = [];
    this.#position += 1;
  }

  #endBlock() {
    this.#startRow = null;
    this.#rows = [];
    this.#position = 0;
    if (this.block === this.settings.blocks) this.done = true;
    else this.block += 1;
  }

  /** @param {Row} row @returns {Trial} */
  #trial(row) {
    const { width, distance } = this.settings;
    return {
      block: this.block,
      number: this.#position,
      from: this.places[this.#position - 1],
      target: this.places[this.current],
      width,
      distance,
      start: /** @type {Row} */ (this.#startRow),
      end: row,
      hit: this.#isHit(row),
      rows: this.#rows,
    };
  }
}
