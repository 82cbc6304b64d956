// Predictions and events in, proposals out: of targets, and of places that nobody registered. What decides are the laws.

import { LARGEST } from "../laws/records.js";
import * as law from "../laws/targets/choice_law.js";
import * as cursor from "../laws/targets/cursor.js";
import { HIGHEST, LOWEST, rank, USUAL } from "../laws/targets/decision.js";
import * as posterior from "../laws/targets/posterior.js";
import { EFFECTIVE } from "../laws/targets/posterior.js";
import { complete, holder, LEAST, LOG_WEIGHT, MOST_TARGETS, NOBODY } from "../laws/targets/rectangles.js";
import { EventError, ParameterError } from "./errors.js";
import { Ledger } from "./ledger.js";
import { check } from "./parameters.js";
import { REMAINING_S, UNPREDICTED } from "./row.js";
import { general, quoted } from "./words.js";

/**
 * @typedef {import("./stage.js").Row} Row
 * @typedef {{id: unknown, x: number, y: number, width: number, height: number, weight?: number}} Target its upper left corner
 *   and size, px; weight: how likely it is before the cursor moves, relative to the others
 * @typedef {{id: unknown, p: number, action: "propose"|"retract", reason: "predicted"|"entered"|null}} Choice
 * @typedef {{precision?: number, elsewhere?: number, least_lead_s?: number, least_way_px?: number}} Settings precision: share
 *   of proposals that shall be right; elsewhere: share of movements to none of the targets; least_lead_s: a target that the
 *   cursor enters sooner is not predicted; least_way_px: nothing is predicted nearer to the start of the movement
 * @typedef {import("./pipeline.js").Place} Place
 * @typedef {{x: number, y: number, size: number}} Square its centre and side, px
 * @typedef {{id: number, p: number, action: "propose"|"retract", reason: "predicted"|"entered"|null, place: Square}} PlaceChoice
 */

const PARAMETERS = [["precision", ""], ["elsewhere", ""], ["least_lead_s", "s"], ["least_way_px", "px"]].map(
  ([name, unit], place) => ({ name, unit, low: LOWEST[place], high: HIGHEST[place] }));
const ELSEWHERE = PARAMETERS[1];
/** Bounds of the share of proposals that shall be right. */
export const PRECISION = PARAMETERS[0];
const CHANGES = [["retract", null], ["retract", null], ["propose", "predicted"], ["propose", "entered"]]; // as the law returns them
const NOTHING = Object.freeze(/** @type {Choice[]} */ ([]));
const TARGET = ["x", "y", "width", "height", "weight"], MOST = TARGET.map(() => LARGEST);
const PLACE = ["x", "y", "p", "before", "spread"];

/** The table of targets: a row each. Throws a ParameterError for too many, and for what is not usable. @param {Target[]} targets */
function targetTable(targets) {
  if (targets.length > MOST_TARGETS) throw new ParameterError(`at most ${MOST_TARGETS} targets, received ${targets.length}`);
  checkIds("target", targets);
  const table = targets.map(({ weight = 1, ...one }) => rowOf("target", { ...one, weight }, TARGET, LEAST, MOST));
  complete(table);
  return table;
}

/** The table of places: a row each. Throws a ParameterError for what is not usable. @param {Place[]} places */
function placeTable(places) {
  checkIds("place", places);
  return places.map((one) => rowOf("place", one, PLACE, LOWEST, HIGHEST));
}

function checkIds(kind, things) {
  const ids = new Set();
  for (const { id } of things) {
    if (ids.has(id)) throw refused(kind, `the id of a ${kind} must occur once, received ${quoted(id)} twice`, "id", id);
    ids.add(id);
  }
}

/** The named numbers of a target or a place, all within their bounds. */
function rowOf(kind, thing, names, lowest, highest) {
  const row = Float64Array.from(names, (name) => thing[name]);
  const wrong = row.findIndex((value, k) => !(value >= lowest[k] && value <= highest[k]));
  if (wrong < 0) return row;
  const name = names[wrong], unit = kind === "target" && name !== "weight" ? " px" : "";
  const bounds = `[${general(lowest[wrong])}, ${general(highest[wrong])}]${unit}`;
  throw refused(kind, `${name} of ${kind} ${quoted(thing.id)} must lie in ${bounds}, received ${thing[name]}`, name, row[wrong]);
}

/** The error of a target names no field, as in Python: in a message the field is all targets. */
const refused = (kind, message, field, value) => new ParameterError(message, kind === "target" ? { value } : { field, value });

/**
 * Proposes the rectangle that the cursor is heading for, once that is likely enough, and the one that the cursor is in if
 * that is another. A proposal ends when the prediction drops it, when the cursor leaves it, and when the button comes up.
 */
export class Chooser {
  /** What became of the proposals. */ ledger = new Ledger();
  #settings = Float64Array.from(USUAL); #memory = new Float64Array(cursor.STATES);
  #answer = UNPREDICTED; #standing = NOBODY; #over = NOBODY; #ids = []; #targets = [[], new Float64Array(0), Float64Array.of(1)];
  #event = [0, 0, 0, 0]; #own = new Float64Array(0); #known = [];

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
    const table = targetTable(targets), { standing, entered } = this, before = this.#targets[1];
    const where = new Map(this.#ids.map((id, i) => [id, before[i] === law.ENTERED ? law.INSIDE : before[i]]));
    this.#own = Float64Array.from(table, (row) => row[LOG_WEIGHT]);
    if (this.#known.length) void (table, this.#own, this.#known);
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
    if (stood && this.#standing === NOBODY) this.ledger.withdraw(this.#memory[cursor.T], standing);
    return gone;
  }

  /**
   * Takes the person's past into account, best at the first events of each movement: targets in which places lie, or so near
   * that visits of them end there, weigh more; also those that come later. An empty list leaves the weights as they are given.
   * Throws a ParameterError, nothing changed, for places that are not usable.
   * @param {Place[]} places of `Pipeline.places`
   */
  expect(places) {
    this.#known = placeTable(places);
    void (this.#targets[0], this.#own, this.#known);
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

  /** The target that is likeliest of all, none of them included; null where none of them is. @returns {unknown} */
  get target() {
    const [best] = this.likeliest(1);
    return best !== undefined && best.p >= this.#targets[2].at(-1) ? best.id : null;
  }

  /**
   * How likely the cursor is heading for this rectangle, which need not be among the targets, rather than for anywhere else,
   * as it was after the last event. Throws a ParameterError.
   * @param {Target} target @param {number} [elsewhere] share of movements that go elsewhere, before anything is seen @returns {number}
   */
  headingTo(target, elsewhere = 0.5) {
    check(ELSEWHERE, elsewhere);
    const shares = new Float64Array(2);
    posterior.scores(this.#memory, targetTable([target]), this.#answer, posterior.FITTED, elsewhere, shares);
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
    return this.#take(event, (now) => law.decide(this.#memory, now, this.#answer, this.#targets, posterior.FITTED, this.#settings, this.#standing));
  }

  /**
   * `update` where something else says how likely each target is: the same decisions follow. Throws as `update` does.
   * @param {ArrayLike<number>} shares of each target in their order, and of none of them; they sum to 1
   * @param {number} remaining the time left that is predicted, s; NaN where none is @param {Row} event @returns {readonly Choice[]}
   */
  updateWithShares(shares, remaining, event) {
    this.checkEvent(event);
    this.#targets[2].set(shares);
    return this.#take(event, (now) => law.decide(this.#memory, now, remaining, this.#targets, this.#settings, this.#standing));
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
    return this.#note(t, chosen, over, entered, released);
  }

  /** The smallest target that holds a point, of equal ones the nearest; null: none. @param {number} x px @param {number} y px @returns {unknown} */
  holder(x, y) {
    const place = holder(this.#targets[0], x, y);
    return place === NOBODY ? null : this.#ids[place];
  }

  /** Where the cursor is, px; null before the first event. @returns {[number, number]|null} */
  get cursor() {
    const memory = this.#memory;
    return memory[cursor.KNOWN] === 1 ? [memory[cursor.X], memory[cursor.Y]] : null;
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
    const before = [this.#standing, this.#over], now = [chosen, over];
    if (before[0] === chosen && before[1] === over && entered === 0) return NOTHING;
    [this.#standing, this.#over] = now;
    if (entered > 0) this.#targets[1].forEach((where, i) => where === law.ENTERED && this.ledger.enter(t, this.#ids[i]));
    if (before[0] !== chosen && before[0] !== NOBODY) this.ledger.withdraw(t, this.#ids[before[0]], released);
    if (before[0] !== chosen && chosen !== NOBODY) this.ledger.propose(t, this.#ids[chosen]);
    if (before[1] !== over && over !== NOBODY) this.ledger.proposeEntered();
    return law.changes(before, now).flatMap((place, k) => {
      const [action, reason] = CHANGES[k];
      return place === NOBODY ? [] : [{ id: this.#ids[place], p: this.#targets[2][place], action, reason }];
    });
  }
}

/** The square around a place that its visits scatter in: as wide as a target of that scatter. @param {Place} place @returns {Square} */
const squareOf = ({ x, y, spread }) => ({ x, y, size: Math.max(EFFECTIVE * spread, expectation.LEAST_PX) });

/** Proposes the place that the cursor is heading for, of those where the person went before, by the rules for targets. */
export class PlaceChooser {
  #chooser; #squares = new Map();

  /** @param {Settings} [settings] without `elsewhere`; throws a ParameterError */
  constructor(settings = {}) {
    this.#chooser = new Chooser([], settings);
  }

  /** What became of the proposals. */
  get ledger() {
    return this.#chooser.ledger;
  }

  /** The place that is predicted now; null: none. @returns {number|null} */
  get standing() {
    return /** @type {number|null} */ (this.#chooser.standing);
  }

  /** The place that is proposed because the cursor is in it, while it is not the predicted one. @returns {number|null} */
  get entered() {
    return /** @type {number|null} */ (this.#chooser.entered);
  }

  /** Changes settings from the next event on; throws a ParameterError. @param {Settings} settings */
  configure(settings) {
    this.#chooser.configure(settings);
  }

  /**
   * Takes in an event, the prediction made at it and the places as they then are; returns what has changed. Where the places
   * are others than before, a proposal of one that is gone is withdrawn first. Throws an EventError,
   * or a ParameterError for places that are not usable, nothing changed.
   * @param {Place[]} places @param {number[]|null} answer row of the prediction @param {number[]} event t, x, y, dx, dy, buttons
   * @returns {PlaceChoice[]}
   */
  update(places, answer, event) {
    const ordered = [...places].sort((one, other) => one.id - other.id), rows = placeTable(ordered);
    this.#chooser.checkEvent(event);
    const before = this.#squares, gone = this.#replace(ordered);
    const shares = rows.map((row) => row[expectation.P]), known = shares.reduce((sum, p) => sum + p, 0);
    const changed = this.#chooser.updateWithShares([...shares, Math.max(1 - known, 0)], answer?.[REMAINING_S] ?? NaN, event);
    return [...withPlaces(gone, before), ...withPlaces(changed, this.#squares)];
  }

  /** Closes the movement at the last event: it went to the smallest place that the cursor is in, or to none. @returns {import("./ledger.js").Movement} */
  finish() {
    const { cursor: at } = this.#chooser;
    return this.#chooser.finish(at && this.placeAt(...at));
  }

  /** The smallest place whose square holds this point, of equal ones the nearest; null: none. @returns {number|null} */
  placeAt(x, y) {
    return /** @type {number|null} */ (this.#chooser.holder(x, y));
  }

  /** Forgets every event and the proposals; settings and the counts of the ledger stay. */
  reset() {
    this.#chooser.reset();
  }

  /** Lays out the squares where they have changed. */
  #replace(places) {
    const squares = new Map(places.map((place) => [place.id, squareOf(place)]));
    if (squares.size === this.#squares.size && places.every(({ id }) => isSame(squares.get(id), this.#squares.get(id)))) return [];
    const rectangles = Array.from(squares, ([id, { x, y, size }]) => ({ id, x: x - size / 2, y: y - size / 2, width: size, height: size }));
    const gone = this.#chooser.replace(rectangles);
    this.#squares = squares;
    return gone;
  }
}

const isSame = (one, other) => other !== undefined && one.x === other.x && one.y === other.y && one.size === other.size;
const withPlaces = (choices, squares) => choices.map((one) => ({ ...one, place: squares.get(one.id) }));
