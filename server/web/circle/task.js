// The multidirectional task of ISO 9241-411 without a screen: presses in, trials out.

import { circle } from "./geometry.js";

/**
 * @typedef {[number, number, number, number|null, number|null, number]} Row t s, x px, y px, counts, buttons
 * @typedef {{x: number, y: number, width: number}} Goal
 * @typedef {{block: number, number: number, from: [number, number], target: [number, number], width: number,
 *   distance: number, start: Row, end: Row, hit: boolean, rows: Row[]}} Trial `rows`: after `start`, up to `end`
 */

/** Blocks of movements between targets; a block begins with a click on its first target and visits them all. */
export class CircleTask {
  /** @type {Trial[]} */ trials = [];
  /** Presses beside the first target of a block; they begin nothing. */ astray = 0;
  block = 1;
  done = false;
  #start = null; #rows = []; #at = 0;

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

  /** Whether a movement is going on: otherwise the first target of a block is waited for. */
  get running() {
    return this.#start !== null;
  }

  /** The number of the target to select now. */
  get current() {
    return this.#at % this.settings.targets;
  }

  /** Where the target to select now lies. @returns {Goal} */
  get goal() {
    const [x, y] = this.places[this.current];
    return { x, y, width: this.settings.width };
  }

  /** Takes in movement. @param {Row[]} rows */
  move(rows) {
    if (this.running) this.#rows.push(...rows);
  }

  /**
   * Takes in a selection, whose row `move` has had already.
   * @param {Row} row
   * @returns {Trial|null} the trial that it ended
   */
  select(row) {
    if (this.done) return null;
    if (!this.running) {
      if (this.#on(row)) this.#begin(row);
      else this.astray += 1;
      return null;
    }
    const trial = this.#trial(row);
    this.trials.push(trial);
    if (this.#at < this.settings.targets) this.#begin(row);
    else this.#rest();
    return trial;
  }

  #on([, x, y]) {
    const goal = this.goal;
    return Math.hypot(x - goal.x, y - goal.y) <= goal.width / 2;
  }

  #begin(row) {
    this.#start = row;
    this.#rows = [];
    this.#at += 1;
  }

  #rest() {
    this.#start = null;
    this.#rows = [];
    this.#at = 0;
    if (this.block === this.settings.blocks) this.done = true;
    else this.block += 1;
  }

  #trial(row) {
    const { width, distance } = this.settings;
    return {
      block: this.block, number: this.#at, from: this.places[this.#at - 1], target: this.places[this.current],
      width, distance, start: this.#start, end: row, hit: this.#on(row), rows: this.#rows,
    };
  }
}
