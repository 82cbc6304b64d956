// Written by `make page` from kalman.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $constant_acceleration from "./constant_acceleration.js";
import * as $sampling from "./sampling.js";
import * as $rows from "../rows.js";
export const SETTLED_RADIANS = 4;
export const JERK_DENSITY = 4;
export const NOISE = 5;
export const AT = 6;
export const X = 18;
export function fill(values, memory) {
  $sampling.fill(values, memory);
  memory[NOISE] = values[NOISE] * values[NOISE];
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
  if (verdict === $sampling.REFUSED) {
    return $rows.REFUSED;
  }
  if (verdict === $sampling.RESTARTED) {
    $constant_acceleration.restart(memory, X, memory[NOISE]);
  } else if (verdict === $sampling.MOVED) {
    const place = [memory[AT + $sampling.U], memory[AT + $sampling.V]];
    $constant_acceleration.follow(memory, X, memory[JERK_DENSITY], memory[NOISE], dt, place);
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
  at: 6,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "jerk_density", unit: "m^2/s^5", low: 0.001, high: 1000000000, default: 30 },
    { name: "noise_m", unit: "m", low: 1e-08, high: 0.1, default: 0.0001 },
  ],
};
