// Written by `make laws` from kalman.py: change that and run it again.
import { square, view } from "../arithmetic.js";
import * as $differentiators_kalman from "../differentiators/kalman.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const PRIOR_SPEED = 100;
export const PRIOR_ACCELERATION = 1000;
export const HORIZON_S = 0;
export const JERK_DENSITY = 1;
export const NOISE_PX = 2;
export const GAP_S = 3;
export const AT = 4;
export const MEAN_X = 13;
export const MEAN_Y = 16;
export const SPREAD = 19;
export const END = 25;
export function expect_rest(memory, x, y) {
  memory.fill(0, MEAN_X, END);
  memory[MEAN_X] = x;
  memory[MEAN_Y] = y;
  memory[SPREAD] = square(memory[NOISE_PX]);
  memory[SPREAD + 3] = PRIOR_SPEED * PRIOR_SPEED;
  memory[SPREAD + 5] = PRIOR_ACCELERATION * PRIOR_ACCELERATION;
}
export function correct(memory, mean, measured) {
  const total = memory[SPREAD] + square(memory[NOISE_PX]);
  const share = (measured - memory[mean]) / total;
  return [memory[mean] + memory[SPREAD] * share, memory[mean + 1] + memory[SPREAD + 1] * share, memory[mean + 2] + memory[SPREAD + 2] * share];
}
export function expect(memory, dt, x, y) {
  const noise = square(memory[NOISE_PX]);
  const plane_at = MEAN_X;
  $differentiators_kalman.correct(view(memory, plane_at, plane_at + 3), memory, noise, x, plane_at + 6);
  $differentiators_kalman.predict(view(memory, plane_at, plane_at + 3), dt);
  $differentiators_kalman.correct(view(memory, plane_at + 3, plane_at + 6), memory, noise, y, plane_at + 6);
  $differentiators_kalman.predict(view(memory, plane_at + 3, plane_at + 6), dt);
  $differentiators_kalman.narrow(memory, noise, plane_at + 6);
  $differentiators_kalman.spread(memory, memory[JERK_DENSITY], dt, plane_at + 6);
}
export function step(memory, motion) {
  const m = motion;
  const last_x = memory[AT + 2];
  const last_y = memory[AT + 3];
  const values_1 = $predictors_movement.follow(memory, m, AT);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  const x0 = memory[AT + 5];
  const y0 = memory[AT + 6];
  if (new_ || dt > memory[GAP_S] + $records.ROUNDING_S) {
    expect_rest(memory, m[1] - x0, m[2] - y0);
  } else if (dt > 0) {
    expect(memory, dt, last_x - x0, last_y - y0);
  }
  const h = memory[HORIZON_S];
  const values_2 = correct(memory, MEAN_X, m[1] - x0);
  const px = values_2[0];
  const vx_px = values_2[1];
  const ax_px = values_2[2];
  const values_3 = correct(memory, MEAN_Y, m[2] - y0);
  const py = values_3[0];
  const vy_px = values_3[1];
  const ay_px = values_3[2];
  return $records.endpoint(m[0], x0 + px + h * (vx_px + 0.5 * h * ax_px), y0 + py + h * (vy_px + 0.5 * h * ay_px), $predictors_movement.phase(memory, m, AT));
}
export const KalmanPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 4, learned: 0, states: 21,
  parameters: [
    { name: "horizon_s", unit: "s", low: 0, high: 1, default: 0.025 },
    { name: "cursor_jerk_density", unit: "px^2/s^5", low: 1, high: 1e+18, default: 10000000000 },
    { name: "cursor_noise_px", unit: "px", low: 0.001, high: 1000, default: 1 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
  ],
};
