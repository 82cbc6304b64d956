// What the live view shows while nobody moves: a simulated movement, predicted by this service as yours will be.

import { askForTakes } from "./takes.js";
import { Movement, NEAR_PX } from "./movement.js";

const REST_S = 1.2;
const RETRY_MS = 2000;

/**
 * @typedef {{take: import("./takes.js").Take, event: number, passed: number}} Moment of a take: after which event, and
 *   the time since it began, s
 */

/** Simulated movements, one after another, as they stand at any time; asked for anew where something about them changes. */
export class Demo {
  #takes = []; #about = ""; #stop = null; #began = null; #at = 0; #failed = -Infinity;

  /**
   * Asks for the movements unless they are there. @param {number} now ms
   * @param {{predictor: string, parameters: object, tiles: object[], width: number, height: number}} about
   */
  ask(now, about) {
    const text = JSON.stringify(about);
    if (text === this.#about || now - this.#failed < RETRY_MS) return;
    this.forget();
    this.#about = text;
    const stop = (this.#stop = new AbortController());
    const mine = (act) => (given) => this.#stop === stop && act(given);
    askForTakes(about, mine((take) => this.#takes.push(take)), stop.signal).catch(mine(() => {
      this.#failed = performance.now(); // the page invites without a picture, and asks again
      if (this.#takes.length === 0) this.#about = "";
    }));
  }

  /** Lets its connection go; what is there stays. */
  close() {
    this.#stop?.abort();
    if (this.#takes.length === 0) this.#about = "";
    this.#stop = null;
  }

  /** Nothing is there any more. */
  forget() {
    this.close();
    [this.#takes, this.#about, this.#began, this.#at] = [[], "", null, 0];
  }

  /** Somebody moves: nothing more is asked for, and the movement begins again when it is next shown. */
  pause() {
    this.close();
    this.#began = null;
  }

  /** @param {number} now ms @param {boolean} still the middle of a movement, without motion @returns {Moment|null} */
  at(now, still) {
    if (this.#takes.length === 0) return null;
    const take = this.#takes[still ? 0 : this.#at % this.#takes.length];
    if (still) return momentOf(take, middle(take));
    this.#began ??= now;
    const passed = (now - this.#began) / 1000;
    if (passed > last(take.rows)[0] + REST_S) {
      [this.#began, this.#at] = [now, this.#at + 1];
      return this.at(now, still);
    }
    const after = take.rows.findIndex(([t]) => t > passed);
    return { take, event: after < 0 ? take.rows.length - 1 : Math.max(0, after - 1), passed };
  }
}

const last = (list) => list[list.length - 1];
const momentOf = (take, event) => ({ take, event, passed: take.rows[event][0] });

/** The event in the middle of the way, or the next one at which a tile is proposed before the pointer is near its end. */
function middle({ rows, proposals }) {
  const [, endX, endY] = last(rows), left = rows.map(([, x, y]) => Math.hypot(x - endX, y - endY));
  const half = left.findIndex((way) => way < left[0] / 2);
  const proposed = proposals.findIndex((id, i) => i >= half && id !== null);
  return proposed < 0 || left[proposed] < NEAR_PX / 2 ? half : proposed;
}

/** How early the end of a take was known, and by how much its tile was proposed before the pointer was there, s. */
export function outcome({ rows, answers, proposals, tile }, predictor, tiles) {
  const movement = new Movement(), offset = answers[0].t - rows[0][0];
  movement.move(rows);
  for (const answer of answers) movement.predicted(0, { ...answer, t: answer.t - offset }, predictor);
  const { x, y, width, height } = tiles.find(({ id }) => id === tile);
  const entry = rows.findIndex(([, px, py]) => px >= x && px <= x + width && py >= y && py <= y + height);
  const standing = proposals.slice(0, entry).findLastIndex((id) => id !== tile) + 1;
  return { verdict: movement.verdict(), tile: { lead_s: standing < entry ? rows[entry][0] - rows[standing][0] : null } };
}
