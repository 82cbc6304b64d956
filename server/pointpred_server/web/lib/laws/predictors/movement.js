// Written by `make laws` from movement.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $records from "../records.js";
export const STILL_M_S = 0.002;
export const CORRECTIVE_FRACTION = 0.2;
export const NUMBERS = 7;
export const STILL = 0;
export const BALLISTIC = 1;
export const CORRECTIVE = 2;
export function fault_of(s, m, s_at = 0) {
  for (let i = 0; i < NUMBERS; i++) {
    if (!(Math.abs(m[i]) <= $records.MOTION_MOST)) {
      return $records.MOTION_FIELD + i;
    }
  }
  return s[s_at] === 1 && m[0] < s[s_at + 1] ? $records.ORDER : $records.FINE;
}
export function refuse(s, m, fault, s_at = 0) {
  return $records.refused(fault, fault === $records.ORDER ? s[s_at + 1] : m[fault - $records.MOTION_FIELD]);
}
/** @returns {[number, boolean, number]} */
export function follow(s, m, s_at = 0) {
  const t = m[0];
  const x = m[1];
  const y = m[2];
  const fault = fault_of(s, m, s_at);
  if (fault !== $records.FINE) {
    return [fault, false, 0];
  }
  const new_ = m[8] === 1 || s[s_at] === 0;
  const dt = new_ ? 0 : t - s[s_at + 1];
  if (new_ || t === s[s_at + 4]) {
    s[s_at + 4] = t;
    s[s_at + 5] = x;
    s[s_at + 6] = y;
    s[s_at + 8] = 0;
  } else {
    s[s_at + 8] += hypot(x - s[s_at + 2], y - s[s_at + 3]);
  }
  if (new_) {
    s[s_at + 7] = 0;
  }
  s[s_at] = 1;
  s[s_at + 1] = t;
  s[s_at + 2] = x;
  s[s_at + 3] = y;
  s[s_at + 7] = larger(s[s_at + 7], hypot(m[3], m[4]));
  return [$records.FINE, new_, dt];
}
export function phase(s, m, s_at = 0) {
  const speed = hypot(m[3], m[4]);
  if (speed < STILL_M_S) {
    return STILL;
  }
  return speed >= CORRECTIVE_FRACTION * s[s_at + 7] ? BALLISTIC : CORRECTIVE;
}
