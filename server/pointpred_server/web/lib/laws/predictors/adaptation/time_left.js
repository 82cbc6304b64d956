// Written by `make laws` from time_left.py: change that and run it again.
import { larger, smaller, view } from "../../arithmetic.js";
import * as $arrival_intervals from "./arrival_intervals.js";
import * as $moments from "./moments.js";
import * as $time_left_prior from "./time_left_prior.js";
import * as $stage from "../../stage.js";
export const TERMS = 7;
export const SUMS = 28;
export const KEEP = 0.98;
export const JUDGED = 12;
export const SMALL = 0.05;
export const FURTHEST = 20;
export const LEAST = 0.05;
export const LONGEST = 4;
export const NEAR = 0.04;
export const SHORTEST_S = 1e-06;
export const START = 0.1;
export const LEAST_PIVOT = 0.01;
export const MOST = 32;
export const FINE = 0;
export const NOT_POSITIVE = 31;
export function terms(estimates, way, pace, since, median) {
  const mixed = smaller(estimates[0] / median, LONGEST);
  const predicted = smaller(estimates[1] / median, LONGEST);
  const share = way[1] / (way[1] + way[0]);
  const slow = smaller(pace[1] / median, 1) / (since / median + START);
  const near = NEAR * NEAR / (NEAR * NEAR + share * share);
  return [mixed, predicted, 1, share, pace[0] * predicted, slow, near];
}
export function factor(s, prior, out, s_at = 0) {
  let least = Infinity;
  for (let i = 0; i < SUMS; i++) {
    out[i] = s[s_at + i] + prior[TERMS + i];
  }
  for (let i = 0; i < TERMS; i++) {
    const row = Math.floor(i * (i + 1) / 2);
    for (let j = 0, end_1 = i; j < end_1; j++) {
      const column = Math.floor(j * (j + 1) / 2);
      for (let k = 0, end_2 = j; k < end_2; k++) {
        out[row + j] -= out[row + k] * out[column + k];
      }
    }
    for (let j = 0, end_3 = i; j < end_3; j++) {
      const scaled = out[row + j] / out[Math.floor(j * (j + 3) / 2)];
      out[row + i] -= scaled * out[row + j];
      out[row + j] = scaled;
    }
    least = smaller(least, out[row + i]);
  }
  return least;
}
export function solve(s, prior, weights, s_at = 0) {
  const factors = new Float64Array(SUMS);
  factor(s, prior, factors, s_at);
  for (let i = 0; i < TERMS; i++) {
    weights[i] = s[s_at + i + 28];
    for (let j = 0, end_1 = i; j < end_1; j++) {
      weights[i] -= factors[Math.floor(i * (i + 1) / 2) + j] * weights[j];
    }
  }
  for (let i = 0; i < TERMS; i++) {
    weights[i] /= factors[Math.floor(i * (i + 3) / 2)];
  }
  for (let i = TERMS - 1, end_2 = -1; i > end_2; i--) {
    for (let j = i + 1; j < TERMS; j++) {
      weights[i] -= factors[Math.floor(j * (j + 1) / 2) + i] * weights[j];
    }
  }
  for (let i = 0; i < TERMS; i++) {
    weights[i] += prior[i];
  }
}
export function weighed(s, intervals, movement, cursor, since, median, predicted, known, prior, s_at = 0, intervals_at = 0, movement_at = 0) {
  if (movement[movement_at] === 0) {
    solve(s, prior, view(movement, movement_at + 1, movement_at + 8), s_at);
    movement[movement_at] = 1;
  }
  let total = 0;
  for (let i = 0; i < TERMS; i++) {
    total += movement[movement_at + i + 1] * known[i];
  }
  const left = larger(smaller(total, FURTHEST) * median, LEAST * smaller(predicted, median));
  const spread = $arrival_intervals.spread(intervals, since / (since + left), intervals_at);
  const last_at = movement_at + larger(Math.trunc(movement[movement_at + 8]) - 1, 0) * 10 + 12;
  const values_1 = $moments.next_moment(movement, movement[last_at], cursor, MOST, movement_at + 8);
  const number = values_1[0];
  const full = values_1[1];
  if (full) {
    for (let k = 1; k < number; k++) {
      $stage.copy_values(view(movement, movement_at + 2 * k * 10 + 12, movement_at + 2 * k * 10 + 22), view(movement, movement_at + k * 10 + 12, movement_at + k * 10 + 22));
    }
  }
  if (number >= 0) {
    const m_at = movement_at + number * 10 + 12;
    movement[m_at] = cursor[0];
    movement[m_at + 1] = left;
    movement[m_at + 2] = spread;
    for (let i = 0; i < TERMS; i++) {
      movement[m_at + i + 3] = known[i];
    }
  }
  return [left, spread];
}
export function stated(s, intervals, movement, cursor, since, median, estimates, way, pace, s_at = 0, intervals_at = 0, movement_at = 0) {
  const known = terms(estimates, way, pace, since, median);
  return weighed(s, intervals, movement, cursor, since, median, estimates[1], known, $time_left_prior.PRIOR, s_at, intervals_at, movement_at);
}
export function moment_at(movement, k, span, share, movement_at = 0) {
  while (k + 1 < movement[movement_at + 8] && $moments.has_come(movement, movement[movement_at + (k + 1) * 10 + 12], span, share, movement_at + 8)) {
    k += 1;
  }
  return k;
}
export function learn(s, intervals, movement, span, median, prior, s_at = 0, intervals_at = 0, movement_at = 0) {
  if (movement[movement_at] === 0) {
    return;
  }
  const step = $arrival_intervals.next_step(intervals, intervals_at) / JUDGED;
  for (let i = 0; i < SUMS; i++) {
    s[s_at + i] *= KEEP;
  }
  for (let i = 0; i < TERMS; i++) {
    s[s_at + i + 28] *= KEEP;
  }
  let k = 0;
  for (let judged = 0; judged < JUDGED; judged++) {
    const share = (judged + 0.5) / JUDGED;
    k = moment_at(movement, k, span, share, movement_at);
    const m_at = movement_at + k * 10 + 12;
    const seconds = larger(span[1] - movement[m_at], SHORTEST_S);
    $arrival_intervals.judge(intervals, share, step, [movement[m_at + 1], movement[m_at + 2]], seconds, intervals_at);
    const left = smaller(seconds / median, FURTHEST);
    let off = left;
    let off_prior = left;
    for (let i = 0; i < TERMS; i++) {
      off -= movement[movement_at + i + 1] * movement[m_at + i + 3];
      off_prior -= prior[i] * movement[m_at + i + 3];
    }
    const weight = 1 / (larger(Math.abs(off), SMALL) * JUDGED);
    for (let i = 0; i < TERMS; i++) {
      const term = weight * movement[m_at + i + 3];
      s[s_at + i + 28] += term * off_prior;
      for (let j = 0, end_1 = i + 1; j < end_1; j++) {
        s[s_at + Math.floor(i * (i + 1) / 2) + j] += term * movement[m_at + j + 3];
      }
    }
  }
}
export function fault(learned, prior, learned_at = 0) {
  const least = factor(learned, prior, new Float64Array(SUMS), learned_at);
  return least >= LEAST_PIVOT ? [FINE, 0] : [NOT_POSITIVE, least];
}
