// Written by `make page` from kalman.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $sampling from "./sampling.js";
import * as $records from "../records.js";
export const SETTLED_RADIANS = 4;
export const START_SPEED_M_S = 0.3;
export const START_ACCELERATION_M_S2 = 5;
export const AXIS = 3;
export const PLANE = 12;
export const JERK_DENSITY = 4;
export const NOISE = 5;
export const AT = 6;
export const X = 18;
export function fill(values, memory) {
  $sampling.fill(values, memory);
  memory[NOISE] = values[NOISE] * values[NOISE];
}
export function predict(memory, x, dt) {
  memory[x] += dt * (memory[x + 1] + 0.5 * dt * memory[x + 2]);
  memory[x + 1] += dt * memory[x + 2];
}
export function spread(memory, p, jerk_density, dt) {
  const p00 = memory[p];
  const p01 = memory[p + 1];
  const p02 = memory[p + 2];
  const p11 = memory[p + 3];
  const p12 = memory[p + 4];
  const p22 = memory[p + 5];
  const half = 0.5 * dt * dt;
  const q = jerk_density * dt;
  const f00 = p00 + dt * p01 + half * p02;
  const f01 = p01 + dt * p11 + half * p12;
  const f02 = p02 + dt * p12 + half * p22;
  const g11 = p11 + dt * p12;
  const g12 = p12 + dt * p22;
  memory[p] = f00 + dt * f01 + half * f02 + q * Math.pow(dt, 4) / 20;
  memory[p + 1] = f01 + dt * f02 + q * Math.pow(dt, 3) / 8;
  memory[p + 2] = f02 + q * dt * dt / 6;
  memory[p + 3] = g11 + dt * g12 + q * dt * dt / 3;
  memory[p + 4] = g12 + q * dt / 2;
  memory[p + 5] = p22 + q;
}
export function correct(memory, x, p, noise, measured) {
  const share = (measured - memory[x]) / (memory[p] + noise);
  memory[x] += memory[p] * share;
  memory[x + 1] += memory[p + 1] * share;
  memory[x + 2] += memory[p + 2] * share;
}
export function narrow(memory, p, noise) {
  const p00 = memory[p];
  const p01 = memory[p + 1];
  const p02 = memory[p + 2];
  const total = p00 + noise;
  memory[p + 3] = larger(memory[p + 3] - p01 * p01 / total, 0);
  memory[p + 4] -= p01 * p02 / total;
  memory[p + 5] = larger(memory[p + 5] - p02 * p02 / total, 0);
  memory[p] = p00 * noise / total;
  memory[p + 1] = p01 * noise / total;
  memory[p + 2] = p02 * noise / total;
}
export function restart(memory, x, noise) {
  memory.fill(0, x, x + PLANE);
  const p = x + 2 * AXIS;
  memory[p] = noise;
  memory[p + 3] = START_SPEED_M_S * START_SPEED_M_S;
  memory[p + 5] = START_ACCELERATION_M_S2 * START_ACCELERATION_M_S2;
}
export function follow(memory, x, jerk_density, noise, dt, place) {
  const u = place[0];
  const v = place[1];
  const p = x + 2 * AXIS;
  predict(memory, x, dt);
  predict(memory, x + AXIS, dt);
  spread(memory, p, jerk_density, dt);
  correct(memory, x, p, noise, u);
  correct(memory, x + AXIS, p, noise, v);
  narrow(memory, p, noise);
}
export function settle_s(memory) {
  const intervals = larger(memory[AT + $sampling.SAMPLES] - 1, 1);
  const period = (memory[AT + $sampling.T] - memory[AT + $sampling.SINCE]) / intervals;
  return SETTLED_RADIANS * Math.pow(memory[NOISE] * period / memory[JERK_DENSITY], 1 / 6);
}
export function step(memory, event) {
  const values_1 = $sampling.accept(memory, AT, event);
  const verdict = values_1[0];
  const dt = values_1[1];
  const start = values_1[4];
  if (verdict < 0) {
    return $records.refused(-verdict, memory[AT + $sampling.T]);
  }
  if (verdict === $sampling.RESTARTED) {
    restart(memory, X, memory[NOISE]);
  } else if (verdict === $sampling.MOVED) {
    const place = [memory[AT + $sampling.U], memory[AT + $sampling.V]];
    follow(memory, X, memory[JERK_DENSITY], memory[NOISE], dt, place);
  }
  const velocity = [memory[X + 1], memory[X + 4]];
  const acceleration = [memory[X + 2], memory[X + 5]];
  const settled = $sampling.settled(memory, AT, 4, settle_s(memory));
  return $sampling.motion(memory, AT, event, [velocity, acceleration], settled, start);
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
