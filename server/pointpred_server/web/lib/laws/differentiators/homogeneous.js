// Written by `make laws` from homogeneous.py: change that and run it again.
import { smaller, view } from "../arithmetic.js";
import * as $sampling from "./sampling.js";
import * as $records from "../records.js";
export const SUBSTEPS_MOST = 10000;
export const SETTLING_SPEED_M_S = 0.3;
export const CHATTER_MOST_M_S = 0.05;
export const STEPS_M = [1.2699999999999999e-05, 0.0002645833333333333];
export const ORDER_OF = 4;
export const LAMBDA_OF = 5;
export const XI_OF = 6;
export const ALPHA_OF = 7;
export const STEP_OF = 8;
export function advance(settings, axis, before, now, h, steps, settings_at = 0, axis_at = 0) {
  const order = Math.trunc(settings[settings_at + 4]);
  let slope = 0;
  for (let i = 0; i < steps; i++) {
    const y = settings[settings_at + 7] === 1 ? now : before + (now - before) * (i / steps);
    const error = axis[axis_at] - y;
    const size = Math.abs(error);
    const scale = size > 0 ? Math.pow(size, settings[settings_at + 5]) : 0;
    let push = error;
    for (let j = 0; j < order; j++) {
      push *= scale;
      const carried = j + 1 < order ? axis[axis_at + j + 1] : 0;
      slope = carried - settings[settings_at + j + 9] * push;
      axis[axis_at + j] += h * slope;
    }
  }
  return slope;
}
export function step(memory, event, memory_at = 0) {
  const settings_at = memory_at;
  const samples_at = memory_at + 17;
  const z_at = memory_at + 29;
  const values_1 = $sampling.accept(memory, memory, event, settings_at, samples_at);
  const verdict = values_1[0];
  const dt = values_1[1];
  const before_u = values_1[2];
  const before_v = values_1[3];
  const start = values_1[4];
  if (verdict < 0) {
    return $records.refused(-verdict, memory[samples_at + 1]);
  }
  if (verdict === $sampling.RESTARTED) {
    memory.fill(0, z_at, z_at + 18);
  } else if (verdict === $sampling.MOVED) {
    const steps = Math.ceil(dt / memory[settings_at + 6]);
    const h = dt / steps;
    memory[z_at + 16] = advance(memory, memory, before_u, memory[samples_at + 5], h, steps, settings_at, z_at);
    memory[z_at + 17] = advance(memory, memory, before_v, memory[samples_at + 6], h, steps, settings_at, z_at + 8);
  }
  const second = memory[settings_at + 4] === 2;
  const velocity = [memory[z_at + 1], memory[z_at + 9]];
  const acceleration = [second ? memory[z_at + 16] : memory[z_at + 2], second ? memory[z_at + 17] : memory[z_at + 10]];
  const settled = $sampling.settled(memory, memory[settings_at + 4] + 1, memory[settings_at + 8], samples_at);
  return $sampling.motion(memory, event, [velocity, acceleration], settled, start, samples_at);
}
export function settling(memory, speed, h, steps, memory_at = 0) {
  const axis_at = memory_at + 29;
  let settled_s = 0;
  for (let i = 0; i < steps; i++) {
    advance(memory, memory, speed * i * h, speed * (i + 1) * h, h, 1, memory_at, axis_at);
    if (Math.abs(memory[axis_at + 1] - speed) > 0.05 * speed) {
      settled_s = (i + 1) * h;
    }
  }
  return settled_s;
}
export function chatter(memory, place, h, steps, memory_at = 0) {
  const axis_at = memory_at + 29;
  advance(memory, memory, place, place, h, steps, memory_at, axis_at);
  let fastest = 0;
  for (let _ = 0, end_1 = Math.floor(steps / 4); _ < end_1; _++) {
    advance(memory, memory, place, place, h, 1, memory_at, axis_at);
    const speed = Math.abs(memory[axis_at + 1]);
    if (!(speed <= fastest)) {
      fastest = speed;
    }
  }
  return fastest;
}
export function place_poles(settings, gain_lambda, gain_xi, settings_at = 0) {
  for (let i = 0, end_1 = Math.trunc(settings[settings_at + 4]); i < end_1; i++) {
    const rate = gain_lambda * Math.pow(gain_xi, i);
    for (let j = i; j > 0; j--) {
      settings[settings_at + j + 9] += rate * settings[settings_at + (j - 1) + 9];
    }
    settings[settings_at + 9] += rate;
  }
}
export function fill(values, settings, settings_at = 0) {
  $sampling.fill(values, view(settings, settings_at, settings_at + 17));
  settings[settings_at + 4] = values[ORDER_OF];
  settings[settings_at + 5] = values[ALPHA_OF];
  settings[settings_at + 6] = values[STEP_OF];
  settings[settings_at + 7] = settings[settings_at + 8] = 0;
  place_poles(settings, values[LAMBDA_OF], values[XI_OF], settings_at);
}
export function settle(memory, memory_at = 0) {
  const h = smaller(memory[memory_at + 6], 0.001);
  memory[memory_at + 8] = settling(memory, SETTLING_SPEED_M_S, h, Math.floor(2 / h + 0.5), memory_at);
  memory.fill(0, memory_at + 17, memory_at + 47);
}
export const HomogeneousDifferentiator = {
  step: step,
  fill: fill,
  settle: settle,
  settings: 17, learned: 0, states: 30,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "order", low: 2, high: 8, default: 4, whole: true },
    { name: "gain_lambda", unit: "1/s", low: 0.001, high: 10000, default: 5 },
    { name: "gain_xi", low: 0.001, high: 100, default: 2 },
    { name: "alpha", low: -0.5, high: 0, default: -0.2 },
    { name: "step_s", unit: "s", low: 1e-05, high: 0.1, default: 0.0015 },
  ],
};
