// Written by `make laws` from kalman.py: change that and run it again.
import { larger, view } from "../arithmetic.js";
import * as $sampling from "./sampling.js";
import * as $records from "../records.js";
export const SETTLED_RADIANS = 4;
export const START_SPEED_M_S = 0.3;
export const START_ACCELERATION_M_S2 = 5;
export function fill(values, settings, settings_at = 0) {
  $sampling.fill(values, view(settings, settings_at, settings_at + 6));
  settings[settings_at + 5] = settings[settings_at + 5] * settings[settings_at + 5];
}
export function predict(axis, dt) {
  axis[0] += dt * (axis[1] + 0.5 * dt * axis[2]);
  axis[1] += dt * axis[2];
}
export function spread(p, jerk_density, dt, p_at = 0) {
  const half = 0.5 * dt * dt;
  const q = jerk_density * dt;
  const f00 = p[p_at] + dt * p[p_at + 1] + half * p[p_at + 2];
  const f01 = p[p_at + 1] + dt * p[p_at + 3] + half * p[p_at + 4];
  const f02 = p[p_at + 2] + dt * p[p_at + 4] + half * p[p_at + 5];
  const g11 = p[p_at + 3] + dt * p[p_at + 4];
  const g12 = p[p_at + 4] + dt * p[p_at + 5];
  p[p_at] = f00 + dt * f01 + half * f02 + q * Math.pow(dt, 4) / 20;
  p[p_at + 1] = f01 + dt * f02 + q * Math.pow(dt, 3) / 8;
  p[p_at + 2] = f02 + q * dt * dt / 6;
  p[p_at + 3] = g11 + dt * g12 + q * dt * dt / 3;
  p[p_at + 4] = g12 + q * dt / 2;
  p[p_at + 5] = p[p_at + 5] + q;
}
export function correct(axis, p, noise, measured, p_at = 0) {
  const share = (measured - axis[0]) / (p[p_at] + noise);
  axis[0] += p[p_at] * share;
  axis[1] += p[p_at + 1] * share;
  axis[2] += p[p_at + 2] * share;
}
export function narrow(p, noise, p_at = 0) {
  const p00 = p[p_at];
  const p01 = p[p_at + 1];
  const p02 = p[p_at + 2];
  const total = p00 + noise;
  p[p_at + 3] = larger(p[p_at + 3] - p01 * p01 / total, 0);
  p[p_at + 4] -= p01 * p02 / total;
  p[p_at + 5] = larger(p[p_at + 5] - p02 * p02 / total, 0);
  p[p_at] = p00 * noise / total;
  p[p_at + 1] = p01 * noise / total;
  p[p_at + 2] = p02 * noise / total;
}
export function restart(plane, noise, plane_at = 0) {
  plane.fill(0, plane_at, plane_at + 12);
  plane[plane_at + 6] = noise;
  plane[plane_at + 9] = START_SPEED_M_S * START_SPEED_M_S;
  plane[plane_at + 11] = START_ACCELERATION_M_S2 * START_ACCELERATION_M_S2;
}
export function follow(plane, jerk_density, noise, dt, place, plane_at = 0) {
  const u = place[0];
  const v = place[1];
  predict(view(plane, plane_at, plane_at + 3), dt);
  predict(view(plane, plane_at + 3, plane_at + 6), dt);
  spread(plane, jerk_density, dt, plane_at + 6);
  correct(view(plane, plane_at, plane_at + 3), plane, noise, u, plane_at + 6);
  correct(view(plane, plane_at + 3, plane_at + 6), plane, noise, v, plane_at + 6);
  narrow(plane, noise, plane_at + 6);
}
export function settle_s(settings, samples, settings_at = 0, samples_at = 0) {
  const intervals = larger(samples[samples_at + 7] - 1, 1);
  const period = (samples[samples_at + 1] - samples[samples_at + 9]) / intervals;
  return SETTLED_RADIANS * Math.pow(settings[settings_at + 5] * period / settings[settings_at + 4], 1 / 6);
}
export function step(memory, event, memory_at = 0) {
  const settings_at = memory_at;
  const samples_at = memory_at + 6;
  const plane_at = memory_at + 18;
  const values_1 = $sampling.accept(memory, memory, event, settings_at, samples_at);
  const verdict = values_1[0];
  const dt = values_1[1];
  const start = values_1[4];
  if (verdict < 0) {
    return $records.refused(-verdict, memory[samples_at + 1]);
  }
  if (verdict === $sampling.RESTARTED) {
    restart(memory, memory[settings_at + 5], plane_at);
  } else if (verdict === $sampling.MOVED) {
    follow(memory, memory[settings_at + 4], memory[settings_at + 5], dt, [memory[samples_at + 5], memory[samples_at + 6]], plane_at);
  }
  const velocity = [memory[plane_at + 1], memory[plane_at + 4]];
  const acceleration = [memory[plane_at + 2], memory[plane_at + 5]];
  const settled = $sampling.settled(memory, 4, settle_s(memory, memory, settings_at, samples_at), samples_at);
  return $sampling.motion(memory, event, [velocity, acceleration], settled, start, samples_at);
}
export const KalmanDifferentiator = {
  step: step,
  fill: fill,
  settings: 6, learned: 0, states: 24,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "jerk_density", unit: "m^2/s^5", low: 0.001, high: 1000000000, default: 30 },
    { name: "noise_m", unit: "m", low: 1e-08, high: 0.1, default: 0.0001 },
  ],
};
