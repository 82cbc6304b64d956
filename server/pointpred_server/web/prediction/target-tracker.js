// What a session proposes: among its targets, with how good that was; without targets, among the person's places.

import { Chooser, PlaceChooser, PRECISION } from "./chooser.js";
import { ParameterError } from "./errors.js";
import { ProtocolError } from "./messages.js";

/** A share brought within the bounds of choosers. @param {number} precision 0 to 1 */
const withinBounds = (precision) => Math.min(Math.max(precision, PRECISION.low), PRECISION.high);

/** Decides among the targets of a session; what it proposes and retracts is sent. */
export class TargetTracker {
  #send; #chooser = new Chooser(); #targets = []; #lastTime = null; #known = [];

  /** @param {(message: object) => void} send @param {number|null} precision share of proposals that shall be right, null: the chooser's own */
  constructor(send, precision) {
    this.#send = send;
    if (precision !== null) this.configure(precision);
  }

  /** The share of proposals that shall be right, brought within the bounds of the chooser. @param {number} precision 0 to 1 */
  configure(precision) {
    this.#chooser.configure({ precision: withinBounds(precision) });
  }

  /** Replaces the targets; a proposal of one that is gone is retracted. Throws a ProtocolError. @param {import("./chooser.js").Target[]} targets */
  replace(targets) {
    let changes;
    try {
      changes = this.#chooser.replace(targets);
    } catch (error) {
      if (!(error instanceof ParameterError)) throw error;
      throw new ProtocolError("bad_field", error.message, "$.targets", error);
    }
    this.#targets = targets;
    this.#announce(this.#lastTime, changes);
  }

  /**
   * Takes into account where the person went before, where that has changed. The order is that of the places' numbers, so that
   * sums of shares do not depend on the likeliest now.
   * @param {import("./pipeline.js").Place[]} places
   */
  expect(places) {
    const known = [...places].sort((one, other) => one.id - other.id), former = this.#known;
    this.#known = known;
    if (known.length === former.length && known.every((place, i) => isKnown(place, former[i]))) return;
    this.#chooser.expect(known);
  }

  /** Forgets every event; what is proposed is retracted. */
  reset() {
    const proposed = [this.#chooser.standing, this.#chooser.entered].filter((id) => id !== null);
    this.#announce(this.#lastTime, proposed.map((id) => ({ id, p: 0, action: "retract", reason: null })));
    this.#chooser.reset();
    this.#lastTime = null;
  }

  /** Decides after an event and its prediction. @param {number[]} event @param {number[]} answer */
  follow(event, answer) {
    const changes = this.#chooser.update(answer, event);
    this.#lastTime = event[0];
    if (changes.length) this.#announce(event[0], changes);
  }

  /** The likeliest five and their probabilities. @returns {{id: string, p: number}[]} */
  get likeliest() {
    return this.#chooser.likeliest();
  }

  /** The target that is likeliest of all, null where none of them is. @returns {string|null} */
  get target() {
    return this.#chooser.target;
  }

  /** Finishes the movement: how good its proposals were, null where the goal is unknown. @param {{x: number, y: number}|null} goal */
  finishTrial(goal) {
    if (goal === null) return null;
    const { proposed, hit, wasted, lead_entry_s } = this.#chooser.finish(this.#targetAt(goal));
    return { fired: proposed, hit, wasted, lead_s: lead_entry_s };
  }

  #announce(t, changes) {
    for (const { id, p, action, reason } of changes) this.#send({ type: "choice", id, p, action, t, reason });
  }

  /** The target that holds the goal's centre, the one with the nearest centre; null without any. */
  #targetAt({ x, y }) {
    let nearest = null, least = Infinity;
    for (const one of this.#targets) {
      const across = Math.abs(one.x + one.width / 2 - x), down = Math.abs(one.y + one.height / 2 - y);
      if (across <= one.width / 2 && down <= one.height / 2 && across + down < least) [nearest, least] = [one.id, across + down];
    }
    return nearest;
  }
}

/** Whether a place is as it was before the movement. */
const isKnown = (one, other) => one.x === other.x && one.y === other.y && one.before === other.before && one.spread === other.spread;

/** Decides among the places of a person; what it proposes and retracts is sent. */
export class PlaceTracker {
  #send; #chooser = new PlaceChooser(); #proposed = new Map(); #lastTime = null;

  /** @param {(message: object) => void} send @param {number|null} precision share of proposals that shall be right, null: the chooser's own */
  constructor(send, precision) {
    this.#send = send;
    if (precision !== null) this.configure(precision);
  }

  /** The share of proposals that shall be right, brought within the bounds of the chooser. @param {number} precision 0 to 1 */
  configure(precision) {
    this.#chooser.configure({ precision: withinBounds(precision) });
  }

  /** Decides after an event, its prediction, and the places as they then are. @param {number[]} event @param {number[]} answer @param {import("./pipeline.js").Place[]} places */
  follow(event, answer, places) {
    this.#lastTime = event[0];
    for (const choice of this.#chooser.update(places, answer, event)) this.#announce(choice);
  }

  /** Forgets every event; what is proposed is retracted. */
  reset() {
    for (const choice of [...this.#proposed.values()]) this.#announce({ ...choice, p: 0, action: "retract", reason: null });
    this.#chooser.reset();
    this.#lastTime = null;
  }

  #announce(choice) {
    const { id, p, action, reason, place } = choice;
    if (action === "propose") this.#proposed.set(id, choice);
    else this.#proposed.delete(id);
    this.#send({ type: "choice", id: `place ${id}`, p, action, t: this.#lastTime, reason, place });
  }
}
