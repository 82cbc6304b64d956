// Movements of a simulated hand: what the mouse reports, and when.

import { aim, begin, LENGTH, RELEASED, RESTING, report } from "../laws/simulation/hand.js";

const SMALLEST_PX = 6; // a smaller target is aimed at as if it were so large

/** A hand that holds the mouse: the same seed makes the same movements. */
export class Hand {
  #memory = new Float64Array(LENGTH);

  /** @param {number} seed a whole number @param {number} skill from 0, a novice, to 1 @param {{x: number, y: number}} at px */
  constructor(seed, skill, at) {
    begin(this.#memory, seed, skill);
    this.at = at;
  }

  /**
   * Moves to a rectangle, and clicks there if asked to.
   * @param {{x: number, y: number, width: number, height: number}} box px @param {boolean} clicks
   * @returns {{t: number, x: number, y: number, pressed: boolean}[]} a position (px) for each change; the last one when it is over; t in s from now
   */
  reach({ x, y, width, height }, clicks) {
    const start = this.at;
    const size = Math.max(Math.min(width, height), SMALLEST_PX);
    const end = clicks ? RELEASED : RESTING;
    const reports = [];
    let last = { t: 0, ...start, pressed: false };
    let phase = 0;
    aim(this.#memory, x + width / 2 - start.x, y + height / 2 - start.y, size);
    while (phase < end) {
      const [t, right, down, pressed, now] = report(this.#memory);
      const next = { t, x: start.x + right, y: start.y + down, pressed: pressed === 1 };
      phase = now;
      if (next.x !== last.x || next.y !== last.y || next.pressed !== last.pressed || phase >= end) reports.push(next);
      last = next;
    }
    this.at = { x: last.x, y: last.y };
    return reports;
  }
}
