// Written by `make laws` from time_left.py: change that and run it again.
import { larger, smaller, view } from "../../arithmetic.js";
import * as $arrival_intervals from "./arrival_intervals.js";
import * as $moments from "./moments.js";
import * as $time_left_prior from "./time_left_prior.js";
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
export const PRODUCTS = 0;
export const RESIDUALS = 28;
export const LEARNED = 35;
export const LEAST_PIVOT = 0.01;
export const LEFT = 1;
export const SPREAD = 2;
export const FIRST_TERM = 3;
export const MOMENT = 10;
export const MOST = 32;
export const READY = 0;
export const WEIGHTS = 1;
export const MOMENTS = 8;
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
export function factor(memory, person, prior, out) {
  let least = Infinity;
  for (let i = 0; i < SUMS; i++) {
    out[i] = memory[person + PRODUCTS + i] + prior[TERMS + i];
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
export function solve(memory, person, prior, weights) {
  const factors = new Float64Array(SUMS);
  factor(memory, person, prior, factors);
  for (let i = 0; i < TERMS; i++) {
    weights[i] = memory[person + RESIDUALS + i];
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
export function stated(memory, place, cursor, since, median, estimates, way, pace) {
  const person = place[0];
  const intervals = place[1];
  const at = place[2];
  if (memory[at + READY] === 0) {
    solve(memory, person, $time_left_prior.PRIOR, view(memory, at + WEIGHTS, at + MOMENTS));
    memory[at + READY] = 1;
  }
  const known = terms(estimates, way, pace, since, median);
  let total = 0;
  for (let i = 0; i < TERMS; i++) {
    total += memory[at + WEIGHTS + i] * known[i];
  }
  const left = larger(smaller(total, FURTHEST) * median, LEAST * smaller(estimates[1], median));
  const spread = $arrival_intervals.spread(memory, intervals, since / (since + left));
  const moment = $moments.new_moment(memory, at + MOMENTS, cursor, MOMENT, MOST);
  if (moment >= 0) {
    memory[moment + LEFT] = left;
    memory[moment + SPREAD] = spread;
    for (let i = 0; i < TERMS; i++) {
      memory[moment + FIRST_TERM + i] = known[i];
    }
  }
  return [left, spread];
}
export function learn(memory, place, span, median, prior) {
  const person = place[0];
  const intervals = place[1];
  const at = place[2];
  if (memory[at + READY] === 0) {
    return;
  }
  const step = $arrival_intervals.next_step(memory, intervals) / JUDGED;
  for (let i = 0; i < LEARNED; i++) {
    memory[person + i] *= KEEP;
  }
  let k = 0;
  for (let judged = 0; judged < JUDGED; judged++) {
    const share = (judged + 0.5) / JUDGED;
    k = $moments.moment_at(memory, at + MOMENTS, k, span, share, MOMENT);
    const moment = at + MOMENTS + $moments.FIRST + MOMENT * k;
    const seconds = larger(span[1] - memory[moment + $moments.T], SHORTEST_S);
    $arrival_intervals.judge(memory, intervals, share, step, [memory[moment + LEFT], memory[moment + SPREAD]], seconds);
    const left = smaller(seconds / median, FURTHEST);
    let off = left;
    let off_prior = left;
    for (let i = 0; i < TERMS; i++) {
      off -= memory[at + WEIGHTS + i] * memory[moment + FIRST_TERM + i];
      off_prior -= prior[i] * memory[moment + FIRST_TERM + i];
    }
    const weight = 1 / (larger(Math.abs(off), SMALL) * JUDGED);
    for (let i = 0; i < TERMS; i++) {
      const term = weight * memory[moment + FIRST_TERM + i];
      memory[person + RESIDUALS + i] += term * off_prior;
      for (let j = 0, end_1 = i + 1; j < end_1; j++) {
        memory[person + PRODUCTS + Math.floor(i * (i + 1) / 2) + j] += term * memory[moment + FIRST_TERM + j];
      }
    }
  }
}
export function fault(learned) {
  const least = factor(learned, 0, $time_left_prior.PRIOR, new Float64Array(SUMS));
  return least >= LEAST_PIVOT ? [FINE, 0] : [NOT_POSITIVE, least];
}
