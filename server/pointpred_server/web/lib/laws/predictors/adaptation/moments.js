// Written by `make laws` from moments.py: change that and run it again.
import * as $records from "../../records.js";
export const APART_S = 0.0071;
export const NEAR_PX = 8;
export const NEAR_SHARE = 0.03;
export const SAMPLES_LEAST = 6;
export const LEAST_S = 0.08;
export const SHORTEST_PX = 1e-06;
/** @returns {[number, boolean]} */
export function next_moment(s, last_t, cursor, most, s_at = 0) {
  const t = cursor[0];
  const x = cursor[1];
  const y = cursor[2];
  let count = Math.trunc(s[s_at]);
  let full = false;
  if (count === 0 || t !== last_t) {
    if (count === 0) {
      s[s_at + 1] = APART_S;
    } else if (t - last_t < s[s_at + 1]) {
      return [-1, false];
    }
    if (count === most) {
      if (x === s[s_at + 2] && y === s[s_at + 3]) {
        return [-1, false];
      }
      count = Math.floor(most / 2);
      full = true;
      s[s_at + 1] *= 2;
    }
    count += 1;
    s[s_at] = count;
  }
  s[s_at + 2] = x;
  s[s_at + 3] = y;
  return [count - 1, full];
}
export function has_come(s, t, span, share, s_at = 0) {
  const start = span[0];
  const end = span[1];
  return t - start <= share * (end - start) + $records.ROUNDING_S + 0.5 * s[s_at + 1];
}
