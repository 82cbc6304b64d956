// Written by `make laws` from switched.py: change that and run it again.
import { larger, view } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $drem from "../regression/drem.js";
import * as $stage from "../stage.js";
export const UNKNOWNS = 3;
export const T = 2;
export function advance(settings, axis, t, x, v, a, settings_at = 0, axis_at = 0) {
  const dx = x - axis[axis_at + 1];
  const before = axis[axis_at + 2];
  axis[axis_at + 1] = x;
  axis[axis_at] = larger(axis[axis_at], Math.abs(v));
  const regression = $drem.parts(view(axis, axis_at + 7, axis_at + 702), UNKNOWNS);
  const w = regression[0];
  const theta = regression[2];
  w[0] = -a;
  w[1] = -v;
  w[2] = 1;
  if (Math.abs(v) < settings[settings_at] * axis[axis_at]) {
    theta[T] = before;
    const solved = $drem.advance(axis, regression, settings[settings_at + 2], settings[settings_at + 3], t, x, axis_at + 3);
    if (solved && Math.abs(theta[T] - before) < settings[settings_at + 1] * Math.abs(x)) {
      axis[axis_at + 2] = theta[T];
    }
  } else {
    $drem.remember(axis, regression, settings[settings_at + 2], t, x, axis_at + 3);
    if (a * v >= 0) {
      axis[axis_at + 2] = before + 2 * dx;
    }
  }
  return axis[axis_at + 2];
}
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const settings_at = memory_at;
  const s_at = memory_at + 4;
  const x_at = memory_at + 13;
  const y_at = memory_at + 715;
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  if (new_) {
    memory.fill(0, x_at, x_at + 702);
    memory.fill(0, y_at, y_at + 702);
  }
  const since = m[0] - memory[s_at + 4];
  const end_x = memory[s_at + 5] + advance(memory, memory, since, m[1] - memory[s_at + 5], m[3], m[5], settings_at, x_at);
  const end_y = memory[s_at + 6] + advance(memory, memory, since, m[2] - memory[s_at + 6], m[4], m[6], settings_at, y_at);
  return $records.endpoint(m[0], end_x, end_y, $predictors_movement.phase(memory, m, s_at));
}
export const SwitchedPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 4, learned: 0, states: 1413,
  parameters: [
    { name: "threshold", unit: "share of peak speed", low: 0, high: 10, default: 0.2 },
    { name: "bound", unit: "share of displacement", low: 0, high: 10, default: 0.1 },
    { name: "delay_s", unit: "s", low: 0.001, high: 1, default: 0.1 },
    { name: "gamma", unit: "1/s", low: 0, high: 1000000000, default: 10000 },
  ],
};
