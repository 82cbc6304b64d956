// Written by `make laws` from functions.py: change that and run it again.
import { copysign, larger, smaller } from "../arithmetic.js";
export const CONSTANT = 1;
export const SIGMOID = 2;
export const ARCTAN = 3;
export const POLYNOMIAL = 4;
export const BOUNDED = 5;
export const COEFFICIENTS_MOST = 7;
export const BOUNDED_COEFFICIENTS = 5;
export const MACOS = [1, 15, 0.05, 0.6];
export const SLOTS = 8;
export function gain(f, speed, f_at = 0) {
  if (f[f_at] === CONSTANT) {
    return f[f_at + 1];
  }
  if (f[f_at] === SIGMOID) {
    const gain_min = f[f_at + 1];
    const gain_max = f[f_at + 2];
    const speed_low = f[f_at + 3];
    const speed_high = f[f_at + 4];
    let share = (speed - speed_low) / (speed_high - speed_low);
    share = smaller(larger(share, 0), 1);
    return gain_min + share * (gain_max - gain_min);
  }
  if (f[f_at] === ARCTAN) {
    return speed > 0 ? Math.atan(speed) / speed : 1;
  }
  let value = 0;
  if (f[f_at] === BOUNDED) {
    const low = f[f_at + BOUNDED_COEFFICIENTS + 1];
    const high = f[f_at + BOUNDED_COEFFICIENTS + 2];
    const within = smaller(larger(speed, low), high);
    for (let i = BOUNDED_COEFFICIENTS - 1, end_1 = -1; i > end_1; i--) {
      value = value * within + f[f_at + i + 1];
    }
    return value;
  }
  for (let i = COEFFICIENTS_MOST - 1; i > 0; i--) {
    value = value * speed + f[f_at + i + 1];
  }
  if (f[f_at + 1] === 0) {
    return value;
  }
  return speed > 0 ? value + f[f_at + 1] / speed : copysign(Infinity, f[f_at + 1]);
}
export function cursor_speed(f, speed, f_at = 0) {
  if (f[f_at] === POLYNOMIAL) {
    let value = 0;
    for (let i = COEFFICIENTS_MOST - 1, end_1 = -1; i > end_1; i--) {
      value = value * speed + f[f_at + i + 1];
    }
    return value;
  }
  if (f[f_at] === ARCTAN) {
    return Math.atan(speed);
  }
  return gain(f, speed, f_at) * speed;
}
