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
export const BEGAN = 15;
export const COUNT = 16;
export const STATES = 17;
export const PATHS = 8;
export const NEGLIGIBLE = 0.001;
export const LEAST_WAY_PX = 3;
export const REFERENCE_S = 0.25;
export const SHORTEST_S = 0.005;
export const LONGEST_S = 5;
export const AGE_S = 1;
export const SMALLEST = 1e-06;
export const LEAST_VISITS = 0.05;
export const THRESHOLD = 0.5;
export const ELSEWHERE = 0.02;
export const BASE = 0;
export const END = 1;
export const SPENT = 2;
export const NEAR = 3;
export const FAR = 4;
export const AGE = 5;
export const PASSED = 6;
export const SURE = 7;
export const LATE_S = 8;
export const LATE = 9;
export const FITTED = [1.72, 0.665, 0.0555, 0.336, 0.227, 0.26, 0.687, 3.18, 0.103, 0.477];
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
    let total = shares[i];
    for (let place = 0; place < PATHS; place++) {
      const end = Math.trunc(ends[place]);
      if (end === $decision.NOBODY || end === i || shares[end] < NEGLIGIBLE) {
        continue;
      }
      const to_x = table[end][$rectangles.CENTRE_X] - x;
      const to_y = table[end][$rectangles.CENTRE_Y] - y;
      if (contact(x, y, to_x, to_y, table[i]) <= 1) {
        total += shares[end];
      }
    }
    out[i] = total;
  }
}
export function begin(memory, table, fired) {
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (fired[i] === PREDICTED || fired[i] === ENTERED) {
      fired[i] = FIRED;
    }
  }
  if (memory[BEGAN] === memory[$cursor.T0]) {
    return;
  }
  memory[BEGAN] = memory[$cursor.T0];
  memory[COUNT] = 0;
  for (let i = 0, end_2 = table.length; i < end_2; i++) {
    if (fired[i] !== ARMED) {
      fired[i] = inside(memory[$cursor.X0], memory[$cursor.Y0], table[i]) ? RESTING : ARMED;
    }
  }
}
export function urgency(memory, row, settings) {
  const left_s = $cursor.until(memory, row[$rectangles.CENTRE_X], row[$rectangles.CENTRE_Y], row[$rectangles.WIDTH], row[$rectangles.HEIGHT]);
  const near = -Math.log(smaller(larger(left_s, SHORTEST_S), LONGEST_S) / REFERENCE_S);
  return settings[NEAR] * near - settings[FAR] * near * near;
}
export function log_odds(p) {
  p = smaller(larger(p, SMALLEST), 1 - SMALLEST);
  return Math.log(p / (1 - p));
}
export function step(memory, targets, shares, settings) {
  const table = targets[0];
  const thresholds = targets[1];
  const visits = targets[2];
  const fired = targets[3];
  begin(memory, table, fired);
  const x = memory[$cursor.X];
  const y = memory[$cursor.Y];
  visit(x, y, table, shares, visits);
  let passed = 0;
  let sure = 0;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (!inside(x, y, table[i])) {
      passed = passed + visits[i];
      sure = larger(sure, shares[i]);
    }
  }
  let common = settings[BASE] + settings[PASSED] * Math.log(larger(passed, LEAST_VISITS)) - settings[SURE] * sure;
  common += settings[AGE] * smaller(memory[$cursor.T] - memory[$cursor.T0], AGE_S);
  const moves = hypot(x - memory[$cursor.X0], y - memory[$cursor.Y0]) >= LEAST_WAY_PX;
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
    const likely = larger(visits[i], SMALLEST);
    let score = common + log_odds(likely) + settings[END] * Math.log(larger(shares[i], SMALLEST) / likely);
    score += urgency(memory, table[i], settings) - settings[SPENT] * (memory[COUNT] + count);
    const line_s = contact(x, y, memory[$cursor.VX], memory[$cursor.VY], table[i]);
    const late = line_s <= settings[LATE_S] && likely >= larger(settings[LATE], thresholds[i]);
    if (late || score >= log_odds(thresholds[i])) {
      fired[i] = PREDICTED;
      count = count + 1;
    }
  }
  memory[COUNT] += count;
  return count;
}
