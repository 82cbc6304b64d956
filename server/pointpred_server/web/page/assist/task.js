// Targets one after another, with assistance or without, and how long they took.

import { median } from "../shell/numbers.js";

const WIDTH = 32;
const SHARE = 0.6; // of the shorter side of the field: the distance between targets
const GOLDEN = 2.399963; // rad: directions do not repeat
const MARGIN = WIDTH;

/** A series of targets to click; for each pair it is random which one is assisted. */
export class Task {
  /** Where to point, px. @type {{x: number, y: number, width: number}} */ target = { x: 0, y: 0, width: WIDTH };
  /** Whether the current target is assisted. */ assisted = true;
  /** The targets clicked: assisted or not, seconds, clicks beside it. @type {{assisted: boolean, seconds: number, missed: number}[]} */ done =
    [];
  #random;
  /** @type {number|null} */ #since = null;
  #missed = 0;
  #number = 0;

  /** @param {() => number} random */
  constructor(random = Math.random) {
    this.#random = random;
  }

  /** Sets the next target, seen from the cursor in a field of this size; `always`: every target is assisted. @param {number[]} cursor @param {number[]} size @param {boolean} always */
  next([x, y], [width, height], always) {
    const distance = SHARE * Math.min(width, height);
    for (let turn = 0; turn < 9; turn += 1) {
      const angle = GOLDEN * (this.#number + 13 * turn);
      this.target = {
        x: Math.round(x + distance * Math.cos(angle)),
        y: Math.round(y + distance * Math.sin(angle)),
        width: WIDTH,
      };
      if (this.#isInside(width, height)) break;
    }
    if (!this.#isInside(width, height))
      this.target = { x: Math.round(width / 2), y: Math.round(height / 2), width: WIDTH };
    this.assisted = always || (this.#number % 2 === 0 ? this.#random() < 0.5 : !this.assisted);
    this.#number += 1;
    [this.#since, this.#missed] = [null, 0];
  }

  #isInside(width, height) {
    const { x, y } = this.target;
    return x > MARGIN && y > MARGIN && x < width - MARGIN && y < height - MARGIN;
  }

  /** The mouse moves: the time of a target begins with the first movement. */
  move(t) {
    this.#since ??= t;
  }

  /** A click at a point. @param {number[]} point @param {number} t s @returns {boolean} whether it hit the target */
  press([x, y], t) {
    const { target } = this;
    if (Math.hypot(x - target.x, y - target.y) > target.width / 2) {
      this.#missed += 1;
      return false;
    }
    this.done.push({ assisted: this.assisted, seconds: t - (this.#since ?? t), missed: this.#missed });
    return true;
  }

  /** The results as rows of a table: with assistance, and without. */
  get table() {
    return [
      ["targets", "clicked", "median, s", "missed"],
      ...[true, false].map((assisted) => {
        const targets = this.done.filter((one) => one.assisted === assisted);
        const seconds = median(targets.map((one) => one.seconds));
        return [
          assisted ? "assisted" : "not assisted",
          String(targets.length),
          targets.length ? seconds.toFixed(2) : "–",
          String(targets.reduce((sum, { missed }) => sum + missed, 0)),
        ];
      }),
    ];
  }
}
