// How likely the cursor is heading for each element in view, and what that decides, by the laws of `pointpred/targets`.

import { ENTERED, enter, INSIDE, innermost, KEEP, OUTSIDE } from "../laws/targets/choice_law.js";
import { begins, KNOWN, PRESSED, STATES, T, usable, X, Y } from "../laws/targets/cursor.js";
import { decide, likeliest, USUAL } from "../laws/targets/decision.js";
import * as heading from "../laws/targets/heading.js";
import { FITTED_NONE, FITTED_PAGES } from "../laws/targets/posterior.js";
import * as prefetch from "../laws/targets/prefetch.js";
import { NOBODY } from "../laws/targets/rectangles.js";
import { REMAINING_S, UNPREDICTED } from "../prediction/row.js";

const odds = (p) => p / (1 - p);
const USUAL_ELEMENTS = 8; // of so many registered elements it is assumed that nearly every movement is for one of them
const MOST_ELSEWHERE = 0.7; // and that this share is for something else where hardly any are registered
const [, LEAST_LEAD_S, LEAST_WAY_PX] = USUAL;
const LEARNS = 1;
const SETTINGS = Float64Array.from(prefetch.FITTED);
const NEVER = 1; // the highest threshold of a prefetch: fires at entry only

const numbers = new Map(); // of kinds of elements
/** The number of a kind of element: the same for all of it. @param {string} kind */
function numberOf(kind) {
  if (!numbers.has(kind)) numbers.set(kind, numbers.size + 1);
  return numbers.get(kind);
}

/** The registered elements in view as targets: the cursor, how likely each is, what the person took before. */
export class Shares {
  /** In the order of the table. @type {import("./tracker.js").Entry[]} */ entries = [];
  /** The newest row of a prediction. */ answer = UNPREDICTED;
  /** Counts movements. */ movement = 0;
  #memory = new Float64Array(heading.LENGTH);
  #cursor = this.#memory.subarray(heading.CURSOR, heading.CURSOR + STATES);
  #targets;
  #inside = new Float64Array(0);
  #standing = NOBODY;
  #movements = new Float64Array(prefetch.STATES);
  #fired = new WeakMap();
  #elsewhere = heading.ELSEWHERE; // how often none of the elements is meant; not learned, since the policies are fitted with it
  #lessSure = 1; // highlights use higher prior odds that the movement is for no registered element: by this factor

  constructor() {
    this.replace([]);
  }

  /** When the newest event was, s, and where, px. @returns {{t: number, x: number, y: number}} */
  get cursor() {
    const { [T]: t, [X]: x, [Y]: y } = this.#cursor;
    return { t, x, y };
  }

  get #table() {
    return this.#targets[0];
  }

  get #shares() {
    return this.#targets[3];
  }

  /** Takes other elements; what is known of those that stay is kept. @param {import("./tracker.js").Entry[]} entries */
  replace(entries) {
    const inside = new Map(
      this.entries.map((entry, i) => [entry, this.#inside[i] === ENTERED ? INSIDE : this.#inside[i]]),
    );
    const standing = this.entries[this.#standing],
      memory = this.#memory;
    this.entries = entries;
    this.#inside = Float64Array.from(entries, (entry) => inside.get(entry) ?? OUTSIDE);
    this.#standing = standing ? entries.indexOf(standing) : NOBODY; // -1 where it is gone
    const seen = entries.filter(({ isHidden }) => !isHidden),
      total = seen.reduce((sum, { weight }) => sum + weight, 0);
    const own = Float64Array.from(entries, ({ isHidden, weight }) => (isHidden ? -Infinity : Math.log(weight / total)));
    this.#targets = [
      entries.map(({ row }) => row),
      own,
      entries.map(({ number, kind }) => [number, numberOf(kind)]),
      new Float64Array(entries.length + 1),
    ];
    this.#elsewhere = Math.max(heading.ELSEWHERE, MOST_ELSEWHERE * (1 - seen.length / USUAL_ELEMENTS));
    memory.set([this.#elsewhere, LEARNS]);
    this.#lessSure = odds(FITTED_NONE) / odds(this.#elsewhere);
    heading.begin(memory, this.#targets);
    if (this.#cursor[KNOWN] === 1) this.weigh(this.answer);
  }

  /** The share of the element at a place of the table. @param {number} place */
  share(place) {
    return this.#shares[place] ?? 0;
  }

  /**
   * Uses the events of a dispatch.
   * @param {number[][]} rows t, x, y, dx, dy, buttons @param {(row: number[], begins: boolean) => void} use is called with each before,
   *   and with whether a movement begins with it
   * @returns {import("./tracker.js").Entry[]} the elements they have entered, in turn
   */
  follow(rows, use) {
    const cursor = this.#cursor,
      inside = this.#inside,
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
      if (released) this.#standing = NOBODY;
      if (enter(this.#table, inside, x, y, released) > 0)
        entered.push(...this.entries.filter((_, i) => inside[i] === ENTERED));
    }
    return entered;
  }

  /** Computes the shares. @param {number[]|null} answer the row of the newest prediction, null for none */
  weigh(answer) {
    this.answer = answer ?? UNPREDICTED;
    this.#memory[heading.NONE] = this.#elsewhere;
    heading.weigh(this.#memory, this.answer, this.#targets, FITTED_PAGES);
  }

  /** The elements that a prefetch fires for now. @returns {import("./tracker.js").Entry[]} */
  worthPrefetching() {
    const { entries } = this;
    const thresholds = Float64Array.from(entries, ({ prefetchFrom }) => Math.min(prefetchFrom, NEVER));
    const fired = Float64Array.from(entries, (entry) => this.#fired.get(entry) ?? prefetch.ARMED);
    this.#movements.set(this.#cursor);
    const count = prefetch.step(
      this.#movements,
      [this.#table, thresholds, new Float64Array(entries.length), fired],
      this.#shares,
      SETTINGS,
    );
    entries.forEach((entry, i) => this.#fired.set(entry, fired[i]));
    return count === 0
      ? []
      : entries.filter((_, i) => fired[i] === prefetch.PREDICTED || fired[i] === prefetch.ENTERED);
  }

  /** The element to highlight because the movement heads for it, if there is one. @returns {import("./tracker.js").Entry|undefined} */
  headedFor() {
    const { entries } = this,
      shares = this.#shares,
      total = 1 + (this.#lessSure - 1) * shares.at(-1),
      lit = shares.map((share) => share / total);
    const best = likeliest(lit, entries.length),
      ask = entries[best]?.highlightFrom ?? 1,
      keep = KEEP * (entries[this.#standing]?.highlightFrom ?? ask);
    this.#standing = decide(this.#cursor, this.#table, lit, this.#standing, this.answer[REMAINING_S], [
      ask,
      keep,
      LEAST_LEAD_S,
      LEAST_WAY_PX,
    ]);
    return entries[this.#standing];
  }

  /** The innermost element that the cursor is in, if there is one. @returns {import("./tracker.js").Entry|undefined} */
  enclosing() {
    return this.entries[innermost(this.#table, this.#inside)];
  }

  /** The pointer is elsewhere: nothing is headed for. */
  rest() {
    this.#standing = NOBODY;
  }
}
