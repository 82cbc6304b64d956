// The score of a trial, as `pointpred score` gives it.

import { EVENT_FIELDS } from "../laws/fields.js";
import {
  BY_PATH,
  BY_TIME,
  FRACTIONS,
  MEASURES,
  measure_trial as measure,
  SINGLE_AXIS,
  SOUND,
  TIME_AVERAGED,
} from "../laws/scoring/measures/endpoint.js";
import * as cutting from "../laws/scoring/trials.js";
import { isRefused, UNPREDICTED } from "./row.js";
import { MOST_EVENTS } from "./trial.js";
import { general } from "./words.js";

const PIECE_MS = 8; // the page is free again after so long
const NO_SCORE = {
  time_averaged_px: null,
  hold_px: null,
  skill: null,
  by_time: {},
  by_path: {},
  reason: null,
  fired: null,
  hit: null,
  wasted: null,
  lead_s: null,
};
const REASONS = new Map([
  [cutting.EMPTY, "has no events"],
  [cutting.ONE_SAMPLE, "has one sample, a movement needs two"],
  [cutting.UNUSABLE, "a value is not finite or out of range"],
  [cutting.BACKWARD, "time runs backwards"],
  [cutting.NEVER_LEFT, `ends within ${general(cutting.ONSET_PX)} px of its start`],
  [
    cutting.ARRIVED,
    `never leaves the ${general(cutting.ARRIVAL_PX)} px (or ${Math.round(100 * cutting.ARRIVAL_SHARE)}%) around its endpoint after the onset`,
  ],
  [cutting.INSTANT, "takes no time from onset to arrival"],
]);

/**
 * The score of a trial as offline, where pipelines are reset at the onset of the movement. The page stays free meanwhile.
 * @param {{rows: number[][], count: number}} trial @param {import("./pipeline.js").Pipeline} pipeline a fresh one
 * @returns {Promise<import("../index.d.ts").Score>}
 */
export const scoreOf = (trial, pipeline) => scoreOfAnswers(trial, (rows) => answersTo(rows, pipeline));

/**
 * The score of a trial whose predictions are at hand, or are made of its rows from the onset on.
 * @param {{rows: number[][], count: number}} trial
 * @param {(rows: number[][]) => Promise<number[][]|null>|number[][]|null} answersOf the answer to each row; null where one is refused
 * @returns {Promise<import("../index.d.ts").Score>}
 */
export async function scoreOfAnswers({ rows, count }, answersOf) {
  /** @returns {import("../index.d.ts").Score} */
  const unscored = (events, reason) => ({ type: "score", events, ...NO_SCORE, reason });
  if (count > MOST_EVENTS) return unscored(count, `has ${count} events, at most ${MOST_EVENTS} are scored`);
  const cut = new Float64Array(cutting.CUTS);
  cutting.cut(rows, [0, rows.length], [cut]);
  const reason = REASONS.get(cut[cutting.VERDICT]);
  if (reason !== undefined) return unscored(count, withEvent(reason, cut, rows));
  const onset = cut[cutting.ONSET],
    part = rows.slice(onset, cut[cutting.STOP]),
    arrival = cut[cutting.ARRIVAL] - onset;
  const none = part.map(() => UNPREDICTED); // where nothing is predicted, the cursor's position is scored
  const hold = /** @type {Float64Array} */ (measured(part, none, arrival)); // positions are finite
  const own = measured(part, (await answersOf(part)) ?? none, arrival) ?? hold;
  const [error, floor] = [own[TIME_AVERAGED], hold[TIME_AVERAGED]];
  return {
    ...unscored(part.length, null),
    time_averaged_px: error,
    hold_px: floor,
    skill: floor > 0 ? 1 - error / floor : null,
    by_time: named(own, BY_TIME, BY_PATH),
    by_path: named(own, BY_PATH, SINGLE_AXIS),
  };
}

/** A reason that names the event it is about, where it is about one. */
function withEvent(reason, cut, rows) {
  if (![cutting.UNUSABLE, cutting.BACKWARD].includes(cut[cutting.VERDICT])) return reason;
  const row = cut[cutting.ROW];
  const numbers = EVENT_FIELDS.map(({ name }, k) => `${name} ${general(rows[row][k])}`);
  return `event ${row} of the trial: ${reason} (${numbers.join(", ")})`;
}

/** The measures of a trial; null where an answer is not finite. */
function measured(rows, answers, arrival) {
  const out = new Float64Array(MEASURES);
  return measure(rows, answers, FRACTIONS, arrival, out) === SOUND ? out : null;
}

/** What a pipeline answers to each row; null where it refuses one. */
async function answersTo(rows, pipeline) {
  const answers = [];
  let since = performance.now();
  for (const row of rows) {
    const answer = pipeline.advance(row);
    if (isRefused(answer)) return null;
    answers.push(answer);
    if (performance.now() - since > PIECE_MS) {
      await new Promise((resolve) => setTimeout(resolve));
      since = performance.now();
    }
  }
  return answers;
}

/** Errors by the share at which they were read. */
const named = (out, first, end) =>
  Object.fromEntries(Array.from(out.subarray(first, end), (error, i) => [FRACTIONS[first - BY_TIME + i], error]));
