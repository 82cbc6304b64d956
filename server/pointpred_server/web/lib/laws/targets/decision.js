// Written by `make laws` from decision.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $cursor from "./cursor.js";
import * as $rectangles from "./rectangles.js";
export const LOWEST = [0.01, 0, 0];
export const HIGHEST = [0.999, 10, 1000];
export const USUAL = [0.5, 0, 3];
export function likeliest(shares, count) {
  let best = $rectangles.NOBODY;
  for (let i = 0; i < count; i++) {
    if (best === $rectangles.NOBODY || shares[i] > shares[best]) {
      best = i;
    }
  }
  return best;
}
export function rank(shares, count, order) {
  for (let k = 0, end_1 = order.length; k < end_1; k++) {
    order[k] = $rectangles.NOBODY;
  }
  for (let i = 0; i < count; i++) {
    let place = order.length;
    while (place > 0 && (order[place - 1] === $rectangles.NOBODY || shares[i] > shares[Math.trunc(order[place - 1])])) {
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
export function early(s, row, remaining_s, least_s, s_at = 0) {
  let left = $cursor.until(s, row[$rectangles.CENTRE_X], row[$rectangles.CENTRE_Y], row[$rectangles.WIDTH], row[$rectangles.HEIGHT], s_at);
  if (left === 0) {
    return false;
  }
  if (remaining_s === remaining_s) {
    left = larger(left, remaining_s);
  }
  return left >= least_s;
}
export function decide(s, table, shares, standing, remaining_s, bounds, s_at = 0) {
  const ask = bounds[0];
  const keep = bounds[1];
  const least_s = bounds[2];
  const least_px = bounds[3];
  const best = likeliest(shares, table.length);
  if (best === $rectangles.NOBODY) {
    return $rectangles.NOBODY;
  }
  if (standing !== $rectangles.NOBODY && (best === standing || shares[best] < ask)) {
    return shares[standing] >= keep ? standing : $rectangles.NOBODY;
  }
  const far = hypot(s[s_at + 2] - s[s_at + 6], s[s_at + 3] - s[s_at + 7]);
  if (shares[best] >= ask && far >= least_px && early(s, table[best], remaining_s, least_s, s_at)) {
    return best;
  }
  if (standing !== $rectangles.NOBODY && shares[standing] >= keep) {
    return standing;
  }
  return $rectangles.NOBODY;
}
