// Written by `make page` from sampling.py: change that and run it again.
import * as $records from "../records.js";
export const METRES_PER_COUNT = 0;
export const METRES_PER_PX = 1;
export const GAP_S = 2;
export const PAUSE_S = 3;
export const STARTED = 0;
export const T = 1;
export const X = 2;
export const Y = 3;
export const BUTTONS = 4;
export const U = 5;
export const V = 6;
export const SAMPLES = 7;
export const COUNTS = 8;
export const SINCE = 9;
export const LAST_U = 10;
export const LAST_V = 11;
export const MERGED = 0;
export const RESTARTED = 1;
export const MOVED = 2;
export function fill(values, memory) {
  memory[METRES_PER_COUNT] = values[0] > 0 ? $records.METRES_PER_INCH / values[0] : 0;
  memory[METRES_PER_PX] = $records.METRES_PER_INCH / values[1];
  for (let i = GAP_S, end_1 = values.length; i < end_1; i++) {
    memory[i] = values[i];
  }
}
export function accept(memory, at, event) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const dx = event[3];
  const dy = event[4];
  const buttons = event[5];
  const started = memory[at + STARTED] === 1;
  let fault = $records.fault_of_event(event);
  if (fault === $records.FINE && started && t < memory[at + T]) {
    fault = $records.ORDER;
  }
  if (fault !== $records.FINE) {
    return [-fault, 0, 0, 0, false];
  }
  const dt = t - memory[at + T];
  const released = (Math.trunc(memory[at + BUTTONS]) & ~Math.trunc(buttons)) !== 0;
  const start = !started || released || dt > memory[PAUSE_S] + $records.ROUNDING_S;
  const counted = dx === dx && memory[METRES_PER_COUNT] > 0;
  const merged = started && dt === 0;
  const restarted = !started || dt > memory[GAP_S] + $records.ROUNDING_S || merged && memory[at + SAMPLES] === 1;
  if (restarted) {
    memory[at + U] = 0;
    memory[at + V] = 0;
    memory[at + LAST_U] = 0;
    memory[at + LAST_V] = 0;
    memory[at + SINCE] = t;
  } else if (counted) {
    memory[at + U] += dx * memory[METRES_PER_COUNT];
    memory[at + V] += dy * memory[METRES_PER_COUNT];
  } else {
    memory[at + U] += (x - memory[at + X]) * memory[METRES_PER_PX];
    memory[at + V] += (y - memory[at + Y]) * memory[METRES_PER_PX];
  }
  memory[at + STARTED] = 1;
  memory[at + T] = t;
  memory[at + X] = x;
  memory[at + Y] = y;
  memory[at + BUTTONS] = buttons;
  memory[at + COUNTS] = counted ? 1 : 0;
  if (restarted) {
    memory[at + SAMPLES] = 1;
    return [RESTARTED, dt, 0, 0, start];
  }
  if (merged) {
    return [MERGED, 0, 0, 0, start];
  }
  const before_u = memory[at + LAST_U];
  const before_v = memory[at + LAST_V];
  const value_1 = memory[at + U];
  const value_2 = memory[at + V];
  memory[at + LAST_U] = value_1;
  memory[at + LAST_V] = value_2;
  memory[at + SAMPLES] += 1;
  return [MOVED, dt, before_u, before_v, start];
}
export function settled(memory, at, samples, settle_s) {
  const long_enough = memory[at + T] - memory[at + SINCE] >= settle_s;
  return long_enough && memory[at + SAMPLES] >= samples ? 1 : 0;
}
export function motion(memory, at, event, hand, settled, start) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const velocity = hand[0];
  const acceleration = hand[1];
  const vx = velocity[0];
  const vy = velocity[1];
  const ax = acceleration[0];
  const ay = acceleration[1];
  return [t, x, y, vx, vy, ax, ay, settled, start ? 1 : 0, memory[at + COUNTS]];
}
