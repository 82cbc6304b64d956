// How likely the cursor is heading for each element in view, by the laws of `pointpred/targets`.

import { ENTERED, INSIDE, KEEP, OUTSIDE, enter, innermost } from "../laws/targets/choice_law.js";
import { KNOWN, T, T0, X, Y, follow, usable } from "../laws/targets/cursor.js";
import { decide, likeliest, USUAL } from "../laws/targets/decision.js";
import { NOBODY } from "../laws/targets/rectangles.js";
import { CENTRE_X, CENTRE_Y, HEIGHT, LOG_WEIGHT, WIDTH } from "../laws/targets/rectangles.js";
import { FITTED_NONE, FITTED_PAGES, normalise, scores } from "../laws/targets/posterior.js";
import * as prefetch from "../laws/targets/prefetch.js";
import { REMAINING_S, UNPREDICTED } from "../prediction/row.js";

const logit = (p) => Math.log(p / (1 - p));
/** Highlights use higher prior odds that the movement is for no registered element. This is the logarithm of that factor. */
const MORE_ELSEWHERE = logit(FITTED_NONE) - logit(ELSEWHERE);
const USUAL_ELEMENTS = 8; // of so many registered elements it is assumed that nearly every movement is for one of them
const MOST_ELSEWHERE = 0.7; // and that this share is for something else where hardly any are registered
const IN_TURN = 64; // of many elements, so many unlikely ones are scored at a time; the others keep their score until it is their turn
const [, LEAST_LEAD_S, LEAST_WAY_PX] = USUAL;
const ELSEWHERE = 0.02;
const SETTINGS = Float64Array.from(prefetch.FITTED);
const NEVER = 1; // the highest threshold of a prefetch: fires at entry only
const LIKELY = 1e-3; // an element of this share is scored each time

/** The cursor, the table of the elements in view, and their shares. */
export class Shares {
  /** In the order of the table. @type {import("./tracker.js").Entry[]} */ entries = [];
  /** The newest row of a prediction. */ answer = UNPREDICTED;
  /** Counts movements. */ movement = 0;
  #memory = new Float64Array(prefetch.STATES); #table = []; #inside = new Float64Array(0); #shares = Float64Array.of(1); #standing = NOBODY;
  #fired = new WeakMap(); #looked = null; #scores = Float64Array.of(0); #lit = Float64Array.of(1); #scoredIn = -1; #turn = 0;
  /** How much likelier than with many elements it is that a movement is for none of them: a logarithm. */ #unknown = 0;

  /** When the newest event was, s, and where, px. @returns {{t: number, x: number, y: number}} */
  get cursor() {
    return { t: this.#memory[T], x: this.#memory[X], y: this.#memory[Y] };
  }

  /** Takes other elements; what is known of those that stay is kept. @param {import("./tracker.js").Entry[]} entries */
  replace(entries) {
    const inside = new Map(this.entries.map((entry, i) => [entry, this.#inside[i] === ENTERED ? INSIDE : this.#inside[i]]));
    const standing = this.entries[this.#standing];
    this.entries = entries;
    this.#table = entries.map(({ row }) => row);
    this.#inside = Float64Array.from(entries, (entry) => inside.get(entry) ?? OUTSIDE);
    this.#shares = new Float64Array(entries.length + 1);
    this.#shares[entries.length] = 1;
    this.#scores = new Float64Array(entries.length + 1);
    this.#lit = new Float64Array(entries.length + 1);
    this.#scoredIn = -1;
    this.#standing = standing ? entries.indexOf(standing) : NOBODY; // -1 where it is gone
    const elsewhere = Math.max(ELSEWHERE, MOST_ELSEWHERE * (1 - entries.filter(({ isHidden }) => !isHidden).length / USUAL_ELEMENTS));
    this.#unknown = logit(elsewhere) - logit(ELSEWHERE);
    const total = entries.reduce((sum, { isHidden, weight }) => sum + (isHidden ? 0 : weight), 0);
    for (const { row, isHidden, weight } of entries) row[LOG_WEIGHT] = isHidden ? -Infinity : Math.log(weight / total);
  }

  /** The share of the element at a place of the table. @param {number} place */
  share(place) {
    return this.#shares[place] ?? 0;
  }

  /** Uses the events of a dispatch. @param {number[][]} rows t, x, y, dx, dy, buttons @returns {import("./tracker.js").Entry[]} the elements they have entered, in turn */
  follow(rows) {
    const near = this.#near(rows), table = near.map((place) => this.#table[place]);
    const inside = Float64Array.from(near, (place) => this.#inside[place]), memory = this.#memory, entered = [];
    for (const [t, x, y, , , buttons] of rows) {
      if (!usable(t, x, y) || (memory[KNOWN] === 1 && t < memory[T])) continue;
      const began = memory[T0], released = follow(memory, t, x, y, buttons & 1);
      if (memory[T0] !== began) this.movement += 1;
      if (released) this.#standing = NOBODY;
      if (enter(table, inside, x, y, released) === 0) continue;
      near.forEach((place, k) => inside[k] === ENTERED && entered.push(this.entries[place]));
    }
    near.forEach((place, k) => { this.#inside[place] = inside[k]; });
    return entered;
  }

  /** The places of the rows that the cursor is in, or may get into by these events. */
  #near(rows) {
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const [, x, y] of rows) [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
    const near = [], table = this.#table;
    for (let i = 0; i < table.length; i += 1) {
      const row = table[i], halfWidth = 0.5 * row[WIDTH], halfHeight = 0.5 * row[HEIGHT];
      const meets = row[CENTRE_X] + halfWidth >= left && row[CENTRE_X] - halfWidth <= right && row[CENTRE_Y] + halfHeight >= top && row[CENTRE_Y] - halfHeight <= bottom;
      if (meets || this.#inside[i] !== OUTSIDE) near.push(i);
    }
    return near;
  }

  /** Computes the shares. @param {number[]|null} answer the row of the newest prediction, null for none */
  weigh(answer) {
    this.answer = answer ?? UNPREDICTED;
    const isWhole = this.#table.length <= 2 * IN_TURN || this.#scoredIn !== this.movement;
    this.#looked = isWhole ? null : this.#inTurn();
    if (isWhole) this.#score(this.#table, this.#scores);
    else this.#scoreSome(this.#looked);
    this.#scoredIn = this.movement;
    this.#shares.set(this.#scores);
    this.#shares[this.#table.length] += this.#unknown;
    normalise(this.#shares);
    this.#lit.set(this.#scores);
    this.#lit[this.#table.length] += MORE_ELSEWHERE;
    normalise(this.#lit);
  }

  /** Writes the logarithms of the shares of some rows, up to a constant, and behind them that of none of them. */
  #score(rows, out) {
    scores(this.#memory, rows, this.answer, FITTED_PAGES, ELSEWHERE, out);
  }

  /** The places of the likely elements, and of some of the others in turn. */
  #inTurn() {
    const count = this.#table.length, places = [];
    for (let i = 0; i < count; i += 1)
      if (this.#shares[i] >= LIKELY || (i - this.#turn + count) % count < IN_TURN) places.push(i);
    this.#turn = (this.#turn + IN_TURN) % count;
    return places;
  }

  /** Scores some elements; the others keep their scores. */
  #scoreSome(places) {
    const some = new Float64Array(places.length + 1);
    this.#score(places.map((i) => this.#table[i]), some);
    places.forEach((place, k) => { this.#scores[place] = some[k]; });
    this.#scores[this.#table.length] = some[places.length];
  }

  /** The elements that a prefetch fires for now, of those that were scored. @returns {import("./tracker.js").Entry[]} */
  worthPrefetching() {
    const places = this.#looked ?? this.entries.map((_, i) => i), none = this.#table.length;
    const entries = places.map((place) => this.entries[place]), table = places.map((place) => this.#table[place]);
    const shares = Float64Array.from([...places, none], (place) => this.#shares[place]);
    const thresholds = Float64Array.from(entries, ({ prefetchFrom }) => Math.min(prefetchFrom, NEVER));
    const fired = Float64Array.from(entries, (entry) => this.#fired.get(entry) ?? prefetch.ARMED);
    const count = prefetch.step(this.#memory, [table, thresholds, new Float64Array(entries.length), fired], shares, SETTINGS);
    entries.forEach((entry, i) => this.#fired.set(entry, fired[i]));
    return count === 0 ? [] : entries.filter((_, i) => fired[i] === prefetch.PREDICTED || fired[i] === prefetch.ENTERED);
  }

  /** The element to highlight because the movement heads for it, if there is one. @returns {import("./tracker.js").Entry|undefined} */
  headedFor() {
    const best = likeliest(this.#lit, this.#table.length);
    const ask = this.entries[best]?.highlightFrom ?? 1, keep = KEEP * (this.entries[this.#standing]?.highlightFrom ?? ask);
    this.#standing = decide(this.#memory, this.#table, this.#lit, this.#standing, this.answer[REMAINING_S], [ask, keep, LEAST_LEAD_S, LEAST_WAY_PX]);
    return this.entries[this.#standing];
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
