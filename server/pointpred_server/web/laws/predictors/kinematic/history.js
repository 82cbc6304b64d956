// Written by `make laws` from history.py: change that and run it again.
import { hypot, larger, remainder, smaller } from "../../arithmetic.js";
export const TICK_S = 0.008;
export const TICKS = 66;
export const STILL_GAP_S = 0.1;
export const COUNT = 0;
export const LAST_X = 1;
export const LAST_Y = 2;
export const LAST_PATH = 3;
export const RING = 4;
export const HEAD = 4;
export function begin(memory, at) {
  memory[at + COUNT] = 1;
  memory.fill(0, at + LAST_X, at + RING + 3);
}
export function extend(memory, at, last, now) {
  const last_t = last[0];
  const last_x = last[1];
  const last_y = last[2];
  const t = now[0];
  const x = now[1];
  const y = now[2];
  const count = Math.trunc(memory[at + COUNT]);
  const newest = Math.floor(t / TICK_S);
  let old_x = memory[at + LAST_X];
  let old_y = memory[at + LAST_Y];
  let path = memory[at + LAST_PATH];
  for (let tick = larger(count, newest + 1 - TICKS), end_1 = newest + 1; tick < end_1; tick++) {
    let share = 0;
    if (t - last_t <= STILL_GAP_S) {
      share = smaller(larger((tick * TICK_S - last_t) / (t - last_t), 0), 1);
    }
    const new_x = last_x + share * (x - last_x);
    const new_y = last_y + share * (y - last_y);
    path += hypot(new_x - old_x, new_y - old_y);
    const slot = at + RING + 3 * remainder(tick, TICKS);
    memory[slot] = new_x;
    memory[slot + 1] = new_y;
    memory[slot + 2] = path;
    old_x = new_x;
    old_y = new_y;
  }
  memory[at + COUNT] = larger(count, newest + 1);
  memory[at + LAST_X] = old_x;
  memory[at + LAST_Y] = old_y;
  memory[at + LAST_PATH] = path;
  return [t, x, y, path + hypot(x - old_x, y - old_y)];
}
export function past(memory, at, now, ago) {
  let after_path, after_x, after_y, share;
  const then = now[0] - ago;
  if (then <= 0) {
    return [0, 0, 0];
  }
  const count = Math.trunc(memory[at + COUNT]);
  const tick = Math.floor(then / TICK_S);
  if (tick > count - 1) {
    return [now[1], now[2], now[3]];
  }
  const slot = at + RING + 3 * remainder(tick, TICKS);
  if (tick === count - 1) {
    const span = now[0] - tick * TICK_S;
    share = span > 0 ? (then - tick * TICK_S) / span : 1;
    after_x = now[1];
    after_y = now[2];
    after_path = now[3];
  } else {
    share = (then - tick * TICK_S) / TICK_S;
    const after = at + RING + 3 * remainder(tick + 1, TICKS);
    after_x = memory[after];
    after_y = memory[after + 1];
    after_path = memory[after + 2];
  }
  return [memory[slot] + share * (after_x - memory[slot]), memory[slot + 1] + share * (after_y - memory[slot + 1]), memory[slot + 2] + share * (after_path - memory[slot + 2])];
}
