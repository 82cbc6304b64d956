// Written by `make page` from reduced_order.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $sampling from "./sampling.js";
import * as $rows from "../rows.js";
export const SETTLED_RADIANS = 5;
export const DECAY = 4;
export const FREQUENCY = 5;
export const SETTLE_S = 6;
export const AT = 7;
export const X = 19;
export function fill(values, memory) {
  $sampling.fill(values, memory);
  const bandwidth = values[$sampling.SETTINGS];
  const damping = values[$sampling.SETTINGS + 1];
  memory[DECAY] = damping * bandwidth;
  memory[FREQUENCY] = bandwidth * Math.sqrt(larger(1 - damping * damping, 0));
  memory[SETTLE_S] = SETTLED_RADIANS / memory[DECAY];
}
export function follow(memory, x, slope, dt) {
  const d = memory[DECAY];
  const f = memory[FREQUENCY];
  const fade = Math.exp(-d * dt);
  const along = fade * Math.cos(f * dt);
  let across = fade * dt;
  if (f * dt > 1e-08) {
    across = fade * Math.sin(f * dt) / f;
  }
  const velocity = memory[x] - slope;
  const acceleration = memory[x + 1];
  memory[x] = slope + (along - d * across) * velocity + across * acceleration;
  memory[x + 1] = (along + d * across) * acceleration - (d * d + f * f) * across * velocity;
}
export function step(memory, event) {
  const values_1 = $sampling.accept(memory, AT, event);
  const verdict = values_1[0];
  const dt = values_1[1];
  const before_u = values_1[2];
  const before_v = values_1[3];
  const start = values_1[4];
  if (verdict === $sampling.REFUSED) {
    return $rows.REFUSED;
  }
  if (verdict === $sampling.RESTARTED) {
    memory.fill(0, X, X + 4);
  } else if (verdict === $sampling.MOVED) {
    follow(memory, X, (memory[AT + $sampling.U] - before_u) / dt, dt);
    follow(memory, X + 2, (memory[AT + $sampling.V] - before_v) / dt, dt);
  }
  const velocity = [memory[X], memory[X + 2]];
  const acceleration = [memory[X + 1], memory[X + 3]];
  const settled = $sampling.settled(memory, AT, 3, memory[SETTLE_S]);
  return $sampling.motion(memory, AT, event, [velocity, acceleration], settled, start);
}
export const ReducedOrderDifferentiator = {
  step: step,
  fill: fill,
  settings: 7, learned: 0, states: 16,
  at: 7,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "bandwidth", unit: "rad/s", low: 1, high: 10000, default: 60 },
    { name: "damping", low: 0.1, high: 1, default: 0.5 },
  ],
};
