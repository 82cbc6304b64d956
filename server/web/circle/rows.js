// The table of a circle run: a row for each movement, its scores as they come.

import { number } from "../page/elements.js";

const SCORES = [2, 3, 4]; // the cells that wait for the service

/** Rows in the order of their movements, the newest on top; scores come in the same order. */
export class CircleRows {
  #body; #pending = [];

  /** @param {HTMLTableSectionElement} body */
  constructor(body) {
    this.#body = body;
  }

  /** @param {import("./task.js").Trial} trial @param {boolean} expected whether the service was asked for its score */
  add({ block, number: which, start, end, hit }, expected) {
    const row = this.#body.insertRow(0);
    row.classList.toggle("missed", !hit);
    const words = [`${block}.${which}`, number(end[0] - start[0], 2), "…", "…", "…"];
    for (const word of words) row.insertCell().textContent = word;
    if (expected) this.#pending.push(row);
    else this.#without(row);
  }

  /** Writes the score of the first movement that waits for one. @param {import("/pointpred.js").Score} score */
  scored({ time_averaged_px: px, hold_px: hold, skill, reason }) {
    const row = this.#pending.shift();
    if (row === undefined) return;
    const words = reason ? ["none", "–", "–"] : [number(px, 1), number(hold, 1), number(skill, 2)];
    SCORES.forEach((cell, i) => (row.cells[cell].textContent = words[i]));
    if (reason) row.title = `Not scored: ${reason}`;
    row.dataset.px = String(px);
  }

  /** Movements whose connection was lost are not scored one by one; the recording keeps them. */
  lose() {
    for (const row of this.#pending.splice(0)) this.#without(row);
  }

  #without(row) {
    for (const cell of SCORES) row.cells[cell].textContent = "–";
    row.title = "Not scored here: the connection was lost";
  }

  /** Forgets the rows, but not how many scores are still to come: a later row must not get them. */
  clear() {
    this.#body.replaceChildren();
  }
}
