// Written by `make page` from homogeneous.py: change that and run it again.
import { smaller } from "../arithmetic.js";
import * as $sampling from "./sampling.js";
import * as $records from "../records.js";
export const SUBSTEPS_MOST = 10000;
export const SETTLING_SPEED_M_S = 0.3;
export const CHATTER_MOST_M_S = 0.05;
export const STEPS_M = [1.2699999999999999e-05, 0.0002645833333333333];
export const ORDER = 4;
export const ALPHA = 5;
export const STEP_S = 6;
export const HOLD = 7;
export const SETTLE_S = 8;
export const GAIN = 9;
export const AT = 17;
export const ZX = 29;
export const ZY = 37;
export const SLOPE = 45;
export const ORDER_OF = 4;
export const LAMBDA_OF = 5;
export const XI_OF = 6;
export const ALPHA_OF = 7;
export const STEP_OF = 8;
export function advance(memory, z, before, now, h, steps) {
  const order = Math.trunc(memory[ORDER]);
  let slope = 0;
  for (let i = 0; i < steps; i++) {
    const y = memory[HOLD] === 1 ? now : before + (now - before) * (i / steps);
    const error = memory[z] - y;
    const size = Math.abs(error);
    const scale = size > 0 ? Math.pow(size, memory[ALPHA]) : 0;
    let push = error;
    for (let j = 0; j < order; j++) {
      push *= scale;
      const carried = j + 1 < order ? memory[z + j + 1] : 0;
      slope = carried - memory[GAIN + j] * push;
      memory[z + j] += h * slope;
    }
  }
  return slope;
}
export function step(memory, event) {
  const values_1 = $sampling.accept(memory, AT, event);
  const verdict = values_1[0];
  const dt = values_1[1];
  const before_u = values_1[2];
  const before_v = values_1[3];
  const start = values_1[4];
  if (verdict < 0) {
    return $records.refused(-verdict, memory[AT + $sampling.T]);
  }
  if (verdict === $sampling.RESTARTED) {
    memory.fill(0, ZX, SLOPE + 2);
  } else if (verdict === $sampling.MOVED) {
    const steps = Math.ceil(dt / memory[STEP_S]);
    const h = dt / steps;
    memory[SLOPE] = advance(memory, ZX, before_u, memory[AT + $sampling.U], h, steps);
    memory[SLOPE + 1] = advance(memory, ZY, before_v, memory[AT + $sampling.V], h, steps);
  }
  const second = memory[ORDER] === 2;
  const velocity = [memory[ZX + 1], memory[ZY + 1]];
  const acceleration = [second ? memory[SLOPE] : memory[ZX + 2], second ? memory[SLOPE + 1] : memory[ZY + 2]];
  const settled = $sampling.settled(memory, AT, memory[ORDER] + 1, memory[SETTLE_S]);
  return $sampling.motion(memory, AT, event, [velocity, acceleration], settled, start);
}
export function settling(memory, speed, h, steps) {
  let settled_s = 0;
  for (let i = 0; i < steps; i++) {
    advance(memory, ZX, speed * i * h, speed * (i + 1) * h, h, 1);
    if (Math.abs(memory[ZX + 1] - speed) > 0.05 * speed) {
      settled_s = (i + 1) * h;
    }
  }
  return settled_s;
}
export function chatter(memory, place, h, steps) {
  advance(memory, ZX, place, place, h, steps);
  let fastest = 0;
  for (let _ = 0, end_1 = Math.floor(steps / 4); _ < end_1; _++) {
    advance(memory, ZX, place, place, h, 1);
    const speed = Math.abs(memory[ZX + 1]);
    if (!(speed <= fastest)) {
      fastest = speed;
    }
  }
  return fastest;
}
export function place_poles(memory, gain_lambda, gain_xi) {
  for (let i = 0, end_1 = Math.trunc(memory[ORDER]); i < end_1; i++) {
    const rate = gain_lambda * Math.pow(gain_xi, i);
    for (let j = i; j > 0; j--) {
      memory[GAIN + j] += rate * memory[GAIN + j - 1];
    }
    memory[GAIN] += rate;
  }
}
export function fill(values, memory) {
  $sampling.fill(values, memory);
  memory[ORDER] = values[ORDER_OF];
  memory[ALPHA] = values[ALPHA_OF];
  memory[STEP_S] = values[STEP_OF];
  memory[HOLD] = memory[SETTLE_S] = 0;
  place_poles(memory, values[LAMBDA_OF], values[XI_OF]);
}
export function settle(memory) {
  const h = smaller(memory[STEP_S], 0.001);
  memory[SETTLE_S] = settling(memory, SETTLING_SPEED_M_S, h, Math.floor(2 / h + 0.5));
  memory.fill(0, AT);
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
