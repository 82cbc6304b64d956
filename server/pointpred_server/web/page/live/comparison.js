// The same movements predicted in the page and by the service: how far the predictions are apart, and how late they are.

import { PredictorConnection } from "../service/predictor-connection.js";
import { cellsOf, part, write } from "../shell/elements.js";
import { median, number } from "../shell/numbers.js";

const EQUAL_PX = 1e-6; // sums are rounded differently
const MOST_DELAYS = 100;
const PLACES = /** @type {const} */ (["page", "service"]);

/** @typedef {{predictor: string, parameters: Object<string, number>}} Settings */

/** Predictions of two sessions for the same events, paired by their times: how far they are apart. */
export class Pairs {
  /** Events that both have answered. */ count = 0;
  /** The largest distance of their endpoints, px; Infinity where only one of them has an endpoint. */ largestPx = 0;
  /** @type {import("../../lib/pointpred.js").Prediction[][]} */ #waiting = [[], []];

  /** Adds a prediction; those of a session come in the order of its events. @param {number} which session @param {import("../../lib/pointpred.js").Prediction} prediction */
  add(which, prediction) {
    this.#waiting[which].push(prediction);
    const [first, second] = this.#waiting;
    while (first.length && second.length) {
      const { t: before } = first[0],
        { t: after } = second[0];
      if (before === after) this.#compare(first.shift(), second.shift());
      else (before < after ? first : second).shift(); // one session has dropped this event
    }
  }

  #compare(one, other) {
    this.count += 1;
    if (one.x === null && other.x === null) return;
    const px = one.x === null || other.x === null ? Infinity : Math.hypot(one.x - other.x, one.y - other.y);
    this.largestPx = Math.max(this.largestPx, px);
  }
}

/** One of both places: its connection, and its newest delays. */
class Side {
  #connection;
  #ends = new Set();
  #delays = [];

  /** @param {"page"|"service"} place @param {Settings} settings @param {{state: () => void, prediction: (one: import("../../lib/pointpred.js").Prediction) => void}} handlers */
  constructor(place, { predictor, parameters }, { state, prediction }) {
    this.#connection = new PredictorConnection(
      predictor,
      {
        state,
        prediction: (one) => {
          if (this.#ends.delete(one.t)) this.#delays = [...this.#delays, this.#connection.delayMs].slice(-MOST_DELAYS);
          prediction(one);
        },
      },
      { parameters, page: place === "page", reply: "event" },
    );
  }

  get isOpen() {
    return this.#connection?.state === "open"; // the first state comes before the connection is known
  }

  /** The median of the newest delays, ms; NaN before the first. */
  get delay() {
    return median(this.#delays);
  }

  send(rows) {
    this.#ends.add(rows.at(-1)[0]);
    this.#connection.send(rows);
  }

  close() {
    this.#connection.close();
  }
}

/** Compares while its box is ticked, over two connections of its own: both then know the same movements. */
export class Comparison {
  #settings;
  #box = /** @type {HTMLInputElement} */ (part("live-compare"));
  #shown = part("live-compared");
  #text = part("live-compare-status");
  #numbers = cellsOf(this.#shown);
  /** @type {Side[]|null} */ #sides = null;
  #pairs = new Pairs();
  #compared = "";
  #began = false;
  #active = false;

  /** @param {() => Settings} settings that are compared now */
  constructor(settings) {
    this.#settings = settings;
    this.#box.addEventListener("change", () => this.#follow());
  }

  /** The view is open. */
  open() {
    this.#active = true;
    this.#follow();
  }

  close() {
    this.#active = false;
    this.#follow();
  }

  /** Sends events to both places, once both can take them. @param {number[][]} rows */
  send(rows) {
    if (this.#sides === null || !this.#sides.every((side) => side.isOpen)) return;
    this.#began = true;
    for (const side of this.#sides) side.send(rows);
  }

  /** Writes the numbers; begins again if the settings have changed. */
  update() {
    if (this.#sides !== null && JSON.stringify(this.#settings()) !== this.#compared) this.#begin();
    const sides = this.#sides;
    if (sides === null) return;
    const { count, largestPx } = this.#pairs;
    PLACES.forEach((place, i) => write(this.#numbers[place], number(sides[i].delay, 2)));
    write(this.#numbers.events, String(count));
    write(this.#numbers.apart, count === 0 ? "–" : apart(largestPx));
    write(this.#text, this.#words(sides));
    this.#shown.dataset.events = String(count);
    this.#shown.dataset.px = String(largestPx);
  }

  /** @param {Side[]} sides */
  #words(sides) {
    if (!sides.every((side) => side.isOpen)) return "Waiting for the service…";
    if (this.#pairs.count === 0) return "Move over the picture.";
    return this.#pairs.largestPx <= EQUAL_PX ? "The predictions are equal." : "The predictions differ.";
  }

  #follow() {
    const compares = this.#active && this.#box.checked;
    this.#shown.hidden = !this.#box.checked;
    if (compares && this.#sides === null) this.#begin();
    if (!compares) this.#end();
  }

  #begin() {
    this.#end();
    const settings = this.#settings();
    this.#compared = JSON.stringify(settings);
    if (settings.predictor === "") return;
    [this.#pairs, this.#began] = [new Pairs(), false];
    const sides = PLACES.map(
      (place, i) =>
        new Side(place, settings, {
          prediction: (one) => sides === this.#sides && this.#pairs.add(i, one),
          state: () => this.#began && this.#sides?.some((side) => !side.isOpen) && this.#begin(), // a new session knows nothing
        }),
    );
    this.#sides = sides;
  }

  #end() {
    const sides = this.#sides;
    this.#sides = null;
    for (const side of sides ?? []) side.close();
  }
}

/** The largest distance in words: its first digit counts. */
const apart = (px) =>
  px === Infinity ? "one missing" : px === 0 ? "0" : px < 0.001 ? px.toExponential(0) : number(px, 3);
