// Written by `make page` from inertial.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
import * as $constant_acceleration from "./constant_acceleration.js";
import * as $fused_path from "./fused_path.js";
import * as $differentiators_kalman from "./kalman.js";
import * as $sampling from "./sampling.js";
import * as $rows from "../rows.js";
export const DELAY_DRIFT = 1e-06;
export const REACH_S = 0.04;
export const LATE_S = 0.004;
export const FORCE_M_S2 = 3;
export const KNOWN_M_S2 = 0.7;
export const KNOWN_DELAY_S = 0.003;
export const STRANGE_SIGMAS = 5;
export const JERK = 4;
export const NOISE = 5;
export const DENSITY = 6;
export const DRIFT = 7;
export const KNOWN = 9;
export const OLD_REFERENCE = 10;
export const OLD = 13;
export const AT = 195;
export const PLAIN = 207;
export const FUSED = 219;
export const NOW = 221;
export const SAMPLED = 222;
export const LAG = 224;
export const REFERENCE = 225;
export const MEAN = 228;
export const FILTER = 231;
export function fill(values, memory) {
  $sampling.fill(values, memory);
  memory[NOISE] = values[NOISE] * values[NOISE];
}
export function conclude(memory) {
  if (memory[FUSED] === 0) {
    return;
  }
  memory[KNOWN] = 1;
  for (let i = 0; i < 3; i++) {
    memory[OLD_REFERENCE + i] = memory[REFERENCE + i];
  }
  for (let i = 0, end_1 = $fused_path.SIZE + $fused_path.SIZE * $fused_path.SIZE; i < end_1; i++) {
    memory[OLD + i] = memory[FILTER + $fused_path.STATE + i];
  }
}
export function start_path(memory) {
  const p = PLAIN + 2 * $constant_acceleration.AXIS;
  for (let number = 0; number < 2; number++) {
    const axis = number * $fused_path.AXIS;
    const x = PLAIN + number * $constant_acceleration.AXIS;
    memory[FILTER + $fused_path.STATE + axis] = memory[x];
    memory[FILTER + $fused_path.STATE + axis + $fused_path.VELOCITY] = memory[x + 1];
    $fused_path.forget(memory, FILTER, axis, memory[p]);
    $fused_path.forget(memory, FILTER, axis + $fused_path.VELOCITY, memory[p + 3]);
    const row = FILTER + $fused_path.COVARIANCE + axis * ($fused_path.SIZE + 1);
    memory[row + $fused_path.VELOCITY] = memory[row + $fused_path.VELOCITY * $fused_path.SIZE] = memory[p + 1];
  }
  for (let i = $fused_path.FIRST; i < $fused_path.LENGTH; i++) {
    memory[FILTER + i] = 0;
  }
  $fused_path.remember(memory, FILTER, memory[NOW] - memory[AT + $sampling.SINCE]);
}
export function advance(memory, t) {
  const dt = t - memory[NOW];
  if (dt <= 0) {
    return;
  }
  const age = smaller(larger(t - memory[SAMPLED], 0), REACH_S);
  const density = memory[DENSITY] + memory[JERK] * age * age;
  $fused_path.predict(memory, FILTER, density, memory[DRIFT], dt);
  memory[FILTER + $fused_path.COVARIANCE + $fused_path.DELAY * ($fused_path.SIZE + 1)] += DELAY_DRIFT * dt;
  memory[NOW] = t;
  $fused_path.remember(memory, FILTER, t - memory[AT + $sampling.SINCE]);
}
export function is_known(memory) {
  if (memory[FUSED] === 0) {
    return false;
  }
  if (memory[LAG] > 0 && memory[LAG] - memory[FILTER + $fused_path.STATE + $fused_path.DELAY] > LATE_S) {
    return false;
  }
  if (memory[FILTER + $fused_path.COVARIANCE + $fused_path.DELAY * ($fused_path.SIZE + 1)] > KNOWN_DELAY_S * KNOWN_DELAY_S) {
    return false;
  }
  const first = $fused_path.acceleration_variance(memory, FILTER, 0, FORCE_M_S2);
  const second = $fused_path.acceleration_variance(memory, FILTER, $fused_path.SECOND, FORCE_M_S2);
  return first <= KNOWN_M_S2 * KNOWN_M_S2 && second <= KNOWN_M_S2 * KNOWN_M_S2;
}
export function settle_s(memory) {
  const intervals = larger(memory[AT + $sampling.SAMPLES] - 1, 1);
  const period = (memory[AT + $sampling.T] - memory[AT + $sampling.SINCE]) / intervals;
  return $differentiators_kalman.SETTLED_RADIANS * Math.pow(memory[NOISE] * period / memory[JERK], 1 / 6);
}
export function follow(memory, verdict, dt) {
  const t = memory[AT + $sampling.T];
  const place = [memory[AT + $sampling.U], memory[AT + $sampling.V]];
  const u = place[0];
  const v = place[1];
  if (memory[FUSED] === 1 && Math.abs(t - memory[SAMPLED]) > REACH_S) {
    conclude(memory);
    memory[FUSED] = 0;
  }
  if (verdict === $sampling.RESTARTED) {
    $constant_acceleration.restart(memory, PLAIN, memory[NOISE]);
    if (memory[FUSED] === 1) {
      memory[NOW] = larger(t - memory[LAG], memory[SAMPLED]);
      start_path(memory);
    }
  } else if (verdict === $sampling.MOVED) {
    $constant_acceleration.follow(memory, PLAIN, memory[JERK], memory[NOISE], dt, place);
    if (memory[FUSED] === 1) {
      advance(memory, t - memory[LAG]);
      const now = memory[NOW] - memory[AT + $sampling.SINCE];
      const ahead = memory[NOW] - t;
      let off = $fused_path.measure(memory, FILTER, 0, now, ahead, u, memory[NOISE]);
      off = larger(off, $fused_path.measure(memory, FILTER, $fused_path.SECOND, now, ahead, v, memory[NOISE]));
      if (off > STRANGE_SIGMAS) {
        memory[KNOWN] = memory[FUSED] = 0;
      }
    }
  }
}
export function hand(memory) {
  let x;
  if (!is_known(memory)) {
    x = PLAIN;
    const y = PLAIN + $constant_acceleration.AXIS;
    return [[memory[x + 1], memory[y + 1]], [memory[x + 2], memory[y + 2]]];
  }
  const ax = $fused_path.acceleration(memory, FILTER, 0, MEAN);
  const ay = $fused_path.acceleration(memory, FILTER, $fused_path.SECOND, MEAN);
  x = FILTER + $fused_path.STATE;
  const missing = larger(memory[AT + $sampling.T] - memory[x + $fused_path.DELAY] - memory[NOW], 0);
  const now_x = $fused_path.acceleration(memory, FILTER, 0, FILTER + $fused_path.FORCE);
  const now_y = $fused_path.acceleration(memory, FILTER, $fused_path.SECOND, FILTER + $fused_path.FORCE);
  const vx = memory[x + $fused_path.VELOCITY] + missing * now_x;
  const vy = memory[x + $fused_path.SECOND + $fused_path.VELOCITY] + missing * now_y;
  return [[vx, vy], [ax, ay]];
}
export function step(memory, event) {
  const values_1 = $sampling.accept(memory, AT, event);
  const verdict = values_1[0];
  const dt = values_1[1];
  const start = values_1[4];
  if (verdict === $sampling.REFUSED) {
    return $rows.REFUSED;
  }
  follow(memory, verdict, dt);
  const settled = $sampling.settled(memory, AT, 4, settle_s(memory));
  return $sampling.motion(memory, AT, event, hand(memory), settled, start);
}
export const InertialDifferentiator = {
  step: step,
  conclude: conclude,
  fill: fill,
  settings: 9, learned: 186, states: 705,
  at: 195,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "jerk_density", unit: "m^2/s^5", low: 0.001, high: 1000000000, default: 30 },
    { name: "noise_m", unit: "m", low: 1e-08, high: 0.1, default: 0.0001 },
    { name: "force_density", unit: "m^2/s^3", low: 1e-12, high: 1000, default: 0.0001 },
    { name: "drift_density", unit: "m^2/s^5", low: 1e-12, high: 1000, default: 0.001 },
    { name: "smoothing_s", unit: "s", low: 0.0001, high: 1, default: 0.02 },
  ],
};
