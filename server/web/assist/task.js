// Targets one after another, each with help or without it, and how long they took.

import { median } from "../circle/geometry.js";

const WIDTH = 32;
const SHARE = 0.6; // of the shorter side of the field: how far targets are apart
const GOLDEN = 2.399963; // rad: directions that never repeat
const MARGIN = WIDTH;

/** A row of targets to click; chance decides of each pair which one is helped. */
export class Task {
  /** Where to point, px. @type {{x: number, y: number, width: number}} */ target = { x: 0, y: 0, width: WIDTH };
  /** Whether this one is helped. */ helped = true;
  /** Clicked: with help or without, seconds, clicks beside it. @type {{helped: boolean, seconds: number, missed: number}[]} */ done = [];
  #chance; #since = null; #missed = 0; #number = 0;

  /** @param {() => number} chance */
  constructor(chance = Math.random) {
    this.#chance = chance;
  }

  /** The next target, in a field of this size as seen from the cursor; `always`: help at every one. */
  next([x, y], [width, height], always) {
    const far = SHARE * Math.min(width, height);
    for (let turn = 0; turn < 9; turn += 1) {
      const angle = GOLDEN * (this.#number + 13 * turn);
      this.target = { x: Math.round(x + far * Math.cos(angle)), y: Math.round(y + far * Math.sin(angle)), width: WIDTH };
      if (this.#inside(width, height)) break;
    }
    if (!this.#inside(width, height)) this.target = { x: Math.round(width / 2), y: Math.round(height / 2), width: WIDTH };
    this.helped = always || (this.#number % 2 === 0 ? this.#chance() < 0.5 : !this.helped);
    this.#number += 1;
    [this.#since, this.#missed] = [null, 0];
  }

  #inside(width, height) {
    const { x, y } = this.target;
    return x > MARGIN && y > MARGIN && x < width - MARGIN && y < height - MARGIN;
  }

  /** The hand moves: time begins with the first motion. */
  moved(t) {
    this.#since ??= t;
  }

  /** A click at a place; whether it hit. */
  pressed([x, y], t) {
    const { target } = this;
    if (Math.hypot(x - target.x, y - target.y) > target.width / 2) {
      this.#missed += 1;
      return false;
    }
    this.done.push({ helped: this.helped, seconds: t - (this.#since ?? t), missed: this.#missed });
    return true;
  }

  /** Rows of what came of it: with help, without. */
  get table() {
    return [["", "targets", "median, s", "missed"], ...[true, false].map((helped) => {
      const of = this.done.filter((one) => one.helped === helped);
      const seconds = median(of.map((one) => one.seconds));
      return [helped ? "with help" : "no help", String(of.length), of.length ? seconds.toFixed(2) : "–",
        String(of.reduce((sum, { missed }) => sum + missed, 0))];
    })];
  }
}
