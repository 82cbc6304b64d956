// The last movement of the pointer, and how early its end was known on the way; without a screen.

const PAUSE_S = 0.3;
const STILL_S = 0.1;
const LEAST_PX = 100;
const MOST_ROWS = 20000;

/** Within how many px of the end a prediction counts as knowing it. */
export const NEAR_PX = 40;

/**
 * @typedef {{distance: number, arrival: number, reached: number, spoke: Knowledge[]}} Verdict px; s: when the pointer
 *   arrived, and when it was itself within 40 px for good
 * @typedef {{name: string, known: number|null, lead_s: number|null}} Knowledge of a predictor: since when it was within
 *   40 px, s; by how much that was before the arrival, 0 where the pointer was there as early, null where it said nothing or
 *   was cut off 0.3 s or more before the arrival
 */

/** Gathers one movement at a time: a pause of 0.3 s, or a press, separates two. */
export class Movement {
  #rows = []; #answers = []; #end = Infinity;

  /** @param {number[][]} rows events [t, x, y, ...] in the order of their times */
  move(rows) {
    for (const row of rows) {
      const last = this.#rows[this.#rows.length - 1];
      if (last !== undefined && (row[0] - last[0] > PAUSE_S || this.#rows.length >= MOST_ROWS)) this.clear();
      this.#rows.push([row[0], row[1], row[2]]);
    }
  }

  /** @param {number} which place @param {{t: number, x: number|null, y: number|null}} prediction @param {string} name whose it is */
  predicted(which, prediction, name) {
    (this.#answers[which] ??= []).push([prediction.t, prediction.x, prediction.y, name]);
    if (this.#answers[which].length > MOST_ROWS) this.#answers[which].shift();
  }

  /** A press ends the movement; what comes later is another one's. @param {number} t s */
  press(t) {
    this.#end = Math.min(this.#end, t);
  }

  /** Forgets the movement; keeps what came after a press. */
  clear() {
    this.#rows = this.#rows.filter(([t]) => t > this.#end);
    this.#answers = this.#answers.map((answers) => answers.filter(([t]) => t > this.#end));
    this.#end = Infinity;
  }

  /** How early the end was known; null for a mere twitch. @returns {Verdict|null} */
  verdict() {
    const rows = this.#rows.filter(([t]) => t <= this.#end);
    if (rows.length < 5) return null;
    const [first, end] = [rows[0], rows[rows.length - 1]];
    const distance = away(first, end);
    if (distance < LEAST_PX) return null;
    const arrival = since(rows, end, Math.max(8, 0.03 * distance));
    const reached = since(rows, end, NEAR_PX);
    const spoke = this.#answers.map((answers) => {
      const within = answers.filter(([t]) => t >= first[0] && t <= arrival);
      const name = within[within.length - 1]?.[3];
      const silent = !within.some(([, x]) => x !== null) || arrival - within[within.length - 1][0] > PAUSE_S;
      if (silent) return { name, known: null, lead_s: null }; // one that was cut off on the way is not judged
      const known = since(within.filter((one) => one[3] === name), end, NEAR_PX);
      return { name, known, lead_s: known !== null && known < reached ? arrival - known : 0 };
    });
    return { distance, arrival, reached, spoke };
  }
}

const away = ([, x, y], [, endX, endY]) => (x === null ? Infinity : Math.hypot(x - endX, y - endY));

/** The time of the first row from which on all lie so near to a point; null where the last one does not. */
function since(rows, point, px) {
  const after = rows.findLastIndex((row) => away(row, point) > px) + 1;
  return rows[after]?.[0] ?? null;
}

/**
 * Speed from the sample just before the last 50 ms to the newest one, px/s; 0 where nothing came so lately. A sample from
 * before a pause of 0.1 s says nothing of the speed after it.
 * @param {number[][]} trail [t s, x, y] @param {number} now s
 */
export function speed(trail, now, over = 0.05) {
  const first = trail.findIndex(([t]) => t >= now - over);
  if (first < 0) return 0;
  const before = trail[first - 1];
  const recent = before !== undefined && trail[first][0] - before[0] <= STILL_S ? trail.slice(first - 1) : trail.slice(first);
  const way = recent.reduce((sum, [, x, y], i) => sum + (i ? Math.hypot(x - recent[i - 1][1], y - recent[i - 1][2]) : 0), 0);
  const time = recent[recent.length - 1][0] - recent[0][0];
  return time > 0 ? way / time : 0;
}
