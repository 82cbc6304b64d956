// The last movement of the pointer, and how early its end was predicted.

const PAUSE_S = 0.3;
const STILL_S = 0.1;
const MIN_DISTANCE_PX = 100;
const MIN_ROWS = 5;
const MOST_ROWS = 20000;

/** A prediction within this distance of the end is counted as right. */
export const NEAR_PX = 40;

/**
 * @typedef {{distance: number, arrival: number, reached: number, predictors: Earliness[]}} Verdict px; s: when the pointer
 *   arrived, and when it was itself within 40 px for good
 * @typedef {{name: string, lead_s: number|null}} Earliness of a predictor: how long before the arrival its endpoints had come
 *   within 40 px for good, s: 0 if the pointer was there as early; null if there was no prediction, or none in the last
 *   0.3 s before the arrival
 */

/** Collects one movement at a time; a pause of 0.3 s or a press ends it. */
export class Movement {
  #rows = [];
  #predictions = [];
  #end = Infinity;

  /** @param {number[][]} rows events [t, x, y, ...] in the order of time */
  move(rows) {
    for (const row of rows) {
      const last = this.#rows[this.#rows.length - 1];
      if (last !== undefined && (row[0] - last[0] > PAUSE_S || this.#rows.length >= MOST_ROWS)) this.clear();
      this.#rows.push([row[0], row[1], row[2]]);
    }
  }

  /** @param {number} which predictor @param {{t: number, x: number|null, y: number|null}} prediction @param {string} name of the predictor */
  addPrediction(which, prediction, name) {
    (this.#predictions[which] ??= []).push([prediction.t, prediction.x, prediction.y, name]);
    if (this.#predictions[which].length > MOST_ROWS) this.#predictions[which].shift();
  }

  /** A press ends the movement; later events belong to the next one. @param {number} t s */
  press(t) {
    this.#end = Math.min(this.#end, t);
  }

  /** Forgets the movement, but not what came after a press. */
  clear() {
    this.#rows = this.#rows.filter(([t]) => t > this.#end);
    this.#predictions = this.#predictions.map((predictions) => predictions.filter(([t]) => t > this.#end));
    this.#end = Infinity;
  }

  /** How early the end was predicted; null for a movement that is too short. @returns {Verdict|null} */
  verdict() {
    const rows = this.#rows.filter(([t]) => t <= this.#end);
    if (rows.length < MIN_ROWS) return null;
    const [first, end] = [rows[0], rows[rows.length - 1]];
    const distance = distanceTo(first, end);
    if (distance < MIN_DISTANCE_PX) return null;
    const arrival = nearSince(rows, end, Math.max(8, 0.03 * distance));
    const reached = nearSince(rows, end, NEAR_PX);
    const predictors = this.#predictions.map((predictions) => {
      const during = predictions.filter(([t]) => t >= first[0] && t <= arrival);
      const name = during[during.length - 1]?.[3];
      const silent = !during.some(([, x]) => x !== null) || arrival - during[during.length - 1][0] > PAUSE_S;
      if (silent) return { name, lead_s: null }; // a connection lost on the way is not judged
      const near = nearSince(
        during.filter((one) => one[3] === name),
        end,
        NEAR_PX,
      );
      return { name, lead_s: near !== null && near < reached ? arrival - near : 0 };
    });
    return { distance, arrival, reached, predictors };
  }
}

const distanceTo = ([, x, y], [, endX, endY]) => (x === null ? Infinity : Math.hypot(x - endX, y - endY));

/** The time of the first row from which on all are within a distance of a point; null if the last one is not. */
function nearSince(rows, point, px) {
  const after = rows.findLastIndex((row) => distanceTo(row, point) > px) + 1;
  return rows[after]?.[0] ?? null;
}

/**
 * The speed from the sample just before the last 50 ms to the newest one, px/s; 0 if there is none in that time. A sample
 * before a pause of 0.1 s is left out.
 * @param {number[][]} trail [t s, x, y] @param {number} now s
 */
export function speed(trail, now, over = 0.05) {
  const first = trail.findIndex(([t]) => t >= now - over);
  if (first < 0) return 0;
  const before = trail[first - 1];
  const recent =
    before !== undefined && trail[first][0] - before[0] <= STILL_S ? trail.slice(first - 1) : trail.slice(first);
  const path = recent.reduce(
    (sum, [, x, y], i) => sum + (i ? Math.hypot(x - recent[i - 1][1], y - recent[i - 1][2]) : 0),
    0,
  );
  const time = recent[recent.length - 1][0] - recent[0][0];
  return time > 0 ? path / time : 0;
}
