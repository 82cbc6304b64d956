// How likely the cursor is heading for each element in view, and what that decides, by the laws of `pointpred/targets`.

import { ENTERED, enter, INSIDE, innermost, KEEP, OUTSIDE } from "../laws/targets/choice_law.js";
import { begins, KNOWN, PRESSED, STATES, T, usable, X, Y } from "../laws/targets/cursor.js";
import { decide, likeliest, USUAL } from "../laws/targets/decision.js";
import * as heading from "../laws/targets/heading.js";
import { FITTED_NONE, FITTED_PAGES } from "../laws/targets/posterior.js";
import * as prefetch from "../laws/targets/prefetch.js";
import { CENTRE_X, CENTRE_Y, HEIGHT, WIDTH } from "../laws/targets/rectangles.js";
import { UNPREDICTED } from "../prediction/row.js";

/** What highlights are decided by: loaded with what is there already. */
export const HIGHLIGHTING = { decide, likeliest, innermost, KEEP, USUAL, FITTED_NONE };
const USUAL_ELEMENTS = 8; // of so many registered elements it is assumed that nearly every movement is for one of them
const MOST_ELSEWHERE = 0.7; // and that this share is for something else where hardly any are registered
const LEARNS = 1;
const SETTINGS = Float64Array.from(prefetch.FITTED);
const ROUNDING = 1; // px that sums may err by, and far more
const [ROW_X, ROW_Y] = [1, 2]; // places in the row of an event
const NEVER = 1; // the highest threshold of a prefetch: fires at entry only

/** The middle of what some events have at a place of their rows, and half of its width. */
function spanOf(rows, place) {
  const values = rows.map((row) => row[place]),
    [low, high] = [Math.min(...values), Math.max(...values)];
  return [0.5 * (low + high), 0.5 * (high - low)];
}

const numbers = new Map(); // of kinds of elements
/** The number of a kind of element: the same for all of it. @param {string} kind */
function numberOf(kind) {
  if (!numbers.has(kind)) numbers.set(kind, numbers.size + 1);
  return numbers.get(kind);
}

/** The registered elements in view as targets: the cursor, how likely each is, what the person took before. */
export class Shares {
  /** In the order of the table. @type {import("./entry.js").Entry[]} */ entries = [];
  /** The newest row of a prediction. */ answer = UNPREDICTED;
  /** Counts movements. */ movement = 0;
  /** Counts how often the button was released. */ releases = 0;
  /** How often none of the elements is meant; not learned, since the policies are fitted with it. */ elsewhere =
    heading.ELSEWHERE;
  /** Whether the cursor is in the rectangle of each element. */ inside = new Float64Array(0);
  #memory = new Float64Array(heading.LENGTH);
  /** What the laws remember of the cursor. */ state = this.#memory.subarray(heading.CURSOR, heading.CURSOR + STATES);
  #targets;
  #movements = new Float64Array(prefetch.STATES);
  #prefetches = false; // whether any element asks for it

  // of each element:
  #thresholds; // of prefetches
  #visits; // how likely the cursor goes through it
  #fired; // in this movement

  constructor() {
    this.replace([]);
  }

  /** When the newest event was, s, and where, px. @returns {{t: number, x: number, y: number}} */
  get cursor() {
    const { [T]: t, [X]: x, [Y]: y } = this.state;
    return { t, x, y };
  }

  /** The rows of the elements. @returns {Float64Array[]} */
  get table() {
    return this.#targets[0];
  }

  /** The share of each element, and last that of none of them. @returns {Float64Array} */
  get all() {
    return this.#targets[3];
  }

  /** Takes other elements; what is known of those that stay is kept. @param {import("./entry.js").Entry[]} entries */
  replace(entries) {
    const inside = new Map(
      this.entries.map((entry, i) => [entry, this.inside[i] === ENTERED ? INSIDE : this.inside[i]]),
    );
    const memory = this.#memory;
    this.entries.forEach((entry, i) => {
      entry.fired = this.#fired[i];
    });
    this.entries = entries;
    this.inside = Float64Array.from(entries, (entry) => inside.get(entry) ?? OUTSIDE);
    this.#thresholds = Float64Array.from(entries, ({ prefetchFrom }) => Math.min(prefetchFrom, NEVER));
    this.#prefetches = entries.some(({ prefetchFrom }) => prefetchFrom < Infinity);
    this.#visits = new Float64Array(entries.length);
    this.#fired = Float64Array.from(entries, ({ fired }) => fired);
    const seen = entries.filter(({ isHidden }) => !isHidden),
      total = seen.reduce((sum, { weight }) => sum + weight, 0);
    const own = Float64Array.from(entries, ({ isHidden, weight }) => (isHidden ? -Infinity : Math.log(weight / total)));
    this.#targets = [
      entries.map(({ row }) => row),
      own,
      entries.map(({ number, kind }) => [number, numberOf(kind)]),
      new Float64Array(entries.length + 1),
    ];
    this.elsewhere = Math.max(heading.ELSEWHERE, MOST_ELSEWHERE * (1 - seen.length / USUAL_ELEMENTS));
    memory.set([this.elsewhere, LEARNS]);
    heading.begin(memory, this.#targets);
    if (this.state[KNOWN] === 1) this.weigh(this.answer);
  }

  /** The share of the element at a place of the table. @param {number} place */
  share(place) {
    return this.all[place] ?? 0;
  }

  /** The places of the elements of at least this share. @param {number} least */
  likely(least) {
    const found = [];
    for (let i = 0; i < this.entries.length; i += 1) if (this.all[i] >= least) found.push(i);
    return found;
  }

  /**
   * Uses the events of a frame.
   * @param {number[][]} rows t, x, y, dx, dy, buttons @param {(row: number[], begins: boolean) => void} use is called with each before,
   *   and with whether a movement begins with it
   * @returns {{entry: import("./entry.js").Entry, x: number, y: number}[]} the elements whose rectangles they have entered, in turn, and where
   */
  follow(rows, use) {
    const cursor = this.state,
      near = this.#near(rows),
      table = near.map((i) => this.table[i]),
      inside = Float64Array.from(near, (i) => this.inside[i]),
      entered = [];
    for (const row of rows) {
      const [t, x, y, , , buttons] = row,
        pressed = buttons & 1,
        begun = begins(cursor, t, pressed);
      use(row, begun);
      if (!usable(t, x, y) || (cursor[KNOWN] === 1 && t < cursor[T])) continue;
      const released = cursor[PRESSED] > pressed;
      heading.follow(this.#memory, row, this.#targets);
      this.movement += Number(begun);
      this.releases += Number(released);
      if (enter(table, inside, x, y, released) > 0)
        near.forEach((i, place) => {
          if (inside[place] === ENTERED) entered.push({ entry: this.entries[i], x, y });
        });
    }
    near.forEach((i, place) => {
      this.inside[i] = inside[place];
    });
    return entered;
  }

  /** The places of the elements that some events may enter or leave: the others need not be looked at. */
  #near(rows) {
    const [x, across] = spanOf(rows, ROW_X),
      [y, down] = spanOf(rows, ROW_Y);
    const table = this.table,
      inside = this.inside,
      near = [];
    for (let i = 0; i < table.length; i += 1) {
      const row = table[i],
        far = Math.abs(row[CENTRE_X] - x) - 0.5 * row[WIDTH] - across,
        below = Math.abs(row[CENTRE_Y] - y) - 0.5 * row[HEIGHT] - down;
      if ((far <= ROUNDING && below <= ROUNDING) || inside[i] !== OUTSIDE) near.push(i);
    }
    return near;
  }

  /** Computes the shares. @param {number[]|null} answer the row of the newest prediction, null for none */
  weigh(answer) {
    this.answer = answer ?? UNPREDICTED;
    this.#memory[heading.NONE] = this.elsewhere;
    heading.weigh(this.#memory, this.answer, this.#targets, FITTED_PAGES);
  }

  /** The elements that a prefetch is predicted for now, each with the probability that its threshold is compared with. */
  worthPrefetching() {
    if (!this.#prefetches) return [];
    const { entries } = this,
      fired = this.#fired;
    this.#movements.set(this.state);
    const targets = [this.table, this.#thresholds, this.#visits, fired];
    if (prefetch.step(this.#movements, targets, this.all, SETTINGS) === 0) return [];
    const expected = prefetch.expect(this.state[X], this.state[Y], this.table, this.#visits, this.all);
    const found = [];
    for (let i = 0; i < entries.length; i += 1)
      if (fired[i] === prefetch.PREDICTED)
        found.push({ entry: entries[i], p: this.share(i), score: this.#scoreOf(i, expected) });
    return found;
  }

  /** What a threshold is compared with, as a probability. */
  #scoreOf(i, expected) {
    const share = this.all[i],
      row = this.table[i];
    const logOdds = prefetch.score(this.#movements, row, share, this.#visits[i], expected, SETTINGS);
    return 1 / (1 + Math.exp(-logOdds));
  }
}
