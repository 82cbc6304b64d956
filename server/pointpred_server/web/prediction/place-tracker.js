// The places of a session without targets: which is proposed because the person went there before.

import { PRECISION } from "./chooser.js";
import { PlaceChooser } from "./place-chooser.js";

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
    this.#chooser.configure({ precision: Math.min(Math.max(precision, PRECISION.low), PRECISION.high) });
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
