// Written by `make laws` from kalman.py: change that and run it again.
import { square, view } from "../arithmetic.js";
import * as $differentiators_kalman from "../differentiators/kalman.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const PRIOR_SPEED = 100;
export const PRIOR_ACCELERATION = 1000;
export function expect_rest(plane, noise, x, y, plane_at = 0) {
  plane.fill(0, plane_at, plane_at + 12);
  plane[plane_at] = x;
  plane[plane_at + 3] = y;
  plane[plane_at + 6] = noise;
  plane[plane_at + 9] = PRIOR_SPEED * PRIOR_SPEED;
  plane[plane_at + 11] = PRIOR_ACCELERATION * PRIOR_ACCELERATION;
}
export function corrected(axis, p, noise, measured, p_at = 0) {
  const share = (measured - axis[0]) / (p[p_at] + noise);
  return [axis[0] + p[p_at] * share, axis[1] + p[p_at + 1] * share, axis[2] + p[p_at + 2] * share];
}
export function expect(plane, noise, jerk_density, dt, x, y, plane_at = 0) {
  $differentiators_kalman.correct(view(plane, plane_at, plane_at + 3), plane, noise, x, plane_at + 6);
  $differentiators_kalman.predict(view(plane, plane_at, plane_at + 3), dt);
  $differentiators_kalman.correct(view(plane, plane_at + 3, plane_at + 6), plane, noise, y, plane_at + 6);
  $differentiators_kalman.predict(view(plane, plane_at + 3, plane_at + 6), dt);
  $differentiators_kalman.narrow(plane, noise, plane_at + 6);
  $differentiators_kalman.spread(plane, jerk_density, dt, plane_at + 6);
}
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const settings_at = memory_at;
  const s_at = memory_at + 4;
  const plane_at = memory_at + 13;
  const last_x = memory[s_at + 2];
  const last_y = memory[s_at + 3];
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  const noise = square(memory[settings_at + 2]);
  if (new_ || dt > memory[settings_at + 3] + $records.ROUNDING_S) {
    expect_rest(memory, noise, m[1] - memory[s_at + 5], m[2] - memory[s_at + 6], plane_at);
  } else if (dt > 0) {
    expect(memory, noise, memory[settings_at + 1], dt, last_x - memory[s_at + 5], last_y - memory[s_at + 6], plane_at);
  }
  const values_2 = corrected(view(memory, plane_at, plane_at + 3), memory, noise, m[1] - memory[s_at + 5], plane_at + 6);
  const px = values_2[0];
  const vx_px = values_2[1];
  const ax_px = values_2[2];
  const values_3 = corrected(view(memory, plane_at + 3, plane_at + 6), memory, noise, m[2] - memory[s_at + 6], plane_at + 6);
  const py = values_3[0];
  const vy_px = values_3[1];
  const ay_px = values_3[2];
  const h = memory[settings_at];
  return $records.endpoint(m[0], memory[s_at + 5] + px + h * (vx_px + 0.5 * h * ax_px), memory[s_at + 6] + py + h * (vy_px + 0.5 * h * ay_px), $predictors_movement.phase(memory, m, s_at));
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
