// Written by `make laws` from kep.py: change that and run it again.
import { hypot, larger, smaller, view } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $least_squares from "../regression/least_squares.js";
import * as $stage from "../stage.js";
export const STEPS_MOST = 80;
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
export function add(fit, degree, distance, speed, fit_at = 0) {
  const regression = $least_squares.parts(view(fit, fit_at + 3, fit_at + 38), degree + 1);
  let power = 1;
  for (let j = 0, end_1 = degree + 1; j < end_1; j++) {
    regression[0][j] = power;
    power *= distance;
  }
  $least_squares.advance(fit, regression, 1, speed, fit_at);
}
export function remaining(fit, degree, reach, travelled, fit_at = 0) {
  const c = view(fit, fit_at + 38, fit_at + 43);
  const regression = $least_squares.parts(view(fit, fit_at + 3, fit_at + 38), degree + 1);
  if (!(travelled > 0 && $least_squares.solve(regression, EXCITATION_LEAST, c))) {
    return NaN;
  }
  const c0 = c[0];
  const c1 = c[1] * travelled;
  const c2 = c[2] * (travelled * travelled);
  const c3 = degree > 2 ? c[3] * Math.pow(travelled, 3) : 0;
  const c4 = degree > 3 ? c[4] * Math.pow(travelled, 4) : 0;
  const here = [value([c0, c1, c2, c3, c4], 1), c1 + 2 * c2 + 3 * c3 + 4 * c4, c2 + 3 * c3 + 6 * c4, c3 + 4 * c4, c4];
  return first_zero(here, reach) * travelled;
}
export function judge(check, change_most, length, x, y, check_at = 0) {
  const before = check[check_at];
  if (before > 0 && Math.abs(length - before) < change_most * before) {
    check[check_at + 1] = 1;
    check[check_at + 2] = x;
    check[check_at + 3] = y;
  }
  check[check_at] = length > 0 ? length : 0;
}
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const settings_at = memory_at;
  const s_at = memory_at + 3;
  const fit_at = memory_at + 12;
  const check_at = memory_at + 55;
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  if (new_) {
    memory.fill(0, fit_at, fit_at + 43);
    memory.fill(0, check_at, check_at + 4);
  }
  const degree = Math.trunc(memory[settings_at]);
  const travelled = memory[s_at + 8];
  if (new_ || dt > 0) {
    add(memory, degree, travelled, hypot(m[3], m[4]), fit_at);
  }
  const away_x = m[1] - memory[s_at + 5];
  const away_y = m[2] - memory[s_at + 6];
  const away = hypot(away_x, away_y);
  let end_x = NaN;
  let end_y = NaN;
  if (away > 0) {
    const ahead = remaining(memory, degree, memory[settings_at + 1], travelled, fit_at);
    end_x = m[1] + ahead * (away_x / away);
    end_y = m[2] + ahead * (away_y / away);
    if (dt > 0) {
      judge(memory, memory[settings_at + 2], travelled + ahead, end_x, end_y, check_at);
    }
  }
  if (memory[settings_at + 2] > 0) {
    const accepted = memory[check_at + 1] === 1;
    end_x = accepted ? memory[check_at + 2] : NaN;
    end_y = accepted ? memory[check_at + 3] : NaN;
  }
  return $records.endpoint(m[0], end_x, end_y, $predictors_movement.phase(memory, m, s_at));
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
