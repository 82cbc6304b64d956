// The table of a circle run: a row for each movement; its scores follow when the service sends them.

import { number } from "../shell/numbers.js";

const SCORES = [2, 3, 4]; // indices of the cells with scores

/** The newest movement is on top; scores arrive in the order of the movements. */
export class CircleRows {
  #body;
  #pending = [];

  /** @param {HTMLTableSectionElement} body */
  constructor(body) {
    this.#body = body;
  }

  /** @param {import("./task.js").Trial} trial @param {boolean} scored whether the service will send its score */
  add({ block, number: index, start, end, hit }, scored) {
    const row = this.#body.insertRow(0);
    row.classList.toggle("missed", !hit);
    const texts = [`${block}.${index}`, number(end[0] - start[0], 2), "…", "…", "…"];
    for (const text of texts) row.insertCell().textContent = text;
    if (scored) this.#pending.push(row);
    else this.#writeUnscored(row);
  }

  /** Writes the score of the oldest movement without one. @param {import("../../lib/index.d.ts").Score} score */
  addScore({ time_averaged_px: px, hold_px: hold, skill, reason }) {
    const row = this.#pending.shift();
    if (row === undefined) return;
    const texts = reason ? ["none", "–", "–"] : [number(px, 1), number(hold, 1), number(skill, 2)];
    SCORES.forEach((cell, i) => (row.cells[cell].textContent = texts[i]));
    if (reason) row.title = `Not scored: ${reason}`;
    row.dataset.px = String(px);
  }

  /** The connection is lost: its movements get no score here; they are in the recording. */
  endSession() {
    for (const row of this.#pending.splice(0)) this.#writeUnscored(row);
  }

  #writeUnscored(row) {
    for (const cell of SCORES) row.cells[cell].textContent = "–";
    row.title = "Not scored here: the connection was lost";
  }

  /** Removes the rows, but still expects their scores, which must not go to later rows. */
  clear() {
    this.#body.replaceChildren();
  }
}
