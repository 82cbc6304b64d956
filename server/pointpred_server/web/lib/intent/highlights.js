// What is highlighted: the element that the pointer is heading for, that whose slop it is in, and those that the page chooses.

import { Proposals } from "../client/proposals.js";

const odds = (p) => p / (1 - p);
const LATE_MS = 300; // a highlight ends so long after the pointer should have been there, if it has stopped

/**
 * @typedef {import("./entry.js").Entry} Entry
 * @typedef {{id: Entry, p: number, score?: number|null, t: number|null, reason: import("../index.d.ts").Reason|null, action: "propose"|"retract"}} Choice
 *   `score`: what its threshold was compared with
 */

/**
 * The highlights of a tracker; loaded with the first registration that asks for one.
 * @extends {Proposals<Choice>}
 */
export class Highlights extends Proposals {
  #tracker;
  #laws;
  #standing; // what the law has chosen
  #score = 0; // what its threshold was compared with
  #releases = 0;
  #predicted;
  #over;
  #ending = 0;

  /**
   * @param {import("./tracker.js").Tracker} tracker @param {typeof import("./shares.js").HIGHLIGHTING} laws
   * @param {AbortSignal} signal
   */
  constructor(tracker, laws, signal) {
    super((choice) => this.#fire(choice));
    [this.#tracker, this.#laws] = [tracker, laws];
    signal.addEventListener("abort", () => clearTimeout(this.#ending));
    this.choose();
  }

  /** Chooses by the shares as they are now. */
  choose() {
    const { shares, remaining_s } = this.#tracker,
      { x, y } = shares.cursor,
      predicted = this.#headedFor(),
      over = shares.entries[this.#laws.innermost(shares.table, shares.inside)],
      beside = over?.isBeside(x, y) ? over : undefined; // what the pointer itself is over the page tells
    this.#predicted = this.#turn("predicted", this.#predicted, predicted);
    this.#over = this.#turn("entered", this.#over, beside === predicted ? undefined : beside);
    clearTimeout(this.#ending);
    if (predicted) this.#ending = setTimeout(() => this.#expire(), 1000 * (remaining_s ?? 0) + LATE_MS);
  }

  /** The pointer is elsewhere. */
  pause() {
    this.#expire();
    this.#over = this.#turn("entered", this.#over);
  }

  /** Other elements than these are no longer in view. @param {import("./entry.js").Entry[]} entries */
  keep(entries) {
    for (const [reason, entry] of [
      ["predicted", this.#predicted],
      ["entered", this.#over],
    ])
      if (entry && !entries.includes(entry)) this.#turn(reason, entry, undefined);
    if (!entries.includes(this.#standing)) this.#standing = undefined;
  }

  /**
   * The element that the movement heads for, if there is one. Highlights use higher prior odds that it is for no registered element.
   * @returns {import("./entry.js").Entry|undefined}
   */
  #headedFor() {
    const { shares, remaining_s } = this.#tracker,
      { entries, all, table, state, elsewhere, releases } = shares,
      { decide, likeliest, KEEP, USUAL, FITTED_NONE } = this.#laws,
      [, leastLead_s, leastWay] = USUAL;
    if (releases !== this.#releases) [this.#releases, this.#standing] = [releases, undefined];
    if (!entries.some(({ highlightFrom }) => highlightFrom < Infinity)) return undefined;
    const total = 1 + (odds(FITTED_NONE) / odds(elsewhere) - 1) * all[entries.length];
    const lit = entries.map((_, i) => all[i] / total),
      ask = entries[likeliest(lit, entries.length)]?.highlightFrom ?? 1,
      keep = KEEP * (this.#standing?.highlightFrom ?? ask),
      bounds = [ask, keep, leastLead_s, leastWay];
    const place = decide(state, table, lit, entries.indexOf(this.#standing), remaining_s ?? NaN, bounds);
    [this.#standing, this.#score] = [entries[place], lit[place] ?? 0];
    return this.#standing;
  }

  /** The pointer has stopped on the way: a movement that has not arrived by now is for something else. */
  #expire() {
    this.#standing = undefined;
    this.#predicted = this.#turn("predicted", this.#predicted);
  }

  /** Sets the element that a law highlights. @returns the same */
  #turn(reason, before, now) {
    if (before === now) return before;
    const { t } = this.#tracker.shares.cursor,
      source = `law ${reason}`;
    const isLit = now && now.highlightFrom < Infinity && !now.isUnusable && !now.isCovered;
    if (isLit) {
      const p = this.#tracker.share(now.element),
        score = reason === "predicted" ? this.#score : null;
      this.begin(source, { id: now, p, score, t, reason, action: "propose" });
    }
    if (before) this.end(source, before, { t });
    return now;
  }

  /** @param {Choice} choice */
  #fire({ id: entry, action, reason, p, score, t }) {
    const tracker = this.#tracker;
    for (const one of entry.registrations) {
      if (one.options.policy !== "highlight") continue;
      if (action === "retract") one.withdraw(t ?? performance.now() / 1000);
      else if (one.follows("highlight"))
        one.afterDwell(reason, t, (at) => {
          if (one.mayFire(at, tracker.visit))
            one.fire(tracker.cause(reason, { p, score, threshold: entry.highlightFrom, t: at }), tracker.visit);
        });
    }
  }
}
