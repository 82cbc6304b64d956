// A movement of the embedded sample, replayed where nobody moves: what the page would show.

import { read } from "./service.js";

const REST_MS = 900;
const MOST = 6;

/** Places a movement inside a picture: one scale for both axes. */
export function placed(movement, width, height) {
  const [xs, ys] = [movement.x, movement.y];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min((0.56 * width) / Math.max(1, right - left), (0.5 * height) / Math.max(1, bottom - top), 1.6);
  return ([x, y]) => [width / 2 + scale * (x - (left + right) / 2), 0.56 * height + scale * (y - (top + bottom) / 2)];
}

/** The sample's movements, one after another, as they stand at any time. */
export class Demo {
  #movements = []; #began = null; #at = 0;

  constructor(predictor) {
    this.#load(predictor).catch(() => {}); // the page invites without a picture, and asks again when it is opened
  }

  /** Whether there is something to show. */
  get loaded() {
    return this.#movements.length > 0;
  }

  /** Begins again with the next movement. */
  restart() {
    this.#began = null;
  }

  /**
   * @param {number} now ms @param {boolean} still half of a movement, without motion
   * @returns {{movement: object, event: number} | null} up to which event the movement is to be shown
   */
  at(now, still) {
    if (!this.loaded) return null;
    const movement = this.#movements[this.#at % this.#movements.length];
    const last = movement.t[movement.t.length - 1];
    if (still) return { movement, event: this.#event(movement, last / 2) };
    this.#began ??= now;
    const passed = (now - this.#began) / 1000;
    if (passed > last + REST_MS / 1000) {
      this.#began = now;
      this.#at += 1;
      return this.at(now, still);
    }
    return { movement, event: this.#event(movement, passed) };
  }

  #event(movement, passed) {
    const after = movement.t.findIndex((t) => t > passed);
    return after < 0 ? movement.t.length - 1 : Math.max(0, after - 1);
  }

  async #load(predictor) {
    const { samples } = await read("/v1/samples");
    for (const { name } of samples.slice(0, MOST)) {
      const movement = await read(`/v1/samples/${encodeURIComponent(name)}?predictors=${encodeURIComponent(predictor)}`);
      this.#movements.push({ ...movement, predicted: movement.predictions[predictor] });
    }
  }
}
