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
export const STATES = 15;
export function usable(t, x, y) {
  return Math.abs(t) < $records.LATEST_S && Math.abs(x) <= $records.LARGEST && Math.abs(y) <= $records.LARGEST;
}
export function begins(s, t, pressed, s_at = 0) {
  return s[s_at] === 0 || s[s_at + 4] === 1 && pressed === 0 || t - s[s_at + 1] > PAUSE_S + $records.ROUNDING_S;
}
export function follow(s, t, x, y, pressed, s_at = 0) {
  const dt = t - s[s_at + 1];
  const released = s[s_at + 4] === 1 && pressed === 0;
  if (begins(s, t, pressed, s_at) || t === s[s_at + 5]) {
    s[s_at + 5] = t;
    s[s_at + 6] = x;
    s[s_at + 7] = y;
    s[s_at + 8] = x;
    s[s_at + 9] = y;
    s[s_at + 10] = s[s_at + 11] = s[s_at + 12] = s[s_at + 13] = s[s_at + 14] = 0;
  } else {
    const way = hypot(x - s[s_at + 2], y - s[s_at + 3]);
    const far = hypot(x - s[s_at + 6], y - s[s_at + 7]);
    let share = far > 0 ? 1 - Math.exp(-way / (TRAIL_SHARE * far)) : 1;
    s[s_at + 8] += share * (x - s[s_at + 8]);
    s[s_at + 9] += share * (y - s[s_at + 9]);
    if (dt > 0) {
      share = 1 - Math.exp(-dt / SPEED_S);
      s[s_at + 10] += share * ((x - s[s_at + 2]) / dt - s[s_at + 10]);
      s[s_at + 11] += share * ((y - s[s_at + 3]) / dt - s[s_at + 11]);
      s[s_at + 12] = hypot(s[s_at + 10], s[s_at + 11]);
      s[s_at + 13] += (1 - Math.exp(-dt / SLOWER_S)) * (s[s_at + 12] - s[s_at + 13]);
    }
    s[s_at + 14] = larger(s[s_at + 14], s[s_at + 12]);
  }
  s[s_at] = 1;
  s[s_at + 4] = pressed;
  s[s_at + 1] = t;
  s[s_at + 2] = x;
  s[s_at + 3] = y;
  return released;
}
export function until(s, x, y, width, height, s_at = 0) {
  const dx = larger(Math.abs(x - s[s_at + 2]) - 0.5 * width, 0);
  const dy = larger(Math.abs(y - s[s_at + 3]) - 0.5 * height, 0);
  const way = hypot(dx, dy);
  if (way === 0) {
    return 0;
  }
  return s[s_at + 12] > 0 ? way / s[s_at + 12] : Infinity;
}
