// Written by `make laws` from switched_direction.py: change that and run it again.
import { hypot } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export function begin_submovement(s, x, y, s_at = 0) {
  s[s_at] = 0;
  s[s_at + 3] = 0;
  s[s_at + 1] = x;
  s[s_at + 2] = y;
  s[s_at + 4] = x;
  s[s_at + 5] = y;
  s[s_at + 6] = x;
  s[s_at + 7] = y;
}
export function follow_submovement(s, rise, x, y, speed, s_at = 0) {
  if (speed < s[s_at] && speed <= s[s_at + 3] + rise * s[s_at]) {
    if (speed <= s[s_at + 3]) {
      s[s_at + 3] = speed;
      s[s_at + 4] = x;
      s[s_at + 5] = y;
    }
    return;
  }
  if (speed < s[s_at]) {
    const value_1 = s[s_at + 4];
    const value_2 = s[s_at + 5];
    s[s_at + 6] = value_1;
    s[s_at + 7] = value_2;
  }
  s[s_at] = speed;
  s[s_at + 1] = x;
  s[s_at + 2] = y;
  s[s_at + 3] = speed;
  s[s_at + 4] = x;
  s[s_at + 5] = y;
}
export function gain(hand, dt, away_x, away_y, vx, vy, hand_at = 0) {
  hand[hand_at + 2] += 0.5 * dt * (vx + hand[hand_at]);
  hand[hand_at + 3] += 0.5 * dt * (vy + hand[hand_at + 1]);
  hand[hand_at] = vx;
  hand[hand_at + 1] = vy;
  hand[hand_at + 4] += dt * (away_x * hand[hand_at + 2] + away_y * hand[hand_at + 3]);
  hand[hand_at + 5] += dt * (hand[hand_at + 2] * hand[hand_at + 2] + hand[hand_at + 3] * hand[hand_at + 3]);
  if (!(hand[hand_at + 4] > 0 && hand[hand_at + 5] > 0)) {
    return 0;
  }
  return hand[hand_at + 4] / hand[hand_at + 5];
}
export function time_constant(own, typical_s, done, peak) {
  if (own === 0) {
    return typical_s;
  }
  return Math.pow(done / peak, own) * Math.pow(typical_s, 1 - own);
}
export function approach(settings, s, px_m, x, y, speed, settings_at = 0, s_at = 0) {
  const done = hypot(s[s_at + 1] - s[s_at + 6], s[s_at + 2] - s[s_at + 7]);
  if (done === 0) {
    return 0;
  }
  const at_switch = 1 / time_constant(settings[settings_at + 2], settings[settings_at + 1], done, s[s_at] * px_m);
  const since = hypot(x - s[s_at + 1], y - s[s_at + 2]);
  const slope = since > 0 ? (s[s_at] - speed) * px_m / since : 0;
  const share = Math.pow(speed / s[s_at], settings[settings_at + 3]);
  return share * at_switch + (1 - share) * settings[settings_at + 4] * slope;
}
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const settings_at = memory_at;
  const s_at = memory_at + 6;
  const submovement_at = memory_at + 15;
  const hand_at = memory_at + 23;
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  if (new_) {
    memory.fill(0, hand_at, hand_at + 6);
  }
  if (new_ || m[0] === memory[s_at + 4]) {
    begin_submovement(memory, m[1], m[2], submovement_at);
  }
  const speed = hypot(m[3], m[4]);
  follow_submovement(memory, memory[settings_at], m[1], m[2], speed, submovement_at);
  const px_m = gain(memory, dt, m[1] - memory[s_at + 5], m[2] - memory[s_at + 6], m[3], m[4], hand_at);
  const known = px_m > 0 && speed > $predictors_movement.STILL_M_S;
  const rate = known ? approach(memory, memory, px_m, m[1], m[2], speed, settings_at, submovement_at) : 0;
  let ahead_s = rate > 0 ? 1 / rate : 0;
  const braking = -(m[5] * m[3] + m[6] * m[4]);
  if (braking > 0 && ahead_s * braking > memory[settings_at + 5] * speed * speed) {
    ahead_s = memory[settings_at + 5] * speed * speed / braking;
  }
  const end_x = m[1] + ahead_s * px_m * m[3];
  const end_y = m[2] + ahead_s * px_m * m[4];
  return $records.endpoint(m[0], end_x, end_y, $predictors_movement.phase(memory, m, s_at));
}
export const SwitchedDirectionPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 6, learned: 0, states: 23,
  parameters: [
    { name: "rise", unit: "share of peak speed", low: 0, high: 10, default: 0.6 },
    { name: "typical_s", unit: "s", low: 0.0001, high: 10, default: 0.045 },
    { name: "own", low: 0, high: 1, default: 0.4 },
    { name: "turn", low: 0, high: 1, default: 0.6 },
    { name: "watched", low: 0, high: 10, default: 0.65 },
    { name: "stopping", low: 0, high: 1000000, default: 0.5 },
  ],
};
