// What a session proposes: among its targets, with how good that was; without targets, among the person's places.

import { T } from "../laws/targets/cursor.js";
import { Chooser, PlaceChooser, PRECISION } from "./chooser.js";
import { ParameterError } from "./errors.js";
import { ProtocolError } from "./messages.js";

/** Decides among something by a pipeline; what it proposes and retracts is sent. */
class Tracker {
  #send;
  #chooser;
  /** @type {number|null} */ #lastTime = null;

  /**
   * @param {(message: object) => void} send @param {Chooser} chooser
   * @param {number|null} precision share of proposals that shall be right, null: the chooser's own
   */
  constructor(send, chooser, precision) {
    [this.#send, this.#chooser] = [send, chooser];
    if (precision !== null) this.configure(precision);
  }

  /** @type {Chooser} */
  get chooser() {
    return this.#chooser;
  }

  /** Whose targets and places it decides among. @param {import("./pipeline.js").Pipeline} pipeline */
  set pipeline(pipeline) {
    this.#chooser.pipeline = pipeline;
  }

  /** The share of proposals that shall be right, brought within the bounds of the chooser. @param {number} precision 0 to 1 */
  configure(precision) {
    this.#chooser.configure({ precision: Math.min(Math.max(precision, PRECISION.low), PRECISION.high) });
  }

  /** Decides after the pipeline's last event. */
  follow() {
    this.#lastTime = this.#chooser.pipeline.aim.cursor[T];
    this.announce(this.#chooser.update());
  }

  /** Forgets every event. */
  reset() {
    this.#chooser.reset();
    this.#lastTime = null;
  }

  /** @param {readonly import("./chooser.js").Choice[]} choices */
  announce(choices) {
    for (const { id, p, action, reason, place } of choices)
      this.#send({
        type: "choice",
        id: place ? `place ${id}` : id,
        p,
        action,
        t: this.#lastTime,
        reason,
        ...(place && { place }),
      });
  }
}

/** Decides among the targets of a session. */
export class TargetTracker extends Tracker {
  /** Those that were registered last. @type {import("../index.d.ts").Target[]} */ targets = [];

  constructor(send, pipeline, precision) {
    super(send, new Chooser(pipeline), precision);
  }

  /** Replaces the targets; a proposal of one that is gone is retracted. Throws a ProtocolError. @param {import("../index.d.ts").Target[]} targets */
  replace(targets) {
    try {
      this.chooser.pipeline.aim.register(targets);
    } catch (error) {
      if (!(error instanceof ParameterError)) throw error;
      throw new ProtocolError("bad_field", error.message, "$.targets", error);
    }
    this.targets = targets;
    this.announce(this.chooser.followTargets());
  }

  /** Forgets every event; what is proposed is retracted. */
  reset() {
    const proposed = [this.chooser.standing, this.chooser.entered].filter((id) => id !== null);
    this.announce(proposed.map((id) => ({ id, p: 0, action: "retract", reason: null })));
    super.reset();
  }

  /** Finishes the movement: how good its proposals were, null where the goal is unknown. @param {{x: number, y: number}|null} goal */
  finishTrial(goal) {
    if (goal === null) return null;
    const { proposed, hit, wasted, lead_entry_s } = this.chooser.finish(this.#targetAt(goal));
    return { fired: proposed, hit, wasted, lead_s: lead_entry_s };
  }

  /** The target that holds the goal's centre, the one with the nearest centre; null without any. */
  #targetAt({ x, y }) {
    let /** @type {unknown} */ nearest = null,
      least = Infinity;
    for (const one of this.targets) {
      const across = Math.abs(one.x + one.width / 2 - x),
        down = Math.abs(one.y + one.height / 2 - y);
      if (across <= one.width / 2 && down <= one.height / 2 && across + down < least)
        [nearest, least] = [one.id, across + down];
    }
    return nearest;
  }
}

/** Decides among the places of a person. */
export class PlaceTracker extends Tracker {
  #proposed = new Map();

  constructor(send, pipeline, precision) {
    super(send, new PlaceChooser(pipeline), precision);
  }

  /** Forgets every event; what is proposed is retracted. */
  reset() {
    this.announce([...this.#proposed.values()].map((choice) => ({ ...choice, p: 0, action: "retract", reason: null })));
    super.reset();
  }

  announce(choices) {
    for (const choice of choices) {
      if (choice.action === "propose") this.#proposed.set(choice.id, choice);
      else this.#proposed.delete(choice.id);
    }
    super.announce(choices);
  }
}
