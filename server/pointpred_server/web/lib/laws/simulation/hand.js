// Written by `make laws` from hand.py: change that and run it again.
import { remainder } from "../arithmetic.js";
import * as $records from "../records.js";
import * as $loop from "./loop.js";
import * as $simulation_person from "./person.js";
import * as $simulation_plan from "./plan.js";
import * as $functions from "../transfer/functions.js";
export const PERIOD_S = 0.008;
export const SUBSTEPS = 16;
export const CPI = 2000;
export const DPI = 96;
export const GAIN = 4;
export const M1 = 4294967087;
export const M2 = 4294944443;
export const WARM_UP = 20;
export const LENGTH = 1164;
export const RESTING = 3;
export const RELEASED = 5;
export function uniform(s, s_at = 0) {
  const first = remainder(1403580 * s[s_at + 1] - 810728 * s[s_at], M1);
  const second = remainder(527612 * s[s_at + 5] - 1370589 * s[s_at + 3], M2);
  const value_1 = s[s_at + 1];
  const value_2 = s[s_at + 2];
  const value_3 = first;
  s[s_at] = value_1;
  s[s_at + 1] = value_2;
  s[s_at + 2] = value_3;
  const value_4 = s[s_at + 4];
  const value_5 = s[s_at + 5];
  const value_6 = second;
  s[s_at + 3] = value_4;
  s[s_at + 4] = value_5;
  s[s_at + 5] = value_6;
  const between = first > second ? first - second : first - second + M1;
  return between / (M1 + 1);
}
export function normal(s, s_at = 0) {
  const length = Math.sqrt(-2 * Math.log(uniform(s, s_at)));
  return length * Math.cos(2 * Math.PI * uniform(s, s_at));
}
export function sow(s, seed, s_at = 0) {
  let number = seed + 1;
  for (let i = 0; i < 3; i++) {
    number = remainder(16807 * number, 2147483647);
    s[s_at + i] = number;
    number = remainder(16807 * number, 2147483647);
    s[s_at + i + 3] = number;
  }
  for (let _ = 0; _ < WARM_UP; _++) {
    uniform(s, s_at);
  }
}
export function begin(hand, seed, skill, hand_at = 0) {
  hand.fill(0, hand_at, hand_at + 1164);
  sow(hand, seed, hand_at);
  const normals = new Float64Array($simulation_person.NORMALS);
  for (let i = 0; i < $simulation_person.NORMALS; i++) {
    normals[i] = normal(hand, hand_at);
  }
  $simulation_person.grow(hand, skill, normals, hand_at + 6);
  const settings_at = hand_at + 62;
  hand[settings_at] = PERIOD_S;
  hand[settings_at + 1] = SUBSTEPS;
  hand[settings_at + 2] = DPI / $records.METRES_PER_INCH;
  hand[settings_at + 3] = $records.METRES_PER_INCH / CPI;
  hand[settings_at + 6] = $functions.CONSTANT;
  hand[settings_at + 7] = GAIN;
}
export function draw(s, traits, draws, s_at = 0, traits_at = 0, draws_at = 0) {
  draws[draws_at] = normal(s, s_at);
  draws[draws_at + 1] = normal(s, s_at);
  draws[draws_at + 2] = normal(s, s_at);
  draws[draws_at + 3] = normal(s, s_at);
  draws[draws_at + 4] = normal(s, s_at);
  draws[draws_at + 5] = normal(s, s_at);
  draws[draws_at + 6] = normal(s, s_at);
  draws[draws_at + 7] = 1;
  if (uniform(s, s_at) >= traits[traits_at + 3]) {
    draws[draws_at + 7] = 2;
    for (let _ = 0, end_1 = $loop.PIECES_MOST - 2; _ < end_1; _++) {
      if (uniform(s, s_at) < $simulation_plan.FURTHER_PIECE * (1 - traits[traits_at])) {
        draws[draws_at + 7] += 1;
      }
    }
  }
  const count = Math.trunc(draws[draws_at + 7]);
  for (let number = 0; number < count; number++) {
    const piece_at = draws_at + number * 7 + 8;
    const last = number === count - 1;
    draws[piece_at] = last ? normal(s, s_at) : uniform(s, s_at);
    draws[piece_at + 1] = normal(s, s_at);
    draws[piece_at + 2] = normal(s, s_at);
    draws[piece_at + 3] = normal(s, s_at);
    draws[piece_at + 4] = normal(s, s_at);
    draws[piece_at + 5] = uniform(s, s_at);
    draws[piece_at + 6] = last ? 0 : -Math.log(uniform(s, s_at));
  }
}
export function aim(hand, x, y, width, hand_at = 0) {
  hand.fill(0, hand_at + 117, hand_at + 1164);
  draw(hand, hand, hand, hand_at, hand_at + 6, hand_at + 26);
  $simulation_plan.plan(hand, hand, hand, x, y, width, hand_at + 62, hand_at + 6, hand_at + 26);
}
export function report(hand, hand_at = 0) {
  const chance_x = normal(hand, hand_at);
  const chance_y = normal(hand, hand_at);
  const poll = $loop.step(hand, [chance_x, chance_y, 0, NaN, NaN], hand_at + 62);
  return [poll[0], poll[1], poll[2], poll[5], poll[12]];
}
