// Written by `make page` from region_widening.py: change that and run it again.
import { larger, smaller, square } from "../../arithmetic.js";
import * as $adaptation_moments from "./moments.js";
import * as $stages from "./stages.js";
export const LEVELS = [0.5, 0.8];
export const JUDGED = 9;
export const STEP = 6;
export const STEP_OF = 5;
export const STEP_LEAST = 0.2;
export const FURTHEST = 6;
export const LIGHTEST = 0.02;
export const HEAVIEST = 4;
export const HALVINGS = 12;
export const MOVEMENTS = 0;
export const OFFSETS = 1;
export const MOVEMENTS_MOST = 1000000;
export const X = 1;
export const Y = 2;
export const SXX = 3;
export const SXY = 4;
export const SYY = 5;
export const TAIL = 6;
export const MOMENT = 7;
export const MOST = 48;
export const LOWEST = 1e-06;
export const HIGHEST = 40;
export function squared_radius(level, heavy) {
  return Math.exp(-heavy * Math.log(1 - level)) - 1;
}
export function corrected_radius(level, heavy, offset) {
  const lower = Math.exp(smaller(offset, 0));
  return Math.exp(larger(offset, 0)) * (Math.exp(-heavy * Math.log(1 - level) * lower) - 1);
}
export function offset(memory, at, share, which) {
  const values_1 = $stages.interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  const low = at + OFFSETS + LEVELS.length * stage + which;
  return memory[low] + part * (memory[low + LEVELS.length] - memory[low]);
}
export function widen(memory, at, share, tail) {
  let heavy;
  if (memory[at + MOVEMENTS] === 0) {
    return [1, tail];
  }
  const heavy_now = smaller(larger(2 / tail, LOWEST), HIGHEST);
  const near = Math.log(corrected_radius(LEVELS[0], heavy_now, offset(memory, at, share, 0)) * 2 / heavy_now);
  const far = Math.log(corrected_radius(LEVELS[1], heavy_now, offset(memory, at, share, 1)) * 2 / heavy_now);
  const ratio = Math.exp(far - near);
  let low = LIGHTEST;
  let high = HEAVIEST;
  for (let _ = 0; _ < HALVINGS; _++) {
    heavy = 0.5 * (low + high);
    if (squared_radius(LEVELS[1], heavy) < ratio * squared_radius(LEVELS[0], heavy)) {
      low = heavy;
    } else {
      high = heavy;
    }
  }
  heavy = 0.5 * (low + high);
  const both = squared_radius(LEVELS[0], heavy) * squared_radius(LEVELS[1], heavy) * square(2 / heavy);
  return [Math.exp(0.5 * (near + far - Math.log(both))), 2 / heavy];
}
export function record(memory, at, t, cursor_x, cursor_y, stated) {
  const last = $adaptation_moments.new_moment(memory, at, [t, cursor_x, cursor_y], MOMENT, MOST);
  if (last < 0) {
    return;
  }
  for (let i = 0, end_1 = stated.length; i < end_1; i++) {
    memory[last + X + i] = stated[i];
  }
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
export function add(memory, slot, change) {
  memory[slot] = smaller(larger(memory[slot] + change, -FURTHEST), FURTHEST);
}
export function learn(memory, person, at, place_of_end, span) {
  if (memory[at + $adaptation_moments.COUNT] === 0) {
    return;
  }
  const x = place_of_end[0];
  const y = place_of_end[1];
  memory[person + MOVEMENTS] = smaller(memory[person + MOVEMENTS] + 1, MOVEMENTS_MOST);
  const step = larger(STEP / (memory[person + MOVEMENTS] + STEP_OF), STEP_LEAST);
  let k = 0;
  for (let judged = 1, end_1 = JUDGED + 1; judged < end_1; judged++) {
    const share = judged / (JUDGED + 1);
    k = $adaptation_moments.moment_at(memory, at, k, span, share, MOMENT);
    const within = probability_within(memory, at + $adaptation_moments.FIRST + MOMENT * k, x, y);
    const values_2 = $stages.interpolation(share);
    const stage = values_2[0];
    const part = values_2[1];
    for (let which = 0, end_3 = LEVELS.length; which < end_3; which++) {
      const missed = within <= LEVELS[which] ? LEVELS[which] - 1 : LEVELS[which];
      const low = person + OFFSETS + LEVELS.length * stage + which;
      add(memory, low, step * (1 - part) * missed);
      add(memory, low + LEVELS.length, step * part * missed);
    }
  }
}
