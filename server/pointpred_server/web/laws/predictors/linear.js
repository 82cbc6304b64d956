// Written by `make laws` from linear.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const CAPACITY = 8;
export const HORIZON_S = 0;
export const WINDOW_S = 1;
export const AT = 2;
export const COUNT = 11;
export const PAST = 12;
export function remember(memory, t, x, y) {
  const count = Math.trunc(memory[COUNT]);
  const same = count > 0 && memory[PAST] === t;
  if (count > 0 && !same && t - memory[PAST] < memory[WINDOW_S] / CAPACITY - $records.ROUNDING_S) {
    return;
  }
  if (!same) {
    for (let i = 3 * CAPACITY - 1; i > 2; i--) {
      memory[PAST + i] = memory[PAST + i - 3];
    }
    memory[COUNT] = smaller(count + 1, CAPACITY);
  }
  memory[PAST] = t;
  memory[PAST + 1] = x;
  memory[PAST + 2] = y;
}
export function before(memory, t) {
  let place = -1;
  for (let i = 0, end_1 = Math.trunc(memory[COUNT]); i < end_1; i++) {
    const age = t - memory[PAST + 3 * i];
    if (age > 0 && (place < 0 || age <= memory[WINDOW_S] + $records.ROUNDING_S)) {
      place = PAST + 3 * i;
    }
  }
  if (place < 0) {
    return [false, t, 0, 0];
  }
  return [true, memory[place], memory[place + 1], memory[place + 2]];
}
export function step(memory, motion) {
  const m = motion;
  const values_1 = $predictors_movement.follow(memory, m, AT);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  if (new_) {
    memory[COUNT] = 0;
  }
  const phase = $predictors_movement.phase(memory, m, AT);
  const values_2 = before(memory, m[0]);
  const any_before = values_2[0];
  const before_t = values_2[1];
  const before_x = values_2[2];
  const before_y = values_2[3];
  remember(memory, m[0], m[1], m[2]);
  if (!any_before) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const ahead = memory[HORIZON_S] / larger(m[0] - before_t, memory[WINDOW_S] / CAPACITY);
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
