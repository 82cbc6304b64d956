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
export const KNOWN = 0;
export const NEW = 1;
export const RULE = 2;
export const NARROW = 6;
export const LAG = 9;
export const LEARNED = 25;
export function blend(out, rule, base, count, weight) {
  let total = weight;
  for (let i = 0; i < count; i++) {
    total += out[rule][i];
  }
  for (let i = 0; i < count; i++) {
    out[rule][i] = (out[rule][i] + weight * out[base][i]) / total;
  }
}
export function count_often(memory, at, key, out) {
  const count = Math.trunc(memory[at + $places.COUNT]);
  let total = 0;
  for (let i = 0; i < count; i++) {
    const place = at + $places.PLACES + $places.WIDTH * i;
    if (memory[place + $places.KEY] === key) {
      out[OFTEN][i] = memory[place + $places.WEIGHT];
      total += out[OFTEN][i];
    }
  }
  for (let i = 0; i < count; i++) {
    out[OFTEN][i] = total > 0 ? out[OFTEN][i] / total : 0;
  }
  return total;
}
export function count_last(memory, at, habits, out) {
  let number;
  for (let age = 0; age < $places.MOVEMENTS; age++) {
    number = $places.visited(memory, at, age);
    if (number >= 0 && out[OFTEN][number] > 0) {
      out[LATELY][number] += Math.exp(-age / LATE_AGE);
    }
  }
  for (let age = LAGS - 1, end_1 = -1; age > end_1; age--) {
    number = $places.visited(memory, at, age);
    if (number >= 0 && out[OFTEN][number] > 0) {
      out[AFTER_SO_MANY][number] = memory[habits + LAG + age];
    }
  }
}
export function count_following(memory, at, here, out) {
  for (let age = 0, end_1 = $places.MOVEMENTS - 1; age < end_1; age++) {
    const after = $places.visited(memory, at, age);
    const before = $places.visited(memory, at, age + 1);
    if (before === here && after >= 0 && out[OFTEN][after] > 0) {
      out[FROM_HERE][after] += Math.exp(-age / AGE);
    }
  }
}
export function shares(memory, at, habits, key, start, out) {
  if (count_often(memory, at, key, out) === 0) {
    return false;
  }
  const count = Math.trunc(memory[at + $places.COUNT]);
  count_last(memory, at, habits, out);
  blend(out, LATELY, OFTEN, count, LATE_ELSE);
  blend(out, AFTER_SO_MANY, OFTEN, count, OFTEN_OF);
  const x = start[0];
  const y = start[1];
  const near = start[2];
  const here = $places.nearest(memory, at, key, [x, y], near);
  if (here >= 0) {
    count_following(memory, at, here, out);
  }
  blend(out, FROM_HERE, OFTEN, count, OFTEN_OF);
  return true;
}
export function rule_weight(memory, habits, rule, with_sequence) {
  const most = with_sequence === 1 ? RULES : AFTER_SO_MANY;
  if (rule >= most) {
    return 0;
  }
  let total = 0;
  const first = FIRST_RULES_OF / (FIRST_RULES[0] + FIRST_RULES[1] + FIRST_RULES[2] + FIRST_RULES[3]);
  for (let k = 0; k < most; k++) {
    total += memory[habits + RULE + k] + first * FIRST_RULES[k];
  }
  return (memory[habits + RULE + rule] + first * FIRST_RULES[rule]) / total;
}
export function returns(memory, habits) {
  const known = memory[habits + KNOWN];
  const new_ = memory[habits + NEW];
  return (known + RETURNS * RETURNS_OF) / (known + new_ + RETURNS_OF);
}
export function width_weight(memory, habits, width) {
  let total = WIDTHS_OF;
  for (let k = 0, end_1 = WIDTHS.length; k < end_1; k++) {
    total += memory[habits + NARROW + k];
  }
  return (memory[habits + NARROW + width] + WIDTHS_OF / WIDTHS.length) / total;
}
export function usual_width(memory, habits) {
  let log_width = 0;
  for (let k = 0, end_1 = WIDTHS.length; k < end_1; k++) {
    log_width += width_weight(memory, habits, k) * Math.log(WIDTHS[k]);
  }
  return Math.exp(log_width);
}
export function share_visit(memory, habits, likely, with_sequence, elsewhere) {
  const known = returns(memory, habits);
  const new_ = (1 - known) * elsewhere;
  let total = new_;
  for (let rule = 0; rule < RULES; rule++) {
    for (let width = 0, end_1 = WIDTHS.length; width < end_1; width++) {
      const prior = known * rule_weight(memory, habits, rule, with_sequence) * width_weight(memory, habits, width);
      likely[rule][width] *= prior;
      total += likely[rule][width];
    }
  }
  for (let i = 0, end_2 = LEARNED - LAGS; i < end_2; i++) {
    memory[habits + i] *= KEEP;
  }
  memory[habits + NEW] += new_ / total;
  memory[habits + KNOWN] += 1 - new_ / total;
  for (let rule = 0; rule < RULES; rule++) {
    for (let width = 0, end_3 = WIDTHS.length; width < end_3; width++) {
      memory[habits + RULE + rule] += likely[rule][width] / total;
      memory[habits + NARROW + width] += likely[rule][width] / total;
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
export function learn(memory, at, habits, scene, movement, elsewhere) {
  const key = scene[0];
  const with_sequence = scene[1];
  const near = scene[2];
  const x0 = movement[0];
  const y0 = movement[1];
  const x = movement[2];
  const y = movement[3];
  const out = matrix(RULES, $places.CAPACITY);
  if (!shares(memory, at, habits, key, [x0, y0, near], out)) {
    return;
  }
  const likely = matrix(RULES, WIDTHS.length);
  for (let i = 0, end_1 = Math.trunc(memory[at + $places.COUNT]); i < end_1; i++) {
    const place = at + $places.PLACES + $places.WIDTH * i;
    const px = memory[place + $places.X];
    const py = memory[place + $places.Y];
    const distance2 = square(px - x0) + square(py - y0);
    const far2 = square(px - x) + square(py - y);
    for (let width = 0, end_2 = WIDTHS.length; width < end_2; width++) {
      const ratio = density_ratio(far2, distance2, WIDTHS[width]);
      for (let rule = 0; rule < RULES; rule++) {
        likely[rule][width] += out[rule][i] * ratio;
      }
    }
  }
  share_visit(memory, habits, likely, with_sequence, elsewhere);
  const number = $places.nearest(memory, at, key, [x, y], $places.NEAR_SHARE * hypot(x - x0, y - y0));
  for (let age = 0; age < LAGS; age++) {
    if (number >= 0 && $places.visited(memory, at, age) === number) {
      for (let k = 0; k < LAGS; k++) {
        memory[habits + LAG + k] *= LAG_KEEP;
      }
      memory[habits + LAG + age] += 1;
      return;
    }
  }
}
