// Written by `make laws` from history.py: change that and run it again.
import { hypot, larger, remainder, smaller } from "../../arithmetic.js";
export const TICK_S = 0.008;
export const TICKS = 66;
export const STILL_GAP_S = 0.1;
export function begin(s, s_at = 0) {
  s[s_at] = 1;
  s.fill(0, s_at + 1, s_at + 4);
  s.fill(0, s_at + 4, s_at + 7);
}
export function extend(s, last, now, s_at = 0) {
  const last_t = last[0];
  const last_x = last[1];
  const last_y = last[2];
  const t = now[0];
  const x = now[1];
  const y = now[2];
  const count = Math.trunc(s[s_at]);
  const newest = Math.floor(t / TICK_S);
  const old_at = s_at + 1;
  for (let number = larger(count, newest + 1 - TICKS), end_1 = newest + 1; number < end_1; number++) {
    let share = 0;
    if (t - last_t <= STILL_GAP_S) {
      share = smaller(larger((number * TICK_S - last_t) / (t - last_t), 0), 1);
    }
    const tick_at = s_at + remainder(number, TICKS) * 3 + 4;
    s[tick_at] = last_x + share * (x - last_x);
    s[tick_at + 1] = last_y + share * (y - last_y);
    s[old_at + 2] += hypot(s[tick_at] - s[old_at], s[tick_at + 1] - s[old_at + 1]);
    s[tick_at + 2] = s[old_at + 2];
    const value_2 = s[tick_at];
    const value_3 = s[tick_at + 1];
    s[old_at] = value_2;
    s[old_at + 1] = value_3;
  }
  s[s_at] = larger(count, newest + 1);
  return [t, x, y, s[old_at + 2] + hypot(x - s[old_at], y - s[old_at + 1])];
}
export function past(s, now, ago, s_at = 0) {
  let after_path, after_x, after_y, share;
  const then = now[0] - ago;
  if (then <= 0) {
    return [0, 0, 0];
  }
  const count = Math.trunc(s[s_at]);
  const number = Math.floor(then / TICK_S);
  if (number > count - 1) {
    return [now[1], now[2], now[3]];
  }
  const before_at = s_at + remainder(number, TICKS) * 3 + 4;
  if (number === count - 1) {
    const span = now[0] - number * TICK_S;
    share = span > 0 ? (then - number * TICK_S) / span : 1;
    after_x = now[1];
    after_y = now[2];
    after_path = now[3];
  } else {
    share = (then - number * TICK_S) / TICK_S;
    const after_at = s_at + remainder(number + 1, TICKS) * 3 + 4;
    after_x = s[after_at];
    after_y = s[after_at + 1];
    after_path = s[after_at + 2];
  }
  return [s[before_at] + share * (after_x - s[before_at]), s[before_at + 1] + share * (after_y - s[before_at + 1]), s[before_at + 2] + share * (after_path - s[before_at + 2])];
}
