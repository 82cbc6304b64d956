// Written by `make laws` from region_widening.py: change that and run it again.
import { larger, smaller, square } from "../../arithmetic.js";
import * as $levels from "./levels.js";
import * as $mixed_region from "./mixed_region.js";
import * as $moments from "./moments.js";
import * as $mixture from "../mixture.js";
export const JUDGED = 9;
export const LIGHTEST = 0.02;
export const HEAVIEST = 4;
export const HALVINGS = 12;
export const MOVEMENTS = 0;
export const OFFSETS = 1;
export const MIXED = 11;
export const MOVEMENTS_MOST = 1000000;
export const X = 1;
export const Y = 2;
export const SXX = 3;
export const SXY = 4;
export const SYY = 5;
export const TAIL = 6;
export const MIXTURE = 7;
export const MOMENT = 45;
export const MOST = 48;
export function widen(memory, at, share, tail) {
  let heavy;
  if (memory[at + MOVEMENTS] === 0) {
    return [1, tail];
  }
  const heavy_now = $mixture.heaviness(tail);
  const own = at + OFFSETS;
  const first = $levels.offset(memory, own, share, 0);
  const second = $levels.offset(memory, own, share, 1);
  const near = Math.log($mixture.corrected_radius($mixture.LEVELS[0], heavy_now, first) * 2 / heavy_now);
  const far = Math.log($mixture.corrected_radius($mixture.LEVELS[1], heavy_now, second) * 2 / heavy_now);
  const ratio = Math.exp(far - near);
  let low = LIGHTEST;
  let high = HEAVIEST;
  for (let _ = 0; _ < HALVINGS; _++) {
    heavy = 0.5 * (low + high);
    if ($mixture.squared_radius_over_tail($mixture.LEVELS[1], heavy) < ratio * $mixture.squared_radius_over_tail($mixture.LEVELS[0], heavy)) {
      low = heavy;
    } else {
      high = heavy;
    }
  }
  heavy = 0.5 * (low + high);
  const half = $mixture.squared_radius_over_tail($mixture.LEVELS[0], heavy);
  const most = $mixture.squared_radius_over_tail($mixture.LEVELS[1], heavy);
  const both = half * most * square(2 / heavy);
  return [Math.exp(0.5 * (near + far - Math.log(both))), 2 / heavy];
}
export function record(memory, at, t, cursor_x, cursor_y, stated) {
  const last = $moments.new_moment(memory, at, [t, cursor_x, cursor_y], MOMENT, MOST);
  if (last < 0) {
    return -1;
  }
  for (let i = 0, end_1 = stated.length; i < end_1; i++) {
    memory[last + X + i] = stated[i];
  }
  return last + MIXTURE;
}
export function probability_within(memory, moment, x, y) {
  const dx = x - memory[moment + X];
  const dy = y - memory[moment + Y];
  const sxx = memory[moment + SXX];
  const sxy = memory[moment + SXY];
  const syy = memory[moment + SYY];
  const determinant = sxx * syy - sxy * sxy;
  const tail = memory[moment + TAIL];
  if (!(determinant > 0)) {
    return 1;
  }
  const far = (syy * dx * dx - 2 * sxy * dx * dy + sxx * dy * dy) / determinant;
  return 1 - Math.exp(-0.5 * tail * Math.log(1 + larger(far, 0) / tail));
}
export function learn(memory, person, at, place_of_end, span) {
  if (memory[at + $moments.COUNT] === 0) {
    return;
  }
  const x = place_of_end[0];
  const y = place_of_end[1];
  memory[person + MOVEMENTS] = smaller(memory[person + MOVEMENTS] + 1, MOVEMENTS_MOST);
  const step = $levels.step_after(memory[person + MOVEMENTS]);
  let k = 0;
  for (let judged = 1, end_1 = JUDGED + 1; judged < end_1; judged++) {
    const share = judged / (JUDGED + 1);
    k = $moments.moment_at(memory, at, k, span, share, MOMENT);
    const moment = at + $moments.FIRST + MOMENT * k;
    const within = probability_within(memory, moment, x, y);
    for (let which = 0, end_2 = $mixture.LEVELS.length; which < end_2; which++) {
      $levels.learn(memory, person + OFFSETS, share, which, within <= $mixture.LEVELS[which], step);
    }
    $mixed_region.judge(memory, person + MIXED, moment + MIXTURE, place_of_end, share, step);
  }
}
