// The last movement of the pointer, and how good the predictions were along it; without a screen.

const PAUSE_S = 0.3;
const STILL_S = 0.1;
const LEAST_PX = 60;
const MOST_ROWS = 20000;

/** Gathers one movement at a time: a pause of 0.3 s separates two. */
export class Movement {
  #rows = []; #said = [];

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
    (this.#said[which] ??= []).push([prediction.t, prediction.x, prediction.y, name]);
    if (this.#said[which].length > MOST_ROWS) this.#said[which].shift();
  }

  /** Forgets the movement. */
  clear() {
    this.#rows = [];
    this.#said = [];
  }

  /**
   * What was predicted when half of the time had passed, judged by where the movement ended; null for a mere twitch.
   * @returns {{distance: number, hold: number, errors: (number|null)[], names: (string|undefined)[]} | null} px, and whose
   */
  verdict() {
    if (this.#rows.length < 5) return null;
    const [began, fromX, fromY] = this.#rows[0];
    const [ended, x, y] = this.#rows[this.#rows.length - 1];
    const distance = Math.hypot(x - fromX, y - fromY);
    if (distance < LEAST_PX) return null;
    const half = (began + ended) / 2;
    const away = (row) => (row === undefined || row[1] === null ? null : Math.hypot(row[1] - x, row[2] - y));
    const then = (rows) => rows?.findLast(([t]) => t >= began && t <= half);
    return { distance, hold: away(then(this.#rows)), errors: this.#said.map((rows) => away(then(rows))),
      names: this.#said.map((rows) => then(rows)?.[3]) };
  }
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
