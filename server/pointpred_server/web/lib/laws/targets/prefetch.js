// Written by `make laws` from prefetch.py: change that and run it again.
import { hypot, larger, smaller } from "../arithmetic.js";
import * as $cursor from "./cursor.js";
import * as $decision from "./decision.js";
import * as $rectangles from "./rectangles.js";
export const ARMED = 0;
export const FIRED = 1;
export const RESTING = 2;
export const PREDICTED = 3;
export const ENTERED = 4;
export const STATES = 16;
export const PATHS = 8;
export const NEGLIGIBLE = 0.001;
export const LEAST_WAY_PX = 3;
export const REFERENCE_S = 0.25;
export const SHORTEST_S = 0.005;
export const LONGEST_S = 5;
export const SMALLEST = 1e-06;
export const LEAST_VISITS = 0.05;
export const ROUNDING = 1e-06;
export const THRESHOLD = 0.5;
export const FITTED = [1.445, 0.84, 0.375, 0.148, 0.666, 2.595];
export function contact(x, y, dx, dy, row) {
  let enters = 0;
  let leaves = Infinity;
  for (let axis = 0; axis < 2; axis++) {
    const step = axis === 0 ? dx : dy;
    const off = axis === 0 ? row[$rectangles.CENTRE_X] - x : row[$rectangles.CENTRE_Y] - y;
    const half = 0.5 * (axis === 0 ? row[$rectangles.WIDTH] : row[$rectangles.HEIGHT]);
    if (step === 0) {
      if (Math.abs(off) > half) {
        return Infinity;
      }
    } else {
      const near = (off - half) / step;
      const far = (off + half) / step;
      enters = larger(enters, smaller(near, far));
      leaves = smaller(leaves, larger(near, far));
    }
  }
  return enters <= leaves ? enters : Infinity;
}
export function inside(x, y, row) {
  return Math.abs(row[$rectangles.CENTRE_X] - x) <= 0.5 * row[$rectangles.WIDTH] && Math.abs(row[$rectangles.CENTRE_Y] - y) <= 0.5 * row[$rectangles.HEIGHT];
}
export function visit(x, y, table, shares, out) {
  const ends = new Float64Array(PATHS);
  $decision.rank(shares, table.length, ends);
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    out[i] = shares[i];
  }
  for (let place = 0; place < PATHS; place++) {
    const end = Math.trunc(ends[place]);
    if (end === $rectangles.NOBODY || shares[end] < NEGLIGIBLE) {
      continue;
    }
    const to_x = table[end][$rectangles.CENTRE_X] - x;
    const to_y = table[end][$rectangles.CENTRE_Y] - y;
    const middle_x = x + 0.5 * to_x;
    const middle_y = y + 0.5 * to_y;
    const across = 0.5 * Math.abs(to_x) + ROUNDING;
    const down = 0.5 * Math.abs(to_y) + ROUNDING;
    for (let i = 0, end_2 = table.length; i < end_2; i++) {
      const far_x = Math.abs(table[i][$rectangles.CENTRE_X] - middle_x);
      const far_y = Math.abs(table[i][$rectangles.CENTRE_Y] - middle_y);
      if (far_x > across + 0.5 * table[i][$rectangles.WIDTH] || far_y > down + 0.5 * table[i][$rectangles.HEIGHT]) {
        continue;
      }
      if (i !== end && contact(x, y, to_x, to_y, table[i]) <= 1) {
        out[i] += shares[end];
      }
    }
  }
}
export function begin(s, table, fired, s_at = 0) {
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (fired[i] === PREDICTED || fired[i] === ENTERED) {
      fired[i] = FIRED;
    }
  }
  if (s[s_at + 15] === s[s_at + 5]) {
    return;
  }
  s[s_at + 15] = s[s_at + 5];
  for (let i = 0, end_2 = table.length; i < end_2; i++) {
    if (fired[i] !== ARMED) {
      fired[i] = inside(s[s_at + 6], s[s_at + 7], table[i]) ? RESTING : ARMED;
    }
  }
}
export function log_odds(p) {
  p = smaller(larger(p, SMALLEST), 1 - SMALLEST);
  return Math.log(p / (1 - p));
}
export function terms(s, row, share, visited, expected, s_at = 0) {
  const left_s = $cursor.until(s, row[$rectangles.CENTRE_X], row[$rectangles.CENTRE_Y], row[$rectangles.WIDTH], row[$rectangles.HEIGHT], s_at);
  const near = -Math.log(smaller(larger(left_s, SHORTEST_S), LONGEST_S) / REFERENCE_S);
  const end = Math.log(larger(share, SMALLEST) / larger(visited, SMALLEST));
  return [1, end, near, -near * near, Math.log(larger(expected[0], LEAST_VISITS)), -expected[1]];
}
export function score(s, row, share, visited, expected, settings, s_at = 0, settings_at = 0) {
  const values_1 = terms(s, row, share, visited, expected, s_at);
  const t0 = values_1[0];
  const t1 = values_1[1];
  const t2 = values_1[2];
  const t3 = values_1[3];
  const t4 = values_1[4];
  const t5 = values_1[5];
  let total = log_odds(visited) + settings[settings_at] * t0 + settings[settings_at + 1] * t1 + settings[settings_at + 2] * t2;
  total += settings[settings_at + 3] * t3 + settings[settings_at + 4] * t4 + settings[settings_at + 5] * t5;
  return total;
}
export function least_visit(lowest, expected, settings, settings_at = 0) {
  const soon = Math.log(REFERENCE_S / SHORTEST_S);
  const late = Math.log(LONGEST_S / REFERENCE_S);
  let most = larger(settings[settings_at + 2] * soon, -settings[settings_at + 2] * late) + larger(-settings[settings_at + 3], 0) * soon * soon;
  most += larger(settings[settings_at + 1] * Math.log(SMALLEST), 0) + settings[settings_at] + ROUNDING;
  most += settings[settings_at + 4] * Math.log(larger(expected[0], LEAST_VISITS)) - settings[settings_at + 5] * expected[1];
  return 1 / (1 + Math.exp(most - log_odds(lowest)));
}
export function expect(x, y, table, visits, shares) {
  let passed = 0;
  let sure = 0;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (!inside(x, y, table[i])) {
      passed = passed + visits[i];
      sure = larger(sure, shares[i]);
    }
  }
  return [passed, sure];
}
export function step(s, targets, shares, settings, s_at = 0, settings_at = 0) {
  const table = targets[0];
  const thresholds = targets[1];
  const visits = targets[2];
  const fired = targets[3];
  begin(s, table, fired, s_at);
  const x = s[s_at + 2];
  const y = s[s_at + 3];
  visit(x, y, table, shares, visits);
  const expected = expect(x, y, table, visits, shares);
  const moves = hypot(x - s[s_at + 6], y - s[s_at + 7]) >= LEAST_WAY_PX;
  let lowest = 1;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    lowest = smaller(lowest, thresholds[i]);
  }
  const least = least_visit(lowest, expected, settings, settings_at);
  let count = 0;
  for (let i = 0, end_2 = table.length; i < end_2; i++) {
    if (table[i][$rectangles.LOG_WEIGHT] === -Infinity) {
      continue;
    }
    if (inside(x, y, table[i])) {
      if (fired[i] === ARMED) {
        fired[i] = ENTERED;
        count = count + 1;
      }
      continue;
    }
    if (fired[i] === RESTING) {
      fired[i] = ARMED;
    }
    if (fired[i] !== ARMED || !moves) {
      continue;
    }
    if (least > SMALLEST && visits[i] < least) {
      continue;
    }
    const reached = score(s, table[i], shares[i], visits[i], expected, settings, s_at, settings_at);
    if (reached >= log_odds(thresholds[i])) {
      fired[i] = PREDICTED;
      count = count + 1;
    }
  }
  return count;
}
