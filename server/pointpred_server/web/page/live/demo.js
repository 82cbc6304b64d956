// What the live view shows while nobody moves: a simulated movement and its predictions.

import { Movement, NEAR_PX } from "./movement.js";
import { requestTakes } from "./takes.js";
import { contains } from "./tiles.js";

const REST_S = 1.2;
const RETRY_MS = 2000;

/**
 * @typedef {{take: import("./takes.js").Take, event: number, time: number}} Moment of a take: the newest event, and the time
 *   since the movement began, s
 */

/** Simulated movements, one after another; they are requested again when the scene changes. */
export class Demo {
  #takes = [];
  #scene = "";
  /** @type {AbortController|null} */ #stop = null;
  /** @type {number|null} */ #began = null;
  #index = 0;
  #failedAt = -Infinity;

  /**
   * Requests the movements unless they are there. @param {number} now ms
   * @param {{predictor: string, parameters: Object<string, number>, tiles: import("../../lib/index.d.ts").NamedTarget[], width: number, height: number}} scene
   */
  request(now, scene) {
    const text = JSON.stringify(scene);
    if (text === this.#scene || now - this.#failedAt < RETRY_MS) return;
    this.#clear();
    this.#scene = text;
    const stop = (this.#stop = new AbortController());
    const current = (handle) => (value) => this.#stop === stop && handle(value);
    requestTakes(
      scene,
      current((take) => this.#takes.push(take)),
      stop.signal,
    ).catch(
      current(() => {
        this.#failedAt = performance.now(); // the page shows nothing here, and tries again
        if (this.#takes.length === 0) this.#scene = "";
      }),
    );
  }

  /** Closes the connection; the movements so far stay. */
  close() {
    this.#stop?.abort();
    if (this.#takes.length === 0) this.#scene = "";
    this.#stop = null;
  }

  /** The person moves: the movement starts again when it is next shown. */
  pause() {
    this.close();
    this.#began = null;
  }

  /** The moment to draw. @param {number} now ms @param {boolean} still the middle of a movement, without motion @returns {Moment|null} */
  at(now, still) {
    if (this.#takes.length === 0) return null;
    const take = this.#takes[still ? 0 : this.#index % this.#takes.length];
    if (still) {
      const event = middleOf(take);
      return { take, event, time: take.rows[event][0] };
    }
    this.#began ??= now;
    const time = (now - this.#began) / 1000;
    if (time > take.rows.at(-1)[0] + REST_S) {
      [this.#began, this.#index] = [now, this.#index + 1];
      return this.at(now, still);
    }
    const after = take.rows.findIndex(([t]) => t > time);
    return { take, event: after < 0 ? take.rows.length - 1 : Math.max(0, after - 1), time };
  }

  #clear() {
    this.close();
    [this.#takes, this.#scene, this.#began, this.#index] = [[], "", null, 0];
  }
}

/** Where the simulated pointer is at a moment, between two events. @param {Moment} moment @param {number} late s after it @returns {number[]} x, y */
export function positionAt({ take: { rows }, event, time }, late) {
  const [t, x, y] = rows[event];
  const [nextT, nextX, nextY] = rows[Math.min(event + 1, rows.length - 1)];
  const share = nextT > t ? Math.min(1, Math.max(0, (time + late - t) / (nextT - t))) : 1;
  return [x + share * (nextX - x), y + share * (nextY - y)];
}

/** The event at half of the distance, or the next one at which a tile is proposed before the pointer is near its end. */
function middleOf({ rows, proposals }) {
  const [, endX, endY] = rows.at(-1),
    distances = rows.map(([, x, y]) => Math.hypot(x - endX, y - endY));
  const half = distances.findIndex((px) => px < distances[0] / 2);
  const proposed = proposals.findIndex((id, i) => i >= half && id !== null);
  return proposed < 0 || distances[proposed] < NEAR_PX / 2 ? half : proposed;
}

/** How early the end of a take was predicted, and how long before the pointer entered its tile it was proposed, s. */
export function judge({ rows, answers, proposals, tile: id }, predictor, tiles) {
  const movement = new Movement(),
    offset = answers[0].t - rows[0][0];
  movement.move(rows);
  for (const answer of answers) movement.addPrediction(0, { ...answer, t: answer.t - offset }, predictor);
  const tile = tiles.find((one) => one.id === id);
  const entry = rows.findIndex(([, x, y]) => contains(tile, x, y));
  const since = proposals.slice(0, entry).findLastIndex((proposed) => proposed !== id) + 1;
  return { verdict: movement.verdict(), tile: { lead_s: since < entry ? rows[entry][0] - rows[since][0] : null } };
}
