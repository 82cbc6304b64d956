// Written by `make laws` from sampling.py: change that and run it again.
import * as $records from "../records.js";
export const MERGED = 0;
export const RESTARTED = 1;
export const MOVED = 2;
export function fill(values, memory) {
  memory[0] = values[0] > 0 ? $records.METRES_PER_INCH / values[0] : 0;
  memory[1] = $records.METRES_PER_INCH / values[1];
  for (let i = 2, end_1 = values.length; i < end_1; i++) {
    memory[i] = values[i];
  }
}
/** @returns {[number, number, number, number, boolean]} */
export function accept(settings, s, event, settings_at = 0, s_at = 0) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const dx = event[3];
  const dy = event[4];
  const buttons = event[5];
  const started = s[s_at] === 1;
  let fault = $records.fault_of_event(event);
  if (fault === $records.FINE && started && t < s[s_at + 1]) {
    fault = $records.ORDER;
  }
  if (fault !== $records.FINE) {
    return [-fault, 0, 0, 0, false];
  }
  const dt = t - s[s_at + 1];
  const released = (Math.trunc(s[s_at + 4]) & ~Math.trunc(buttons)) !== 0;
  const start = !started || released || dt > settings[settings_at + 3] + $records.ROUNDING_S;
  const counted = dx === dx && settings[settings_at] > 0;
  const merged = started && dt === 0;
  const restarted = !started || dt > settings[settings_at + 2] + $records.ROUNDING_S || merged && s[s_at + 7] === 1;
  if (restarted) {
    s[s_at + 5] = 0;
    s[s_at + 6] = 0;
    s[s_at + 10] = 0;
    s[s_at + 11] = 0;
    s[s_at + 9] = t;
  } else if (counted) {
    s[s_at + 5] += dx * settings[settings_at];
    s[s_at + 6] += dy * settings[settings_at];
  } else {
    s[s_at + 5] += (x - s[s_at + 2]) * settings[settings_at + 1];
    s[s_at + 6] += (y - s[s_at + 3]) * settings[settings_at + 1];
  }
  s[s_at] = 1;
  s[s_at + 1] = t;
  s[s_at + 2] = x;
  s[s_at + 3] = y;
  s[s_at + 4] = buttons;
  s[s_at + 8] = counted ? 1 : 0;
  if (restarted) {
    s[s_at + 7] = 1;
    return [RESTARTED, dt, 0, 0, start];
  }
  if (merged) {
    return [MERGED, 0, 0, 0, start];
  }
  const before_u = s[s_at + 10];
  const before_v = s[s_at + 11];
  const value_1 = s[s_at + 5];
  const value_2 = s[s_at + 6];
  s[s_at + 10] = value_1;
  s[s_at + 11] = value_2;
  s[s_at + 7] += 1;
  return [MOVED, dt, before_u, before_v, start];
}
export function settled(s, samples, settle_s, s_at = 0) {
  const long_enough = s[s_at + 1] - s[s_at + 9] >= settle_s;
  return long_enough && s[s_at + 7] >= samples ? 1 : 0;
}
export function motion(s, event, hand, settled, start, s_at = 0) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const velocity = hand[0];
  const acceleration = hand[1];
  const vx = velocity[0];
  const vy = velocity[1];
  const ax = acceleration[0];
  const ay = acceleration[1];
  return [t, x, y, vx, vy, ax, ay, settled, start ? 1 : 0, s[s_at + 8]];
}
