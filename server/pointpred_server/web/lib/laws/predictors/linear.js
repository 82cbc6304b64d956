// Written by `make laws` from linear.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const CAPACITY = 8;
export function remember(past, window_s, t, x, y, past_at = 0) {
  const count = Math.trunc(past[past_at]);
  const same = count > 0 && past[past_at + 1] === t;
  if (count > 0 && !same && t - past[past_at + 1] < window_s / CAPACITY - $records.ROUNDING_S) {
    return;
  }
  if (!same) {
    for (let i = CAPACITY - 1; i > 0; i--) {
      for (let j = 0; j < 3; j++) {
        past[past_at + i * 3 + j + 1] = past[past_at + (i - 1) * 3 + j + 1];
      }
    }
    past[past_at] = smaller(count + 1, CAPACITY);
  }
  past[past_at + 1] = t;
  past[past_at + 2] = x;
  past[past_at + 3] = y;
}
/** @returns {[boolean, number, number, number]} */
export function before(past, window_s, t, past_at = 0) {
  let found = -1;
  for (let i = 0, end_1 = Math.trunc(past[past_at]); i < end_1; i++) {
    const age = t - past[past_at + i * 3 + 1];
    if (age > 0 && (found < 0 || age <= window_s + $records.ROUNDING_S)) {
      found = i;
    }
  }
  if (found < 0) {
    return [false, t, 0, 0];
  }
  return [true, past[past_at + found * 3 + 1], past[past_at + found * 3 + 2], past[past_at + found * 3 + 3]];
}
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const settings_at = memory_at;
  const s_at = memory_at + 2;
  const past_at = memory_at + 11;
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  if (new_) {
    memory[past_at] = 0;
  }
  const phase = $predictors_movement.phase(memory, m, s_at);
  const values_2 = before(memory, memory[settings_at + 1], m[0], past_at);
  const any_before = values_2[0];
  const before_t = values_2[1];
  const before_x = values_2[2];
  const before_y = values_2[3];
  remember(memory, memory[settings_at + 1], m[0], m[1], m[2], past_at);
  if (!any_before) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const ahead = memory[settings_at] / larger(m[0] - before_t, memory[settings_at + 1] / CAPACITY);
  return $records.endpoint(m[0], m[1] + ahead * (m[1] - before_x), m[2] + ahead * (m[2] - before_y), phase);
}
export const LinearPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 2, learned: 0, states: 34,
  parameters: [
    { name: "horizon_s", unit: "s", low: 0, high: 1, default: 0.12 },
    { name: "window_s", unit: "s", low: 0.001, high: 1, default: 0.12 },
  ],
};
