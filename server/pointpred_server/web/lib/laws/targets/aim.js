// Written by `make laws` from aim.py: change that and run it again.
import { hypot, larger, matrix, smaller, view } from "../arithmetic.js";
import * as $levels from "../predictors/adaptation/levels.js";
import * as $moments from "../predictors/adaptation/moments.js";
import * as $region_widening from "../predictors/adaptation/region_widening.js";
import * as $adaptation_time_left from "../predictors/adaptation/time_left.js";
import * as $mixture from "../predictors/mixture.js";
import * as $stage from "../stage.js";
import * as $arrival from "./arrival.js";
import * as $arrival_prior from "./arrival_prior.js";
import * as $cursor from "./cursor.js";
import * as $targets_endpoint from "./endpoint.js";
import * as $heading from "./heading.js";
import * as $posterior from "./posterior.js";
import * as $rectangles from "./rectangles.js";
export const LIKELY = 0.01;
export const JUDGED_LEAST = 0.02;
export const JUDGED_POINTS = 128;
export const POINTS_LEAST = 8;
export const SIZE_PX = 20;
export function row_of(values) {
  return [values[0], values[1], values[2], values[3], values[4], values[5], values[6], values[7], values[8], values[9]];
}
export function learn_regions(s, movement, end, span, targets, coefficients, s_at = 0, movement_at = 0, coefficients_at = 0) {
  const rows = targets[0];
  const x = end[0];
  const y = end[1];
  s[s_at] = smaller(s[s_at] + 1, $region_widening.MOVEMENTS_MOST);
  const step = $levels.step_after(s[s_at]);
  const shares = new Float64Array(rows.length + 1);
  const parts = matrix(rows.length + 1, 7);
  let k = 0;
  for (let judged = 1, end_1 = $region_widening.JUDGED + 1; judged < end_1; judged++) {
    const share = judged / ($region_widening.JUDGED + 1);
    while (k + 1 < movement[movement_at + 11] && $moments.has_come(movement, movement[movement_at + (k + 1) * 32 + 15], span, share, movement_at + 11)) {
      k += 1;
    }
    const m_at = movement_at + k * 32 + 15;
    const answer = row_of(view(movement, m_at + 7, m_at + 17));
    $posterior.scores(movement, rows, answer, coefficients, movement[movement_at + 1], shares, m_at + 17, coefficients_at);
    $posterior.normalise(shares);
    const predicted = $targets_endpoint.elsewhere(movement, answer, m_at + 17);
    const count = $targets_endpoint.mixture(rows, shares, predicted, JUDGED_LEAST, parts);
    const within = $mixture.content(parts, count, x, y, larger(Math.floor(JUDGED_POINTS / count), POINTS_LEAST));
    const ellipse = [movement[m_at + 1], movement[m_at + 2], movement[m_at + 3], movement[m_at + 4], movement[m_at + 5], movement[m_at + 6]];
    const nearer = $region_widening.probability_within(ellipse, x, y);
    const near = $levels.offset(s, share, 0, s_at + 11);
    const far = $levels.offset(s, share, 1, s_at + 11);
    const tail = predicted[5] === predicted[5] ? predicted[5] : 2 / $mixture.HEAVINESS_LEAST;
    for (let which = 0, end_2 = $mixture.LEVELS.length; which < end_2; which++) {
      const asked = $mixture.corrected_probability($mixture.LEVELS[which], tail, near, far);
      $levels.learn(s, share, which, within <= asked, step, s_at + 11);
      $levels.learn(s, share, which, nearer <= $mixture.LEVELS[which], step, s_at + 1);
    }
  }
}
export function learn_prediction(memory, targets, coefficients, memory_at = 0, coefficients_at = 0) {
  const s_at = memory_at + 200;
  const movement_at = memory_at + 215;
  const person_at = memory_at + 2;
  const end = $heading.ended(memory, targets[0], memory_at);
  if (end === end) {
    const span = [memory[s_at + 5], end];
    learn_regions(memory, memory, [memory[s_at + 2], memory[s_at + 3]], span, targets, coefficients, person_at + 136, movement_at, coefficients_at);
    const usual = $arrival.mean(memory, person_at + 157);
    $adaptation_time_left.learn(memory, memory, memory, span, usual, $arrival_prior.PRIOR, person_at + 159, person_at + 194, movement_at + 1039);
    $arrival.remember(memory, end - memory[s_at + 5], person_at + 157);
  }
}
export function conclude(memory, targets, coefficients, memory_at = 0, coefficients_at = 0) {
  learn_prediction(memory, targets, coefficients, memory_at, coefficients_at);
  $heading.learn_target(memory, targets, memory_at);
}
export function size_of(rows, shares) {
  let size = SIZE_PX * shares[rows.length];
  let total = shares[rows.length];
  for (let i = 0, end_1 = rows.length; i < end_1; i++) {
    size += shares[i] * 0.5 * (rows[i][$rectangles.WIDTH] + rows[i][$rectangles.HEIGHT]);
    total += shares[i];
  }
  return larger(size / total, 1);
}
export function record(movement, s, region, answer, movement_at = 0, s_at = 0) {
  const last_at = movement_at + larger(Math.trunc(movement[movement_at + 11]) - 1, 0) * 32 + 15;
  const values_1 = $moments.next_moment(movement, movement[last_at], [s[s_at + 1], s[s_at + 2], s[s_at + 3]], $heading.MOST, movement_at + 11);
  const number = values_1[0];
  const full = values_1[1];
  if (number < 0) {
    return;
  }
  if (full) {
    for (let k = 1; k < number; k++) {
      $stage.copy_values(view(movement, movement_at + 2 * k * 32 + 15, movement_at + 2 * k * 32 + 47), view(movement, movement_at + k * 32 + 15, movement_at + k * 32 + 47));
    }
  }
  const m_at = movement_at + number * 32 + 15;
  movement[m_at] = s[s_at + 1];
  movement[m_at + 1] = region[0];
  movement[m_at + 2] = region[1];
  movement[m_at + 3] = region[2];
  movement[m_at + 4] = region[3];
  movement[m_at + 5] = region[4];
  movement[m_at + 6] = region[5];
  for (let i = 0, end_2 = answer.length; i < end_2; i++) {
    movement[m_at + i + 7] = answer[i];
  }
  $stage.copy_values(view(s, s_at, s_at + 15), view(movement, m_at + 17, m_at + 32));
}
export function share_passed(since, left, usual) {
  const total = left === left ? since + left : larger(usual, since);
  return total > 0 ? since / total : 0;
}
export function step(memory, event, answer, targets, coefficients, memory_at = 0, coefficients_at = 0) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const buttons = event[5];
  const rows = targets[0];
  const shares = targets[3];
  const s_at = memory_at + 200;
  const movement_at = memory_at + 215;
  const person_at = memory_at + 2;
  if ($cursor.begins(memory, t, Number(Math.trunc(buttons) & 1), s_at)) {
    learn_prediction(memory, targets, coefficients, memory_at, coefficients_at);
  }
  $heading.follow(memory, event, targets, memory_at);
  $heading.weigh(memory, answer, targets, coefficients, memory_at, coefficients_at);
  if (answer[1] !== answer[1] || rows.length === 0) {
    return answer;
  }
  const predicted = $targets_endpoint.elsewhere(memory, answer, s_at);
  memory[movement_at + 4] = 1;
  for (let i = 0, end_1 = predicted.length; i < end_1; i++) {
    memory[movement_at + i + 5] = predicted[i];
  }
  const parts = matrix(rows.length + 1, 7);
  const least = smaller($targets_endpoint.NEGLIGIBLE, 0.5 / larger(rows.length, 1));
  const count = $targets_endpoint.mixture(rows, shares, predicted, least, parts);
  const end = $targets_endpoint.geometric_median(parts, count);
  let region = $targets_endpoint.ellipse(parts, count, end, [x - memory[s_at + 6], y - memory[s_at + 7]]);
  const since = t - memory[s_at + 5];
  let left = answer[6];
  let spread = answer[9];
  const usual = $arrival.mean(memory, person_at + 157);
  if (usual > 0 && left === left) {
    const way = hypot(end[0] - x, end[1] - y);
    const known = $arrival.terms(left, since, usual, way, size_of(rows, shares));
    const values_2 = $adaptation_time_left.weighed(memory, memory, memory, [t, x, y], since, usual, left, known, $arrival_prior.PRIOR, person_at + 159, person_at + 194, movement_at + 1039);
    left = values_2[0];
    spread = values_2[1];
  }
  const share = share_passed(since, left, usual);
  const values_3 = $region_widening.widen(memory, share, region[5], person_at + 136);
  const factor = values_3[0];
  const tail = values_3[1];
  region = [region[0], region[1], factor * region[2], factor * region[3], factor * region[4], tail];
  if (memory[memory_at + 1] === 1) {
    record(memory, memory, region, answer, movement_at, s_at);
  }
  memory[movement_at + 3] = left;
  const phase = answer[7];
  return [t, region[0], region[1], region[2], region[3], region[4], left, phase, tail, spread];
}
export function lay_parts(memory, targets, out, memory_at = 0) {
  const s_at = memory_at + 200;
  const movement_at = memory_at + 215;
  if (memory[movement_at + 4] === 0) {
    return [0, 0, 0];
  }
  const law_of = movement_at + 5;
  const predicted = [memory[law_of + 0], memory[law_of + 1], memory[law_of + 2], memory[law_of + 3], memory[law_of + 4], memory[law_of + 5]];
  const count = $targets_endpoint.mixture(targets[0], targets[3], predicted, LIKELY, out);
  const person_at = memory_at + 2;
  const share = share_passed(memory[s_at + 1] - memory[s_at + 5], memory[movement_at + 3], $arrival.mean(memory, person_at + 157));
  const mixed_at = person_at + 147;
  return [count, $levels.offset(memory, share, 0, mixed_at), $levels.offset(memory, share, 1, mixed_at)];
}
export function fault(learned, learned_at = 0) {
  return $adaptation_time_left.fault(learned, $arrival_prior.PRIOR, learned_at + 159);
}
export const Aim = {
  fill: $stage.copy_values,
  fault: fault,
  settings: 2, learned: 198, states: 1386,
  layout: "f03997548086f9fc",
  slots: [
    { name: "movements held", count: 1, low: 0, high: 64, whole: true },
    { name: "targets taken", count: 64, low: 0, high: 281474976710656, whole: true },
    { name: "kinds of targets taken", count: 64, low: 0, high: 281474976710656, whole: true },
    { name: "visits as each rule of targets has them", count: 5, low: 0, high: 33.36666666666663 },
    { name: "visits to targets", count: 1, low: 0, high: 33.36666666666663 },
    { name: "visits to none of the targets", count: 1, low: 0, high: 33.36666666666663 },
    { name: "movements judged", count: 1, low: 0, high: 1000000, whole: true },
    ...Array.from({ length: 2 }, () => [{ name: "radii of the levels", count: 10, low: -6, high: 6 }]).flat(),
    { name: "sum of durations", count: 1, low: 0, high: 20019999999999.98 },
    { name: "durations", count: 1, low: 0, high: 50.04999999999995 },
    { name: "sums of products", count: 28, low: -16015.999999999984, high: 16015.999999999984 },
    { name: "sums of residuals", count: 7, low: -1000000000, high: 1000000000 },
    { name: "movements with intervals", count: 1, low: 0, high: 1000000, whole: true },
    { name: "spreads", count: 3, low: -3, high: 3 },
  ],
  parameters: [
    { name: "elsewhere", low: 1e-06, high: 0.999999, default: 0.02 },
    { name: "learn", low: 0, high: 1, default: 1, whole: true },
  ],
};
