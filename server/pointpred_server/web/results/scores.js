// The scores that the service has computed for a recording, as a sentence, a table and lines.

import { fillTable } from "../page/elements.js";
import { count, number, percent } from "../page/numbers.js";
import { BASELINE } from "./highlights.js";

/** The set in the answer; throws an error with the service's reason if nothing could be scored. */
export function setOf(answer) {
  const set = answer.sets?.[0];
  if (set === undefined) throw new Error(answer.unread?.[0]?.reason ?? "the service found no recording");
  if (set.trials === 0) throw new Error(`no movement could be scored (${set.skipped[0]?.reason ?? "there is none"})`);
  return set;
}

/** How many movements were scored, which predictor was best, and how many movements were left out. */
export function summary({ trials, skipped, predictors }) {
  const [best] = ranked(predictors);
  const omitted = skipped.length ? ` ${skipped.length} left out, the first because it ${skipped[0].reason}.` : "";
  return `${count(trials, "movement")} scored by the service, as by pointpred score. ${bestText(best)}${omitted}`;
}

function bestText({ name, time_averaged: { px, of_hold: ratio } }) {
  if (name === BASELINE) return "No predictor is better than no prediction (hold).";
  const gain = ratio === null ? "" : `, ${percent(1 - ratio)} less than without prediction (hold)`;
  return `Lowest error: ${name}, ${number(px, 1, "px")}${gain}.`;
}

/** Predictors by their time-averaged error, best first. */
export const ranked = (predictors) => [...predictors].sort((a, b) => errorOf(a) - errorOf(b));

const errorOf = ({ time_averaged: { px } }) => px ?? Infinity;

const HEADS = ["predictor", "error, px", "error / hold", "95 % interval", "px at half time", "px at half distance", "answered"];

/** Fills the table with a placeholder in every cell, so that nothing moves when the numbers come. */
export function fillPlaceholders(table, names, placeholder = "…") {
  fillTable(table, [HEADS, ...names.map((name) => [name, ...HEADS.slice(1).map(() => placeholder)])]);
}

/** The interval of a ratio; a single movement has none, nor has the ratio of hold to itself. */
const intervalText = (name, interval) => (interval && name !== BASELINE ? interval.map((bound) => number(bound, 2)).join(" to ") : "–");

/** Fills the table with the time-averaged errors of all predictors, best first. */
export function fillScores(table, set) {
  const sorted = ranked(set.predictors);
  fillTable(table, [
    HEADS,
    ...sorted.map(({ name, time_averaged: { px, of_hold: ratio, interval }, by_time: time, by_path: path, coverage }) => [
      name, number(px, 1), number(ratio, 2), intervalText(name, set.trials > 1 ? interval : null),
      number(time["0.5"]?.px, 1), number(path["0.5"]?.px, 1), percent(coverage),
    ]),
  ]);
  sorted.forEach(({ name, time_averaged: { px } }, i) => {
    const row = table.tBodies[0].rows[i];
    row.dataset.predictor = name;
    row.dataset.px = String(px);
  });
}

/** The errors of every predictor at shares of a measure. @param {"by_path"|"by_time"} measure */
export function linesOf(set, measure) {
  const shares = Object.keys(set.predictors[0][measure]).sort((a, b) => a - b);
  const lines = set.predictors.map((one) => ({ name: one.name, errors: shares.map((share) => one[measure][share].px) }));
  return { shares: shares.map(Number), lines };
}
