// From how likely each target is to proposals: of targets, and of places that nobody registered. What decides are the laws.

import * as law from "../laws/targets/choice_law.js";
import { PRESSED, T, T0, X, Y } from "../laws/targets/cursor.js";
import { HIGHEST, LOWEST, USUAL } from "../laws/targets/decision.js";
import { FIELDS, holder, NOBODY } from "../laws/targets/rectangles.js";
import { keyOf } from "./blake2b.js";
import { Ledger } from "./ledger.js";
import { check } from "./parameters.js";

/**
 * @typedef {{x: number, y: number, size: number}} Square its centre and side, px
 * @typedef {{id: unknown, p: number, action: "propose"|"retract", reason: "predicted"|"entered"|null, place?: Square}} Choice
 *   place: of a place of the person
 * @typedef {{precision?: number, least_lead_s?: number, least_way_px?: number}} Settings precision: share of proposals that shall
 *   be right; least_lead_s: a target that the cursor enters sooner is not predicted; least_way_px: nothing is predicted nearer to
 *   the start of the movement
 * @typedef {{aim: import("./aim.js").Aim, places: import("../index.d.ts").Place[]}} Aimed what choosers ask of a pipeline
 */

const PARAMETERS = [
  ["precision", ""],
  ["least_lead_s", "s"],
  ["least_way_px", "px"],
].map(([name, unit], place) => ({ name, unit, low: LOWEST[place], high: HIGHEST[place] }));
/** Bounds of the share of proposals that shall be right. */
export const PRECISION = PARAMETERS[0];
/** @type {[Choice["action"], Choice["reason"]][]} */
const CHANGES = [
  ["retract", null],
  ["retract", null],
  ["propose", "predicted"],
  ["propose", "entered"],
]; // as the law returns them
const NOTHING = Object.freeze(/** @type {Choice[]} */ ([]));
const PLACE = ["x", "y", "p", "id", "spread"]; // as the law takes a place

/**
 * Proposes the registered target that the cursor is heading for, once that is likely enough, and the one that the cursor is in if
 * that is another. A proposal ends when the prediction drops it, when the cursor leaves it, when the button comes up, and when
 * its target is no longer registered.
 */
export class Chooser {
  /** What became of the proposals. */ ledger = new Ledger();
  #settings = Float64Array.from(USUAL);
  #state = new Float64Array(law.STATES).fill(NOBODY);
  #changes = new Float64Array(CHANGES.length);
  #ids = [];
  #targets = [[], new Float64Array(0), Float64Array.of(1)];
  #keys = [];

  /** @param {Aimed} pipeline whose targets it decides among; may be replaced @param {Settings} [settings] throws a ParameterError */
  constructor(pipeline, settings = {}) {
    this.pipeline = pipeline;
    this.configure(settings);
    void pipeline.aim; // from now on it follows the cursor
  }

  /** Changes settings from the next event on; throws a ParameterError and then changes nothing. @param {Settings} settings */
  configure(settings) {
    for (const one of PARAMETERS) if (settings[one.name] !== undefined) check(one, settings[one.name]);
    PARAMETERS.forEach(({ name }, place) => (this.#settings[place] = settings[name] ?? this.#settings[place]));
  }

  /** The target that is predicted now; null: none. @returns {unknown} */
  get standing() {
    return this.#ids[this.#state[0]] ?? null;
  }

  /** The target that is proposed because the cursor is in it, while it is not the predicted one. @returns {unknown} */
  get entered() {
    return this.#ids[this.#state[1]] ?? null;
  }

  /** Ends the proposals of targets that are no longer registered; `update` does so, too. @returns {readonly Choice[]} */
  followTargets() {
    const { ids, table, keys, shares } = this.pipeline.aim;
    return this.take(ids, table, keys, shares);
  }

  /** Decides after the pipeline's last event; returns what has changed, ends of proposals first. @returns {readonly Choice[]} */
  update() {
    const gone = this.followTargets(),
      changed = this.decide();
    return gone.length ? [...gone, ...changed] : changed;
  }

  /**
   * Closes the movement at the last event, a click on a target, in the ledger. The proposal stands until the next movement starts.
   * @param {unknown} target its id, null: unknown @returns {import("./ledger.js").Movement}
   */
  finish(target) {
    return this.close(target === null ? NOBODY : keyOf(String(target)));
  }

  /** `finish` for the number of a target, NOBODY for none. @param {number} key @returns {import("./ledger.js").Movement} */
  close(key) {
    const { cursor } = this.pipeline.aim;
    if (cursor[T0] < cursor[T]) cursor[PRESSED] = 1; // what comes next is a release
    return this.ledger.close(cursor[T], key);
  }

  /** Forgets the proposals, as the pipeline's `reset` forgets its events; the counts of the ledger stay. */
  reset() {
    law.reset(this.#state, this.#targets[1]);
    this.ledger.drop();
  }

  /** Decides among these targets from now on; the proposals of those that are gone end. @returns {readonly Choice[]} */
  take(ids, table, keys, shares) {
    if (ids === this.#ids) {
      this.#targets = [table, this.#targets[1], shares];
      return NOTHING;
    }
    const inside = new Float64Array(ids.length),
      proposed = [this.standing, this.entered],
      t = this.pipeline.aim.cursor[T];
    const gone = law.replace(
      this.#state,
      t,
      [this.#keys, this.#targets[1]],
      [keys, inside],
      this.ledger.account,
      this.ledger.withRoom(0),
    );
    [this.#ids, this.#keys, this.#targets] = [ids, keys, [table, inside, shares]];
    return proposed.flatMap((id, k) => (gone[k] ? [{ id, p: 0, action: "retract", reason: null }] : []));
  }

  /** Decides by the shares, and notes what has changed. @returns {readonly Choice[]} */
  decide() {
    const {
        aim: { memory },
      } = this.pipeline,
      { account } = this.ledger,
      rows = this.ledger.withRoom(this.#ids.length);
    if (!law.update(this.#state, memory, this.#targets, this.#keys, this.#settings, account, rows, this.#changes))
      return NOTHING;
    return Array.from(this.#changes).flatMap((place, k) => {
      const [action, reason] = CHANGES[k];
      return place === NOBODY ? [] : [{ id: this.#ids[place], p: this.#targets[2][place], action, reason }];
    });
  }
}

/** Proposes the place that the cursor is heading for, of those where the person went before, by the rules for targets. */
export class PlaceChooser extends Chooser {
  #table = [];
  #keys = [];
  #ids = [];
  #squares = new Map();

  /** Ends the proposals of places that are no longer known; `update` does so, too. */
  followTargets() {
    const places = [...this.pipeline.places].sort((one, other) => one.id - other.id),
      { length } = places;
    const rows = (size) => Array.from({ length }, () => new Float64Array(size));
    const [table, keys, shares, before] = [rows(FIELDS), rows(2), new Float64Array(length + 1), this.#squares];
    law.lay_places(
      places.map((one) => PLACE.map((name) => one[name])),
      table,
      keys,
      shares,
    );
    if (String([table, keys]) !== String([this.#table, this.#keys])) {
      [this.#table, this.#keys, this.#ids] = [table, keys, places.map(({ id }) => id)];
      this.#squares = new Map(places.map(({ id }, i) => [id, { x: table[i][0], y: table[i][1], size: table[i][2] }]));
    }
    return withPlaces(this.take(this.#ids, table, keys, shares), before);
  }

  update() {
    return [...this.followTargets(), ...withPlaces(this.decide(), this.#squares)];
  }

  /** Closes the movement at the last event: it went to the smallest place that the cursor is in, or to none. @returns {import("./ledger.js").Movement} */
  finish() {
    const { cursor } = this.pipeline.aim,
      place = holder(this.#table, cursor[X], cursor[Y]);
    return this.close(place === NOBODY ? NOBODY : this.#keys[place][0]);
  }
}

const withPlaces = (choices, squares) => choices.map((one) => ({ ...one, place: squares.get(one.id) }));
