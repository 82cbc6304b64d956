// Proposals without targets: the places where the person went before; as `pointpred/targets/place_chooser.py`.

import { EFFECTIVE } from "../laws/targets/rectangle_mass.js";
import { Chooser } from "./chooser.js";
import { REMAINING_S } from "./row.js";
import { checkPlaces } from "./targets.js";

/**
 * @typedef {import("./pipeline.js").Place} Place
 * @typedef {{x: number, y: number, size: number}} Square its centre and side, px
 * @typedef {{id: number, p: number, action: "propose"|"retract", reason: "predicted"|"entered"|null, place: Square}} PlaceChoice
 */

/** Size of the smallest place: what people point at is hardly smaller. */
const LEAST_PX = 16;

/** The square around a place that its visits scatter in: as wide as a target of that scatter. @param {Place} place @returns {Square} */
const squareOf = ({ x, y, spread }) => ({ x, y, size: Math.max(EFFECTIVE * spread, LEAST_PX) });

/** Proposes the place that the cursor is heading for, of those where the person went before, by the rules for targets. */
export class PlaceChooser {
  #chooser; #squares = new Map(); #cursor = null;

  /** @param {import("./chooser.js").Settings} [settings] without `elsewhere`; throws a ParameterError */
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

  /** Changes settings from the next event on; throws a ParameterError. @param {import("./chooser.js").Settings} settings */
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
    checkPlaces(places);
    this.#chooser.checkEvent(event);
    const before = this.#squares, ordered = [...places].sort((one, other) => one.id - other.id);
    const gone = this.#replace(ordered);
    this.#cursor = [event[1], event[2]];
    const shares = ordered.map(({ p }) => p), known = shares.reduce((sum, p) => sum + p, 0);
    const changed = this.#chooser.updateWithShares([...shares, Math.max(1 - known, 0)], answer?.[REMAINING_S] ?? NaN, event);
    return [...withPlaces(gone, before), ...withPlaces(changed, this.#squares)];
  }

  /** Closes the movement at the last event: it went to the smallest place that the cursor is in, or to none. @returns {import("./ledger.js").Movement} */
  finish() {
    return this.#chooser.finish(this.#cursor && this.placeAt(...this.#cursor));
  }

  /** The smallest place whose square holds this point, of equal ones the nearest; null: none. @returns {number|null} */
  placeAt(x, y) {
    let [best, least, nearest] = [null, Infinity, Infinity];
    for (const [id, square] of this.#squares) {
      const across = Math.abs(x - square.x), down = Math.abs(y - square.y), away = across + down;
      if (Math.max(across, down) > square.size / 2 || square.size > least || (square.size === least && away >= nearest)) continue;
      [best, least, nearest] = [id, square.size, away];
    }
    return best;
  }

  /** Forgets every event and the proposals; settings and the counts of the ledger stay. */
  reset() {
    this.#chooser.reset();
    this.#cursor = null;
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
