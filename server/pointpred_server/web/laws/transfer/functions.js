// Written by `make laws` from functions.py: change that and run it again.
import { copysign, larger, smaller } from "../arithmetic.js";
export const CONSTANT = 1;
export const SIGMOID = 2;
export const ARCTAN = 3;
export const BOUNDED = 5;
export const COEFFICIENTS_MOST = 7;
export const SLOTS = 8;
export const BOUNDED_COEFFICIENTS = 5;
export const LOW = 6;
export const HIGH = 7;
export const GAIN_MIN = 1;
export const GAIN_MAX = 2;
export const SPEED_LOW = 3;
export const SPEED_HIGH = 4;
export const MACOS = [1, 15, 0.05, 0.6];
export function gain(memory, at, speed) {
  if (memory[at] === CONSTANT) {
    return memory[at + 1];
  }
  if (memory[at] === SIGMOID) {
    let share = (speed - memory[at + SPEED_LOW]) / (memory[at + SPEED_HIGH] - memory[at + SPEED_LOW]);
    share = smaller(larger(share, 0), 1);
    return memory[at + GAIN_MIN] + share * (memory[at + GAIN_MAX] - memory[at + GAIN_MIN]);
  }
  if (memory[at] === ARCTAN) {
    return speed > 0 ? Math.atan(speed) / speed : 1;
  }
  let value = 0;
  if (memory[at] === BOUNDED) {
    const within = smaller(larger(speed, memory[at + LOW]), memory[at + HIGH]);
    for (let i = 0; i < BOUNDED_COEFFICIENTS; i++) {
      value = value * within + memory[at + BOUNDED_COEFFICIENTS - i];
    }
    return value;
  }
  for (let i = 0, end_1 = COEFFICIENTS_MOST - 1; i < end_1; i++) {
    value = value * speed + memory[at + COEFFICIENTS_MOST - i];
  }
  if (memory[at + 1] === 0) {
    return value;
  }
  return speed > 0 ? value + memory[at + 1] / speed : copysign(Infinity, memory[at + 1]);
}
