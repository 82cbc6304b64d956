// Written by `make page` from fading.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $sampling from "./sampling.js";
import * as $rows from "../rows.js";
export const UNDETERMINED = 1e-09;
export const LEAST_WEIGHT = 1e-30;
export const MEMORY_S = 4;
export const AT = 5;
export const TIME = 17;
export const WAY = 22;
export const FIT = 28;
export function shift(memory, first, count, s, fade) {
  for (let i = 0, end_1 = count - 1; i < end_1; i++) {
    for (let j = count - 1; j > i; j--) {
      memory[first + j] -= s * memory[first + j - 1];
    }
  }
  for (let j = 0; j < count; j++) {
    memory[first + j] *= fade;
  }
}
export function absorb(memory, s, moved_u, moved_v) {
  const fade = larger(Math.exp(-s), LEAST_WEIGHT);
  shift(memory, TIME, 5, s, fade);
  for (let axis = 0; axis < 2; axis++) {
    const way = WAY + 3 * axis;
    shift(memory, way, 3, s, fade);
    const moved = axis ? moved_v : moved_u;
    for (let k = 0; k < 3; k++) {
      memory[way + k] -= moved * memory[TIME + k];
    }
  }
  memory[TIME] += 1;
}
export function fit(memory) {
  const s0 = memory[TIME];
  const s1 = memory[TIME + 1];
  const s2 = memory[TIME + 2];
  const s3 = memory[TIME + 3];
  const s4 = memory[TIME + 4];
  const l10 = s1 / s0;
  const l20 = s2 / s0;
  const d1 = s2 - l10 * s1;
  if (!(d1 > UNDETERMINED * s2)) {
    return;
  }
  const l21 = (s3 - l20 * s1) / d1;
  const d2 = s4 - l20 * s2 - l21 * l21 * d1;
  const curved = d2 > UNDETERMINED * s4;
  const unit = memory[MEMORY_S];
  for (let axis = 0; axis < 2; axis++) {
    const way = WAY + 3 * axis;
    const r1 = memory[way + 1] - l10 * memory[way];
    const r2 = memory[way + 2] - l20 * memory[way] - l21 * r1;
    const curvature = curved ? r2 / d2 : 0;
    memory[FIT + axis] = (r1 / d1 - l21 * curvature) / unit;
    memory[FIT + 2 + axis] = 2 * curvature / (unit * unit);
  }
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
    memory.fill(0, TIME, FIT + 4);
    memory[TIME] = 1;
  } else if (verdict === $sampling.MOVED) {
    const moved_u = memory[AT + $sampling.U] - before_u;
    const moved_v = memory[AT + $sampling.V] - before_v;
    absorb(memory, dt / memory[MEMORY_S], moved_u, moved_v);
    fit(memory);
  }
  const velocity = [memory[FIT], memory[FIT + 1]];
  const acceleration = [memory[FIT + 2], memory[FIT + 3]];
  const settled = $sampling.settled(memory, AT, 3, memory[MEMORY_S]);
  return $sampling.motion(memory, AT, event, [velocity, acceleration], settled, start);
}
export const FadingMemoryDifferentiator = {
  step: step,
  fill: $sampling.fill,
  settings: 5, learned: 0, states: 27,
  at: 5,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "memory_s", unit: "s", low: 0.001, high: 1, default: 0.01 },
  ],
};
