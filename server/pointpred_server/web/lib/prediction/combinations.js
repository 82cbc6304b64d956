// Values of a differentiator that are each within their bounds, but do not go together.

import { CHATTER_MOST_M_S, chatter, STEPS_M, SUBSTEPS_MOST } from "../laws/differentiators/homogeneous.js";
import { ParameterError } from "./errors.js";
import { general } from "./words.js";

const OFF_BOUND = 1e-12; // so little below its bound, alpha was rounded

/**
 * Throws a ParameterError for values that do not go together.
 * @param {string} name of the differentiator @param {Object<string, number>} values @param {import("./stage.js").Stage} stage with these values
 */
export function checkTogether(name, values, stage) {
  const { gap_s: gap, pause_s: pause } = values;
  if (pause < gap) refuse("pause_s", pause, `must be at least gap_s = ${general(gap)} s, received ${general(pause)} s`);
  if (name === "homogeneous") checkHomogeneous(values, stage);
}

/** @param {Object<string, number>} values @param {import("./stage.js").Stage} stage */
function checkHomogeneous({ order, alpha, gap_s: gap, step_s: step, gain_lambda: slowest, gain_xi: ratio }, stage) {
  if (alpha * order < -1 - OFF_BOUND)
    refuse("alpha", alpha, `must lie in [-1/order, 0] = [${general(-1 / order)}, 0], received ${alpha}`);
  const longest = SUBSTEPS_MOST * step;
  if (gap > longest)
    refuse("gap_s", gap, `must be at most ${SUBSTEPS_MOST} sub-steps = ${general(longest)} s, received ${gap}`);
  const stable = 2 / (slowest * Math.max(1, ratio ** (order - 1)));
  if (step >= stable)
    refuse(
      "step_s",
      step,
      `must be below ${general(stable)} s, where Euler's method with these gains becomes unstable, received ${step}`,
    );
  if (alpha < 0) checkRest(alpha, step, stage);
}

/**
 * With alpha < 0 the gains grow without bound as the error vanishes: Euler's method must chatter. How far depends on the
 * step; it is measured by running the law, from each of the displacements.
 */
function checkRest(alpha, step, stage) {
  const steps = Math.min(Math.max(Math.round(2 / step), 2000), 20000);
  const speeds = STEPS_M.map((place) => chatter(stage.remembered, place, step, steps));
  if (speeds.every((speed) => speed <= CHATTER_MOST_M_S)) return;
  const message =
    `with step_s = ${general(step)} s, alpha = ${general(alpha)} and these gains the velocity of a device at rest ` +
    `chatters by ${Math.max(...speeds).toPrecision(2)} m/s, at most ${general(CHATTER_MOST_M_S)} m/s: choose a smaller step_s, smaller gains ` +
    "(gain_lambda) or an alpha nearer to 0";
  throw new ParameterError(message, { field: "step_s", value: step });
}

function refuse(field, value, sentence) {
  throw new ParameterError(`${field} ${sentence}`, { field, value });
}
