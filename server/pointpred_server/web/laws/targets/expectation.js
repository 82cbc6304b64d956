// Written by `make laws` from expectation.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $rectangles from "./rectangles.js";
export const X = 0;
export const Y = 1;
export const P = 2;
export const BEFORE = 3;
export const SPREAD = 4;
export const NONE = -1;
export const LEAST_PX = 16;
export const LOWEST = /* @__PURE__ */ new Float64Array([-1000000000, -1000000000, 0, 0, 0]);
export const HIGHEST = /* @__PURE__ */ new Float64Array([1000000000, 1000000000, 1.000000001, 1.000000001, 1000000000]);
export function target_of(table, place) {
  let best = NONE;
  let least = Infinity;
  let smallest = Infinity;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    const target = table[i];
    const across = Math.abs(place[X] - target[$rectangles.CENTRE_X]) - 0.5 * target[$rectangles.WIDTH];
    const away = larger(larger(across, Math.abs(place[Y] - target[$rectangles.CENTRE_Y]) - 0.5 * target[$rectangles.HEIGHT]), 0);
    const area = target[$rectangles.WIDTH] * target[$rectangles.HEIGHT];
    const nearer = away < least || away === least && area < smallest;
    if (target[$rectangles.LOG_WEIGHT] > -Infinity && away <= place[SPREAD] && nearer) {
      best = i;
      least = away;
      smallest = area;
    }
  }
  return best;
}
export function expect(table, own, known) {
  const count = table.length;
  const shares = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    table[i][$rectangles.LOG_WEIGHT] = own[i];
  }
  for (let k = 0, end_1 = known.length; k < end_1; k++) {
    const owner = target_of(table, known[k]);
    if (owner !== NONE) {
      shares[owner] += known[k][BEFORE];
    }
  }
  let total = 0;
  for (let i = 0; i < count; i++) {
    table[i][$rectangles.LOG_WEIGHT] += Math.log(1 + count * shares[i]);
    total += Math.exp(table[i][$rectangles.LOG_WEIGHT]);
  }
  if (total === 0) {
    return;
  }
  for (let i = 0; i < count; i++) {
    table[i][$rectangles.LOG_WEIGHT] -= Math.log(total);
  }
}
