// The scores that the service gives for a recording, as a table and as lines.

import { count, fill, number, percent } from "../page/elements.js";
import { FLOOR } from "./highlights.js";

/** The one set in the answer to a recording; an error with the service's reason where nothing could be scored. */
export function setOf(answer) {
  const set = answer.sets?.[0];
  if (set === undefined) throw new Error(answer.unread?.[0]?.reason ?? "the service found no recording");
  if (set.trials === 0) throw new Error(`no movement could be scored (${set.skipped[0]?.reason ?? "none there"})`);
  return set;
}

/** What was scored, who was best, and what was left out, with the first reason. */
export function sentence({ trials, skipped, predictors }) {
  const [best] = ranked(predictors);
  const left = skipped.length ? ` ${skipped.length} left out, the first because it ${skipped[0].reason}.` : "";
  return `${count(trials, "movement")} scored by the service, as pointpred score does it. ${verdict(best)}${left}`;
}

function verdict({ name, time_averaged: { px, of_hold: ratio } }) {
  if (name === FLOOR) return "No predictor is better than no prediction (hold).";
  const share = ratio === null ? "" : `, ${percent(1 - ratio)} less than without prediction (hold)`;
  return `Lowest error: ${name}, ${number(px, 1, "px")}${share}.`;
}

/** Predictors by their time-averaged error, the best first. */
export const ranked = (predictors) => [...predictors].sort((a, b) => errorOf(a) - errorOf(b));

const errorOf = ({ time_averaged: { px } }) => px ?? Infinity;

const HEADS = ["predictor", "error, px", "error / hold", "95 % interval", "px at half time", "px at half way", "answered"];

/** The table before its numbers are known, as high as with them: nothing moves when they come. Dashes where none will. */
export function expectScores(table, names, cell = "…") {
  fill(table, [HEADS, ...names.map((name) => [name, ...HEADS.slice(1).map(() => cell)])]);
}

/** The interval of a ratio: there is none of one movement, nor of hold's ratio to itself. */
const range = (name, interval) => (interval && name !== FLOOR ? interval.map((bound) => number(bound, 2)).join(" to ") : "–");

/** Time-averaged errors of all predictors, the best first. */
export function scoreTable(table, set) {
  const sorted = ranked(set.predictors);
  fill(table, [
    HEADS,
    ...sorted.map(({ name, time_averaged: { px, of_hold: ratio, interval }, by_time: time, by_path: path, coverage }) => [
      name, number(px, 1), number(ratio, 2), range(name, set.trials > 1 ? interval : null),
      number(time["0.5"]?.px, 1), number(path["0.5"]?.px, 1), percent(coverage),
    ]),
  ]);
  sorted.forEach(({ name, time_averaged: { px } }, i) => {
    const row = table.tBodies[0].rows[i];
    row.dataset.predictor = name;
    row.dataset.px = String(px);
  });
}

/** The shares and the errors at them: `measure` is "by_path" or "by_time". */
export function linesOf(set, measure) {
  const shares = Object.keys(set.predictors[0][measure]).sort((a, b) => a - b);
  const lines = set.predictors.map((one) => ({ name: one.name, errors: shares.map((share) => one[measure][share].px) }));
  return { shares: shares.map(Number), lines };
}
