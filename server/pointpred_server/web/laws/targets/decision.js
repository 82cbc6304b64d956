// Written by `make laws` from decision.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $cursor from "./cursor.js";
import * as $rectangles from "./rectangles.js";
export const NOBODY = -1;
export function likeliest(shares, count) {
  let best = NOBODY;
  for (let i = 0; i < count; i++) {
    if (best === NOBODY || shares[i] > shares[best]) {
      best = i;
    }
  }
  return best;
}
export function rank(shares, count, order) {
  for (let k = 0, end_1 = order.length; k < end_1; k++) {
    order[k] = NOBODY;
  }
  for (let i = 0; i < count; i++) {
    let place = order.length;
    while (place > 0 && (order[place - 1] === NOBODY || shares[i] > shares[Math.trunc(order[place - 1])])) {
      place -= 1;
    }
    if (place < order.length) {
      for (let later = order.length - 1, end_2 = place; later > end_2; later--) {
        order[later] = order[later - 1];
      }
      order[place] = i;
    }
  }
}
export function early(memory, row, remaining_s, least_s) {
  let left = $cursor.until(memory, row[$rectangles.CENTRE_X], row[$rectangles.CENTRE_Y], row[$rectangles.WIDTH], row[$rectangles.HEIGHT]);
  if (left === 0) {
    return false;
  }
  if (remaining_s === remaining_s) {
    left = larger(left, remaining_s);
  }
  return left >= least_s;
}
export function decide(memory, table, shares, standing, remaining_s, bounds) {
  const ask = bounds[0];
  const keep = bounds[1];
  const least_s = bounds[2];
  const least_px = bounds[3];
  const best = likeliest(shares, table.length);
  if (best === NOBODY) {
    return NOBODY;
  }
  if (standing !== NOBODY && (best === standing || shares[best] < ask)) {
    return shares[standing] >= keep ? standing : NOBODY;
  }
  const far = hypot(memory[$cursor.X] - memory[$cursor.X0], memory[$cursor.Y] - memory[$cursor.Y0]);
  if (shares[best] >= ask && far >= least_px && early(memory, table[best], remaining_s, least_s)) {
    return best;
  }
  if (standing !== NOBODY && shares[standing] >= keep) {
    return standing;
  }
  return NOBODY;
}
