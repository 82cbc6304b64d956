// Written by `make laws` from kep.py: change that and run it again.
import { hypot, larger, smaller } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $least_squares from "../regression/least_squares.js";
import * as $stage from "../stage.js";
export const STEPS_MOST = 80;
export const DEGREE = 0;
export const REACH = 1;
export const CHANGE_MOST = 2;
export const AT = 3;
export const FIT = 12;
export const COEFFICIENTS = 50;
export const LENGTH = 55;
export const ACCEPTED = 56;
export const ACCEPTED_X = 57;
export const ACCEPTED_Y = 58;
export const EXCITATION_LEAST = 1e-05;
export function value(p, w) {
  return p[0] + w * (p[1] + w * (p[2] + w * (p[3] + w * p[4])));
}
export function derivative(p) {
  return [p[1], 2 * p[2], 3 * p[3], 4 * p[4], 0];
}
export function bends(p, far) {
  const a = 6 * p[4];
  const b = 3 * p[3];
  const c = p[2];
  const discriminant = b * b - 4 * a * c;
  if (discriminant < 0) {
    return [far, far];
  }
  const half = -0.5 * (b + (b >= 0 ? Math.sqrt(discriminant) : -Math.sqrt(discriminant)));
  let one = a !== 0 ? half / a : far;
  let other = half !== 0 ? c / half : far;
  one = 0 < one && one < far ? one : far;
  other = 0 < other && other < far ? other : far;
  return [smaller(one, other), larger(one, other)];
}
export function zero_between(p, low, high) {
  const at_low = value(p, low);
  if (!(at_low * value(p, high) < 0)) {
    return high;
  }
  let w = 0.5 * (low + high);
  for (let _ = 0; _ < STEPS_MOST; _++) {
    const here = value(p, w);
    if (here === 0) {
      return w;
    }
    if ((here > 0) === (at_low > 0)) {
      low = w;
    } else {
      high = w;
    }
    const slope = p[1] + w * (2 * p[2] + w * (3 * p[3] + w * 4 * p[4]));
    let new_ = slope !== 0 ? w - here / slope : low;
    if (!(low < new_ && new_ < high)) {
      new_ = 0.5 * (low + high);
    }
    if (Math.abs(new_ - w) <= 1e-13 * Math.abs(w)) {
      return new_;
    }
    w = new_;
  }
  return w;
}
export function first_zero(p, far) {
  if (!(p[0] > 0)) {
    return NaN;
  }
  const values_1 = bends(p, far);
  const bend_1 = values_1[0];
  const bend_2 = values_1[1];
  const bounds = [bend_1, bend_2, far];
  const slope = derivative(p);
  let left = 0;
  for (let i = 0; i < 3; i++) {
    const turn = zero_between(slope, left, bounds[i]);
    if (value(p, turn) <= 0) {
      return zero_between(p, left, turn);
    }
    if (value(p, bounds[i]) <= 0) {
      return zero_between(p, turn, bounds[i]);
    }
    left = bounds[i];
  }
  return NaN;
}
export function add(memory, distance, speed) {
  const terms = Math.trunc(memory[DEGREE]) + 1;
  let power = 1;
  for (let j = 0; j < terms; j++) {
    memory[FIT + $least_squares.REGRESSOR + j] = power;
    power *= distance;
  }
  $least_squares.advance(memory, FIT, terms, 1, speed);
}
export function remaining(memory, travelled) {
  const degree = Math.trunc(memory[DEGREE]);
  if (!(travelled > 0 && $least_squares.solve(memory, FIT, degree + 1, EXCITATION_LEAST, COEFFICIENTS))) {
    return NaN;
  }
  const c0 = memory[COEFFICIENTS];
  const c1 = memory[COEFFICIENTS + 1] * travelled;
  const c2 = memory[COEFFICIENTS + 2] * (travelled * travelled);
  const c3 = degree > 2 ? memory[COEFFICIENTS + 3] * Math.pow(travelled, 3) : 0;
  const c4 = degree > 3 ? memory[COEFFICIENTS + 4] * Math.pow(travelled, 4) : 0;
  const here = [value([c0, c1, c2, c3, c4], 1), c1 + 2 * c2 + 3 * c3 + 4 * c4, c2 + 3 * c3 + 6 * c4, c3 + 4 * c4, c4];
  return first_zero(here, memory[REACH]) * travelled;
}
export function judge(memory, length, x, y) {
  const before = memory[LENGTH];
  if (before > 0 && Math.abs(length - before) < memory[CHANGE_MOST] * before) {
    memory[ACCEPTED] = 1;
    memory[ACCEPTED_X] = x;
    memory[ACCEPTED_Y] = y;
  }
  memory[LENGTH] = length > 0 ? length : 0;
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
  const travelled = memory[AT + 8];
  if (new_) {
    memory.fill(0, FIT);
  }
  if (new_ || dt > 0) {
    add(memory, travelled, hypot(m[3], m[4]));
  }
  const away_x = m[1] - memory[AT + 5];
  const away_y = m[2] - memory[AT + 6];
  const away = hypot(away_x, away_y);
  let end_x = NaN;
  let end_y = NaN;
  if (away > 0) {
    const ahead = remaining(memory, travelled);
    end_x = m[1] + ahead * (away_x / away);
    end_y = m[2] + ahead * (away_y / away);
    if (dt > 0) {
      judge(memory, travelled + ahead, end_x, end_y);
    }
  }
  if (memory[CHANGE_MOST] > 0) {
    const accepted = memory[ACCEPTED] === 1;
    end_x = accepted ? memory[ACCEPTED_X] : NaN;
    end_y = accepted ? memory[ACCEPTED_Y] : NaN;
  }
  return $records.endpoint(m[0], end_x, end_y, $predictors_movement.phase(memory, m, AT));
}
export const KinematicEndpointPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 3, learned: 0, states: 56,
  parameters: [
    { name: "degree", low: 2, high: 4, default: 4, whole: true },
    { name: "reach", low: 0.001, high: 1000000, default: 10 },
    { name: "change_most", low: 1e-06, high: 1, default: null, absent: 0 },
  ],
};
