// Predictions and events in, proposals out; as `pointpred/targets/chooser.py`.

import * as law from "../laws/targets/choice_law.js";
import * as cursor from "../laws/targets/cursor.js";
import { NOBODY, rank } from "../laws/targets/decision.js";
import * as posterior from "../laws/targets/posterior.js";
import { expect } from "../laws/targets/expectation.js";
import { LOG_WEIGHT } from "../laws/targets/rectangles.js";
import { EventError } from "./errors.js";
import { Ledger } from "./ledger.js";
import { check } from "./parameters.js";
import { UNPREDICTED } from "./row.js";
import { checkPlaces, tableOf } from "./targets.js";

/**
 * @typedef {import("./stage.js").Row} Row
 * @typedef {{id: unknown, x: number, y: number, width: number, height: number, weight?: number}} Target its upper left corner
 *   and size, px; weight: how likely it is before the cursor moves, relative to the others
 * @typedef {{id: unknown, p: number, action: "propose"|"retract", reason: "predicted"|"entered"|null}} Choice
 * @typedef {{precision?: number, elsewhere?: number, least_lead_s?: number, least_way_px?: number}} Settings precision: share
 *   of proposals that shall be right; elsewhere: share of movements to none of the targets; least_lead_s: a target that the
 *   cursor enters sooner is not predicted; least_way_px: nothing is predicted nearer to the start of the movement
 */

const PARAMETERS = [
  { name: "precision", unit: "", low: 0.01, high: 0.999, default: 0.5 },
  { name: "elsewhere", unit: "", low: 1e-6, high: 0.999999, default: 0.02 },
  { name: "least_lead_s", unit: "s", low: 0, high: 10, default: 0 },
  { name: "least_way_px", unit: "px", low: 0, high: 1000, default: 3 },
];
/** Bounds of the share of proposals that shall be right. */
export const PRECISION = PARAMETERS[0];
const NOTHING = Object.freeze(/** @type {Choice[]} */ ([]));

/**
 * Proposes the rectangle that the cursor is heading for, once that is likely enough, and the one that the cursor is in if
 * that is another. A proposal ends when the prediction drops it, when the cursor leaves it, and when the button comes up.
 */
export class Chooser {
  /** What became of the proposals. */ ledger = new Ledger();
  #settings = Float64Array.from(PARAMETERS, (one) => one.default); #memory = new Float64Array(cursor.STATES);
  #answer = UNPREDICTED; #standing = NOBODY; #over = NOBODY; #ids = []; #targets = [[], new Float64Array(0), Float64Array.of(1)];
  #model = [posterior.FITTED, this.#settings]; #event = [0, 0, 0, 0]; #own = new Float64Array(0); #known = [];

  /** @param {Target[]} [targets] @param {Settings} [settings] throws a ParameterError */
  constructor(targets = [], settings = {}) {
    this.configure(settings);
    this.replace(targets);
  }

  /** Changes settings from the next event on; throws a ParameterError and then changes nothing. @param {Settings} settings */
  configure(settings) {
    for (const one of PARAMETERS) if (settings[one.name] !== undefined) check(one, settings[one.name]);
    PARAMETERS.forEach(({ name }, place) => (this.#settings[place] = settings[name] ?? this.#settings[place]));
  }

  /**
   * Takes other targets, at any time; a proposal of one that is gone is withdrawn. Throws a ParameterError for too many, or
   * for one out of bounds; the old ones are then kept.
   * @param {Target[]} targets @returns {Choice[]}
   */
  replace(targets) {
    const table = tableOf(targets), { standing, entered } = this, before = this.#targets[1];
    const where = new Map(this.#ids.map((id, i) => [id, before[i] === law.ENTERED ? law.INSIDE : before[i]]));
    this.#own = Float64Array.from(table, (row) => row[LOG_WEIGHT]);
    if (this.#known.length) expect(table, this.#own, this.#known);
    this.#ids = targets.map(({ id }) => id);
    const shares = new Float64Array(table.length + 1);
    shares[table.length] = 1;
    this.#targets = [table, Float64Array.from(this.#ids, (id) => where.get(id) ?? law.OUTSIDE), shares];
    const places = new Map(this.#ids.map((id, i) => [id, i])), gone = [];
    const place = (id, former) => {
      if (former === NOBODY) return NOBODY;
      if (!places.has(id)) gone.push({ id, p: 0, action: "retract", reason: null });
      return places.get(id) ?? NOBODY;
    };
    const stood = this.#standing !== NOBODY;
    [this.#standing, this.#over] = [place(standing, this.#standing), place(entered, this.#over)];
    if (stood && this.#standing === NOBODY) this.ledger.retract(standing);
    return gone;
  }

  /**
   * Takes the person's past into account, best at the first events of each movement: targets in which places lie, or so near
   * that visits of them end there, weigh more; also those that come later. An empty list leaves the weights as they are given.
   * Throws a ParameterError, nothing changed, for places that are not usable.
   * @param {import("./pipeline.js").Place[]} places of `Pipeline.places`
   */
  expect(places) {
    checkPlaces(places);
    this.#known = places.map(({ x, y, before, spread }) => Float64Array.of(x, y, before, spread));
    expect(this.#targets[0], this.#own, this.#known);
  }

  /** The target that is predicted now; null: none. @returns {unknown} */
  get standing() {
    return this.#standing === NOBODY ? null : this.#ids[this.#standing];
  }

  /** The target that is proposed because the cursor is in it, while it is not the predicted one. @returns {unknown} */
  get entered() {
    return this.#over === NOBODY ? null : this.#ids[this.#over];
  }

  /** How likely each target is after the last event, in their order; the last number: none of them. @returns {Float64Array} */
  get shares() {
    return this.#targets[2].slice();
  }

  /** The likeliest targets and their shares, best first. @param {number} [most] @returns {{id: unknown, p: number}[]} */
  likeliest(most = 5) {
    const count = this.#ids.length, order = new Float64Array(Math.min(most, count)), shares = this.#targets[2];
    rank(shares, count, order);
    return Array.from(order, (place) => ({ id: this.#ids[place], p: shares[place] }));
  }

  /**
   * How likely the cursor is heading for this rectangle, which need not be among the targets, rather than for anywhere else,
   * as it was after the last event. Throws a ParameterError.
   * @param {Target} target @param {number} [elsewhere] share of movements that go elsewhere, before anything is seen @returns {number}
   */
  headingTo(target, elsewhere = 0.5) {
    check(PARAMETERS[posterior.ELSEWHERE], elsewhere);
    const shares = new Float64Array(2);
    posterior.scores(this.#memory, tableOf([target]), this.#answer, posterior.FITTED, elsewhere, shares);
    posterior.normalise(shares);
    return shares[0];
  }

  /**
   * Takes in an event and the prediction made at it, both as rows (null: no prediction), and returns the changes. Throws an
   * EventError for an event that cannot be used, or one before the last; nothing is then changed.
   * @param {Row|null} answer of `Pipeline.advance` @param {Row} event t, x, y, dx, dy, buttons @returns {readonly Choice[]}
   */
  update(answer, event) {
    this.checkEvent(event);
    this.#answer = answer ?? UNPREDICTED;
    return this.#take(event, (now) => law.step(this.#memory, now, this.#answer, this.#targets, this.#model, this.#standing));
  }

  /**
   * `update` where something else says how likely each target is: the same decisions follow. Throws as `update` does.
   * @param {ArrayLike<number>} shares of each target in their order, and of none of them; they sum to 1
   * @param {number} remaining the time left that is predicted, s; NaN where none is @param {Row} event @returns {readonly Choice[]}
   */
  updateWithShares(shares, remaining, event) {
    this.checkEvent(event);
    this.#targets[2].set(shares);
    return this.#take(event, (now) => law.step_with_shares(this.#memory, now, remaining, this.#targets, this.#settings, this.#standing));
  }

  /** Throws an EventError for an event that `update` would refuse. @param {Row} event */
  checkEvent(event) {
    const [t, x, y] = event, memory = this.#memory;
    if (!cursor.usable(t, x, y)) throw new EventError(`an event needs finite numbers within bounds, received ${event}`);
    if (memory[cursor.KNOWN] === 1 && t < memory[cursor.T])
      throw new EventError(`t must not run backwards: ${t} after ${memory[cursor.T]}`, { code: "time_backwards", field: "t", value: t });
  }

  /** Runs a law on an event that was checked, and notes what has changed. */
  #take([t, x, y, , , buttons], step) {
    const now = this.#event;
    [now[0], now[1], now[2], now[3]] = [t, x, y, buttons & 1];
    const released = this.#memory[cursor.PRESSED] > now[3];
    const [chosen, over, entered] = step(now);
    if (chosen === this.#standing && over === this.#over && entered === 0) return NOTHING;
    return this.#note(t, chosen, over, entered, released);
  }

  /**
   * Closes the movement at the last event, a click on a target, in the ledger. The proposal stands until the next movement
   * starts: at the release, without one at the next event.
   * @param {unknown} target its id, null: unknown @returns {import("./ledger.js").Movement}
   */
  finish(target) {
    const memory = this.#memory;
    if (memory[cursor.T0] < memory[cursor.T]) memory[cursor.PRESSED] = 1;
    return this.ledger.finish(memory[cursor.T], target);
  }

  /**
   * Forgets every event and the proposals; targets, settings and the counts of the ledger stay. A target that the cursor is
   * in is not entered again before the cursor has left it, as after a release.
   */
  reset() {
    const [, inside, shares] = this.#targets;
    this.#memory.fill(0);
    [this.#standing, this.#over, this.#answer] = [NOBODY, NOBODY, UNPREDICTED];
    shares.fill(0).fill(1, shares.length - 1);
    inside.forEach((where, i) => (inside[i] = where === law.OUTSIDE ? where : law.RELEASED));
    this.ledger.drop();
  }

  /** Updates the ledger and the current proposals; ends come first. */
  #note(t, chosen, over, entered, released) {
    if (entered > 0) this.#targets[1].forEach((where, i) => where === law.ENTERED && this.ledger.enter(t, this.#ids[i]));
    const [before, beforeOver] = [this.#standing, this.#over], changed = [];
    [this.#standing, this.#over] = [chosen, over];
    const change = (place, action, reason) => changed.push({ id: this.#ids[place], p: this.#targets[2][place], action, reason });
    if (before !== chosen && before !== NOBODY) {
      if (released) this.ledger.end(t, this.#ids[before]);
      else this.ledger.retract(this.#ids[before]);
      change(before, "retract", null);
    }
    if (beforeOver !== over && beforeOver !== NOBODY) change(beforeOver, "retract", null);
    if (chosen !== before && chosen !== NOBODY) {
      this.ledger.propose(t, this.#ids[chosen]);
      change(chosen, "propose", "predicted");
    }
    if (over !== beforeOver && over !== NOBODY) {
      this.ledger.proposeEntered();
      change(over, "propose", "entered");
    }
    // A target whose reason alone has changed stays proposed, so no change is reported.
    const actions = (id) => new Set(changed.filter((one) => one.id === id).map(({ action }) => action));
    return changed.filter(({ id }) => actions(id).size < 2);
  }
}
