// How likely the cursor is heading for each element in view, by the laws of `pointpred/targets`.

import { ENTERED, INSIDE, KEEP, OUTSIDE, enter, innermost } from "../laws/targets/choice_law.js";
import { KNOWN, STATES, T, T0, X, Y, follow, usable } from "../laws/targets/cursor.js";
import { NOBODY, decide, likeliest } from "../laws/targets/decision.js";
import { FITTED, FITTED_NONE, normalise, scores } from "../laws/targets/posterior.js";
import { fires } from "./prefetch.js";

const LEAST_LEAD_S = 0, LEAST_WAY_PX = 3; // the defaults of the chooser in Python
const LOG_WEIGHT = 4; // places of a row of the table: centre x, y, width, height, logarithm of the weight
const REMAINING_S = 6; // in the row of a prediction
const NOTHING = new Array(10).fill(NaN);

/** The cursor, the table of the elements in view, and their shares. */
export class Shares {
  /** In the order of the table. @type {import("./entries.js").Entry[]} */ entries = [];
  /** The newest row of a prediction. */ answer = NOTHING;
  /** Counts movements. */ movement = 0;
  #memory = new Float64Array(STATES); #table = []; #inside = new Float64Array(0); #shares = Float64Array.of(1); #standing = NOBODY;

  /** When the newest event was, s, and where, px. @returns {{t: number, x: number, y: number}} */
  get cursor() {
    return { t: this.#memory[T], x: this.#memory[X], y: this.#memory[Y] };
  }

  /** Takes other elements; what is known of those that stay is kept. @param {import("./entries.js").Entry[]} entries */
  replace(entries) {
    const inside = new Map(this.entries.map((entry, i) => [entry, this.#inside[i] === ENTERED ? INSIDE : this.#inside[i]]));
    const standing = this.entries[this.#standing];
    this.entries = entries;
    this.#table = entries.map(({ row }) => row);
    this.#inside = Float64Array.from(entries, (entry) => inside.get(entry) ?? OUTSIDE);
    this.#shares = new Float64Array(entries.length + 1);
    this.#shares[entries.length] = 1;
    this.#standing = standing ? entries.indexOf(standing) : NOBODY; // -1 where it is gone
    const total = entries.reduce((sum, { isHidden, weight }) => sum + (isHidden ? 0 : weight), 0);
    for (const { row, isHidden, weight } of entries) row[LOG_WEIGHT] = isHidden ? -Infinity : Math.log(weight / total);
  }

  /** The share of the element at a place of the table. @param {number} place */
  share(place) {
    return this.#shares[place] ?? 0;
  }

  /** Uses one event. @param {number[]} row t, x, y, dx, dy, buttons @returns {import("./entries.js").Entry[]} the elements it has entered */
  follow([t, x, y, , , buttons]) {
    const memory = this.#memory;
    if (!usable(t, x, y) || (memory[KNOWN] === 1 && t < memory[T])) return [];
    const began = memory[T0], released = follow(memory, t, x, y, buttons & 1);
    if (memory[T0] !== began) this.movement += 1;
    if (released) this.#standing = NOBODY;
    if (enter(this.#table, this.#inside, x, y, released) === 0) return [];
    return this.entries.filter((_, i) => this.#inside[i] === ENTERED);
  }

  /** Computes the shares. @param {number[]|null} answer the row of the newest prediction, null for none */
  weigh(answer) {
    this.answer = answer ?? NOTHING;
    // Many movements on a page go to nothing that is registered: as many as in the recordings that the coefficients were fitted to.
    scores(this.#memory, this.#table, this.answer, FITTED, FITTED_NONE, this.#shares);
    normalise(this.#shares);
  }

  /** The elements whose prefetch is worth its cost now. @returns {import("./entries.js").Entry[]} */
  worthPrefetching() {
    return this.entries.filter((entry, i) => entry.prefetchFrom < Infinity && fires(this.#memory, this.#table[i], this.#shares[i], entry.prefetchFrom));
  }

  /** The element to highlight because the movement heads for it, if there is one. @returns {import("./entries.js").Entry|undefined} */
  headedFor() {
    const best = likeliest(this.#shares, this.#table.length);
    const ask = this.entries[best]?.highlightFrom ?? 1, keep = KEEP * (this.entries[this.#standing]?.highlightFrom ?? ask);
    this.#standing = decide(this.#memory, this.#table, this.#shares, this.#standing, this.answer[REMAINING_S], [ask, keep, LEAST_LEAD_S, LEAST_WAY_PX]);
    return this.entries[this.#standing];
  }

  /** The innermost element that the cursor is in, if there is one. @returns {import("./entries.js").Entry|undefined} */
  enclosing() {
    return this.entries[innermost(this.#table, this.#inside)];
  }

  /** The pointer is elsewhere: nothing is headed for. */
  rest() {
    this.#standing = NOBODY;
  }
}
