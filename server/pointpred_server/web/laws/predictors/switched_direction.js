// Written by `make laws` from switched_direction.py: change that and run it again.
import { hypot } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const PEAK = 0;
export const PEAK_X = 1;
export const PEAK_Y = 2;
export const VALLEY = 3;
export const VALLEY_X = 4;
export const VALLEY_Y = 5;
export const START_X = 6;
export const START_Y = 7;
export const RISE = 0;
export const TYPICAL_S = 1;
export const OWN = 2;
export const TURN = 3;
export const WATCHED = 4;
export const STOPPING = 5;
export const AT = 6;
export const UNIT = 15;
export const VX = 23;
export const VY = 24;
export const HAND_X = 25;
export const HAND_Y = 26;
export const CROSS = 27;
export const SQUARE = 28;
export const END = 29;
export function begin_submovement(memory, at, x, y) {
  memory[at + PEAK] = 0;
  memory[at + VALLEY] = 0;
  memory[at + PEAK_X] = x;
  memory[at + PEAK_Y] = y;
  memory[at + VALLEY_X] = x;
  memory[at + VALLEY_Y] = y;
  memory[at + START_X] = x;
  memory[at + START_Y] = y;
}
export function follow_submovement(memory, at, rise, x, y, speed) {
  const peak = memory[at + PEAK];
  const valley = memory[at + VALLEY];
  if (speed < peak && speed <= valley + rise * peak) {
    if (speed <= valley) {
      memory[at + VALLEY] = speed;
      memory[at + VALLEY_X] = x;
      memory[at + VALLEY_Y] = y;
    }
    return;
  }
  if (speed < peak) {
    const value_1 = memory[at + VALLEY_X];
    const value_2 = memory[at + VALLEY_Y];
    memory[at + START_X] = value_1;
    memory[at + START_Y] = value_2;
  }
  memory[at + PEAK] = speed;
  memory[at + VALLEY] = speed;
  memory[at + PEAK_X] = x;
  memory[at + PEAK_Y] = y;
  memory[at + VALLEY_X] = x;
  memory[at + VALLEY_Y] = y;
}
export function gain(memory, dt, away_x, away_y, vx, vy) {
  memory[HAND_X] += 0.5 * dt * (vx + memory[VX]);
  memory[HAND_Y] += 0.5 * dt * (vy + memory[VY]);
  memory[VX] = vx;
  memory[VY] = vy;
  const hand_x = memory[HAND_X];
  const hand_y = memory[HAND_Y];
  memory[CROSS] += dt * (away_x * hand_x + away_y * hand_y);
  memory[SQUARE] += dt * (hand_x * hand_x + hand_y * hand_y);
  if (!(memory[CROSS] > 0 && memory[SQUARE] > 0)) {
    return 0;
  }
  return memory[CROSS] / memory[SQUARE];
}
export function time_constant(own, typical_s, done, peak) {
  if (own === 0) {
    return typical_s;
  }
  return Math.pow(done / peak, own) * Math.pow(typical_s, 1 - own);
}
export function approach(memory, px_m, x, y, speed) {
  const peak = memory[UNIT + PEAK];
  const peak_x = memory[UNIT + PEAK_X];
  const peak_y = memory[UNIT + PEAK_Y];
  const done = hypot(peak_x - memory[UNIT + START_X], peak_y - memory[UNIT + START_Y]);
  if (done === 0) {
    return 0;
  }
  const at_switch = 1 / time_constant(memory[OWN], memory[TYPICAL_S], done, peak * px_m);
  const since = hypot(x - peak_x, y - peak_y);
  const slope = since > 0 ? (peak - speed) * px_m / since : 0;
  const share = Math.pow(speed / peak, memory[TURN]);
  return share * at_switch + (1 - share) * memory[WATCHED] * slope;
}
export function step(memory, motion) {
  const m = motion;
  const values_1 = $predictors_movement.follow(memory, m, AT);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  if (new_) {
    memory.fill(0, VX, END);
  }
  if (new_ || m[0] === memory[AT + 4]) {
    begin_submovement(memory, UNIT, m[1], m[2]);
  }
  const speed = hypot(m[3], m[4]);
  follow_submovement(memory, UNIT, memory[RISE], m[1], m[2], speed);
  const phase = $predictors_movement.phase(memory, m, AT);
  const px_m = gain(memory, dt, m[1] - memory[AT + 5], m[2] - memory[AT + 6], m[3], m[4]);
  const rate = px_m > 0 && speed > $predictors_movement.STILL_M_S ? approach(memory, px_m, m[1], m[2], speed) : 0;
  let ahead_s = rate > 0 ? 1 / rate : 0;
  const braking = -(m[5] * m[3] + m[6] * m[4]);
  if (braking > 0 && ahead_s * braking > memory[STOPPING] * speed * speed) {
    ahead_s = memory[STOPPING] * speed * speed / braking;
  }
  return $records.endpoint(m[0], m[1] + ahead_s * px_m * m[3], m[2] + ahead_s * px_m * m[4], phase);
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
