// Written by `make laws` from habits.py: change that and run it again.
import { hypot, larger, matrix, square } from "../../arithmetic.js";
import * as $distances from "./distances.js";
import * as $places from "./places.js";
export const OFTEN = 0;
export const LATELY = 1;
export const AFTER_SO_MANY = 2;
export const FROM_HERE = 3;
export const RULES = 4;
export const FIRST_RULES = [1, 0.15, 0.15, 0.15];
export const FIRST_RULES_OF = 8;
export const KEEP = 0.95;
export const RETURNS = 0.05;
export const RETURNS_OF = 1;
export const WIDTHS = [0.02, 0.05, 0.1];
export const WIDTHS_OF = 3;
export const LATE_AGE = 3;
export const LATE_ELSE = 0.1;
export const LAGS = 16;
export const LAG_KEEP = 0.95;
export const AGE = 60;
export const OFTEN_OF = 0.7;
export const LEAST_LOG = -200;
export function blend(out, rule, base, count, weight) {
  let total = weight;
  for (let i = 0; i < count; i++) {
    total += out[rule][i];
  }
  for (let i = 0; i < count; i++) {
    out[rule][i] = (out[rule][i] + weight * out[base][i]) / total;
  }
}
export function count_often(held, key, out, held_at = 0) {
  const count = Math.trunc(held[held_at]);
  let total = 0;
  for (let i = 0; i < count; i++) {
    if (held[held_at + i * 4 + 2] === key) {
      out[OFTEN][i] = held[held_at + i * 4 + 5];
      total += out[OFTEN][i];
    }
  }
  for (let i = 0; i < count; i++) {
    out[OFTEN][i] = total > 0 ? out[OFTEN][i] / total : 0;
  }
  return total;
}
export function count_last(s, held, out, s_at = 0, held_at = 0) {
  let number;
  for (let age = 0; age < $places.MOVEMENTS; age++) {
    number = $places.visited(held, age, held_at);
    if (number >= 0 && out[OFTEN][number] > 0) {
      out[LATELY][number] += Math.exp(-age / LATE_AGE);
    }
  }
  for (let age = LAGS - 1, end_1 = -1; age > end_1; age--) {
    number = $places.visited(held, age, held_at);
    if (number >= 0 && out[OFTEN][number] > 0) {
      out[AFTER_SO_MANY][number] = s[s_at + age + 9];
    }
  }
}
export function count_following(held, here, out, held_at = 0) {
  for (let age = 0, end_1 = $places.MOVEMENTS - 1; age < end_1; age++) {
    const after = $places.visited(held, age, held_at);
    const before = $places.visited(held, age + 1, held_at);
    if (before === here && after >= 0 && out[OFTEN][after] > 0) {
      out[FROM_HERE][after] += Math.exp(-age / AGE);
    }
  }
}
export function shares(s, held, key, start, out, s_at = 0, held_at = 0) {
  if (count_often(held, key, out, held_at) === 0) {
    return false;
  }
  const count = Math.trunc(held[held_at]);
  count_last(s, held, out, s_at, held_at);
  blend(out, LATELY, OFTEN, count, LATE_ELSE);
  blend(out, AFTER_SO_MANY, OFTEN, count, OFTEN_OF);
  const x = start[0];
  const y = start[1];
  const near = start[2];
  const here = $places.nearest(held, key, [x, y], near, held_at);
  if (here >= 0) {
    count_following(held, here, out, held_at);
  }
  blend(out, FROM_HERE, OFTEN, count, OFTEN_OF);
  return true;
}
export function rule_weight(s, rule, with_sequence, s_at = 0) {
  const most = with_sequence === 1 ? RULES : AFTER_SO_MANY;
  if (rule >= most) {
    return 0;
  }
  let total = 0;
  const first = FIRST_RULES_OF / (FIRST_RULES[0] + FIRST_RULES[1] + FIRST_RULES[2] + FIRST_RULES[3]);
  for (let k = 0; k < most; k++) {
    total += s[s_at + k + 2] + first * FIRST_RULES[k];
  }
  return (s[s_at + rule + 2] + first * FIRST_RULES[rule]) / total;
}
export function returns(s, s_at = 0) {
  return (s[s_at] + RETURNS * RETURNS_OF) / (s[s_at] + s[s_at + 1] + RETURNS_OF);
}
export function width_weight(s, width, s_at = 0) {
  let total = WIDTHS_OF;
  for (let k = 0, end_1 = WIDTHS.length; k < end_1; k++) {
    total += s[s_at + k + 6];
  }
  return (s[s_at + width + 6] + WIDTHS_OF / WIDTHS.length) / total;
}
export function usual_width(s, s_at = 0) {
  let log_width = 0;
  for (let k = 0, end_1 = WIDTHS.length; k < end_1; k++) {
    log_width += width_weight(s, k, s_at) * Math.log(WIDTHS[k]);
  }
  return Math.exp(log_width);
}
export function share_visit(s, likely, with_sequence, elsewhere, s_at = 0) {
  const known = returns(s, s_at);
  const new_ = (1 - known) * elsewhere;
  let total = new_;
  for (let rule = 0; rule < RULES; rule++) {
    for (let width = 0, end_1 = WIDTHS.length; width < end_1; width++) {
      const prior = known * rule_weight(s, rule, with_sequence, s_at) * width_weight(s, width, s_at);
      likely[rule][width] *= prior;
      total += likely[rule][width];
    }
  }
  s[s_at + 1] = KEEP * s[s_at + 1] + new_ / total;
  s[s_at] = KEEP * s[s_at] + (1 - new_ / total);
  for (let rule = 0; rule < RULES; rule++) {
    s[s_at + rule + 2] *= KEEP;
  }
  for (let width = 0, end_2 = WIDTHS.length; width < end_2; width++) {
    s[s_at + width + 6] *= KEEP;
  }
  for (let rule = 0; rule < RULES; rule++) {
    for (let width = 0, end_3 = WIDTHS.length; width < end_3; width++) {
      s[s_at + rule + 2] += likely[rule][width] / total;
      s[s_at + width + 6] += likely[rule][width] / total;
    }
  }
}
export function density_ratio(far2, distance2, width) {
  if (distance2 === 0) {
    return 0;
  }
  const width2 = width * width;
  return Math.exp(larger(-0.5 * far2 / distance2 / width2, LEAST_LOG)) * $distances.UNKNOWN_LOGS / width2;
}
export function learn(s, held, scene, movement, elsewhere, s_at = 0, held_at = 0) {
  const key = scene[0];
  const with_sequence = scene[1];
  const near = scene[2];
  const x0 = movement[0];
  const y0 = movement[1];
  const x = movement[2];
  const y = movement[3];
  const out = matrix(RULES, $places.CAPACITY);
  if (!shares(s, held, key, [x0, y0, near], out, s_at, held_at)) {
    return;
  }
  const likely = matrix(RULES, WIDTHS.length);
  for (let i = 0, end_1 = Math.trunc(held[held_at]); i < end_1; i++) {
    const px = held[held_at + i * 4 + 3];
    const py = held[held_at + i * 4 + 4];
    const distance2 = square(px - x0) + square(py - y0);
    const far2 = square(px - x) + square(py - y);
    for (let width = 0, end_2 = WIDTHS.length; width < end_2; width++) {
      const ratio = density_ratio(far2, distance2, WIDTHS[width]);
      for (let rule = 0; rule < RULES; rule++) {
        likely[rule][width] += out[rule][i] * ratio;
      }
    }
  }
  share_visit(s, likely, with_sequence, elsewhere, s_at);
  const number = $places.nearest(held, key, [x, y], $places.NEAR_SHARE * hypot(x - x0, y - y0), held_at);
  for (let age = 0; age < LAGS; age++) {
    if (number >= 0 && $places.visited(held, age, held_at) === number) {
      for (let k = 0; k < LAGS; k++) {
        s[s_at + k + 9] *= LAG_KEEP;
      }
      s[s_at + age + 9] += 1;
      return;
    }
  }
}
