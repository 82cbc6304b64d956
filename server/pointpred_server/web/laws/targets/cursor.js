// Written by `make laws` from cursor.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $records from "../records.js";
export const PAUSE_S = 0.3;
export const SPEED_S = 0.03;
export const SLOWER_S = 0.06;
export const TRAIL_SHARE = 0.35;
export const KNOWN = 0;
export const T = 1;
export const X = 2;
export const Y = 3;
export const PRESSED = 4;
export const T0 = 5;
export const X0 = 6;
export const Y0 = 7;
export const TRAIL_X = 8;
export const TRAIL_Y = 9;
export const VX = 10;
export const VY = 11;
export const SPEED = 12;
export const SLOW = 13;
export const PEAK = 14;
export const STATES = 15;
export function usable(t, x, y) {
  return Math.abs(t) < $records.LATEST_S && Math.abs(x) <= $records.LARGEST && Math.abs(y) <= $records.LARGEST;
}
export function follow(memory, t, x, y, pressed) {
  const dt = t - memory[T];
  const released = memory[PRESSED] === 1 && pressed === 0;
  const starts = memory[KNOWN] === 0 || released || dt > PAUSE_S + $records.ROUNDING_S;
  if (starts) {
    memory[T0] = t;
    memory[X0] = x;
    memory[Y0] = y;
    memory[TRAIL_X] = x;
    memory[TRAIL_Y] = y;
    memory[VX] = memory[VY] = memory[SPEED] = memory[SLOW] = memory[PEAK] = 0;
  } else {
    const way = hypot(x - memory[X], y - memory[Y]);
    const far = hypot(x - memory[X0], y - memory[Y0]);
    let share = far > 0 ? 1 - Math.exp(-way / (TRAIL_SHARE * far)) : 1;
    memory[TRAIL_X] += share * (x - memory[TRAIL_X]);
    memory[TRAIL_Y] += share * (y - memory[TRAIL_Y]);
    if (dt > 0) {
      share = 1 - Math.exp(-dt / SPEED_S);
      memory[VX] += share * ((x - memory[X]) / dt - memory[VX]);
      memory[VY] += share * ((y - memory[Y]) / dt - memory[VY]);
      memory[SPEED] = hypot(memory[VX], memory[VY]);
      memory[SLOW] += (1 - Math.exp(-dt / SLOWER_S)) * (memory[SPEED] - memory[SLOW]);
    }
    memory[PEAK] = larger(memory[PEAK], memory[SPEED]);
  }
  memory[KNOWN] = 1;
  memory[PRESSED] = pressed;
  memory[T] = t;
  memory[X] = x;
  memory[Y] = y;
  return released;
}
export function until(memory, x, y, width, height) {
  const dx = larger(Math.abs(x - memory[X]) - 0.5 * width, 0);
  const dy = larger(Math.abs(y - memory[Y]) - 0.5 * height, 0);
  const way = hypot(dx, dy);
  if (way === 0) {
    return 0;
  }
  return memory[SPEED] > 0 ? way / memory[SPEED] : Infinity;
}
