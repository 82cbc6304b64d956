// The table of a circle run: a row for each movement, with what was shown while it was made.

import { UNPREDICTED } from "../../lib/prediction/row.js";
import { number } from "../shell/numbers.js";

/**
 * How far the predictions that were shown during a movement were from its end, as `pointpred score` measures it: at each sample the
 * newest one counts, and the pointer itself before the first.
 * @param {import("../study/task.js").Trial} trial @param {import("../../lib/index.d.ts").Prediction[]} shown in the order of time
 */
export async function scoreOfShown({ start, rows }, shown) {
  const { scoreOfAnswers } = await import("../../lib/prediction/scoring.js");
  const own = shown.filter(({ t }) => t > start[0]);
  const samples = rows.map(([t, x, y, dx, dy, buttons]) => [t, x, y, dx ?? NaN, dy ?? NaN, buttons]);
  let next = 0;
  return scoreOfAnswers({ rows: samples, count: samples.length }, (part) =>
    part.map(([t]) => {
      while (next < own.length && own[next].t <= t) next += 1;
      const { x = null, y = null } = own[next - 1] ?? {};
      return x === null || y === null ? UNPREDICTED : UNPREDICTED.with(0, t).with(1, x).with(2, y);
    }),
  );
}

/** The newest movement is on top. */
export class CircleRows {
  #body;

  /** @param {HTMLTableSectionElement} body */
  constructor(body) {
    this.#body = body;
  }

  /** @param {import("../study/task.js").Trial} trial @param {import("../../lib/index.d.ts").Prediction[]} shown the predictions during it */
  async add(trial, shown) {
    const row = this.#body.insertRow(0);
    row.classList.toggle("missed", !trial.hit);
    const texts = [`${trial.sequence.block}.${trial.number}`, number(trial.end[0] - trial.start[0], 2), "…", "…", "…"];
    const cells = texts.map((text) => {
      const cell = row.insertCell();
      cell.textContent = text;
      return cell;
    });
    const { time_averaged_px: px, hold_px: hold, skill, reason } = await scoreOfShown(trial, shown);
    const why = shown.length ? reason : "nothing was predicted";
    const scores = why ? ["none", "–", "–"] : [number(px, 1), number(hold, 1), number(skill, 2)];
    scores.forEach((text, i) => (cells[2 + i].textContent = text));
    if (why) row.title = `Not scored: ${why}`;
    row.dataset.px = String(px);
  }

  clear() {
    this.#body.replaceChildren();
  }
}
