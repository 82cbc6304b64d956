// Written by `make laws` from choice_law.py: change that and run it again.
import * as $decision from "./decision.js";
import * as $rectangles from "./rectangles.js";
export const KEEP = 0.4;
export const OUTSIDE = 0;
export const INSIDE = 1;
export const ENTERED = 2;
export const RELEASED = 3;
export function innermost(table, inside) {
  let best = $rectangles.NOBODY;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (inside[i] === OUTSIDE || inside[i] === RELEASED || table[i][$rectangles.LOG_WEIGHT] === -Infinity) {
      continue;
    }
    const area = table[i][$rectangles.WIDTH] * table[i][$rectangles.HEIGHT];
    if (best === $rectangles.NOBODY || area <= table[best][$rectangles.WIDTH] * table[best][$rectangles.HEIGHT]) {
      best = i;
    }
  }
  return best;
}
export function enter(table, inside, x, y, released) {
  let count = 0;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    const row = table[i];
    if (Math.abs(row[$rectangles.CENTRE_X] - x) <= 0.5 * row[$rectangles.WIDTH] && Math.abs(row[$rectangles.CENTRE_Y] - y) <= 0.5 * row[$rectangles.HEIGHT]) {
      if (inside[i] === OUTSIDE) {
        inside[i] = ENTERED;
        count += 1;
      } else {
        inside[i] = released || inside[i] === RELEASED ? RELEASED : INSIDE;
      }
    } else {
      inside[i] = OUTSIDE;
    }
  }
  return count;
}
export function decide(s, released, remaining_s, targets, settings, standing, s_at = 0) {
  const table = targets[0];
  const inside = targets[1];
  const shares = targets[2];
  if (released) {
    standing = $rectangles.NOBODY;
  }
  const count = enter(table, inside, s[s_at + 2], s[s_at + 3], released);
  const ask = settings[0];
  const least_s = settings[1];
  const bounds = [ask, KEEP * ask, least_s, settings[2]];
  const chosen = $decision.decide(s, table, shares, standing, remaining_s, bounds, s_at);
  const over = innermost(table, inside);
  return [chosen, over === chosen ? $rectangles.NOBODY : over, count];
}
export function changes(before, now) {
  const predicted = before[0];
  const entered = before[1];
  const chosen = now[0];
  const over = now[1];
  let ends = predicted;
  let leaves = entered;
  let begins = chosen;
  let enters = over;
  if (predicted === chosen) {
    ends = begins = $rectangles.NOBODY;
  }
  if (entered === over) {
    leaves = enters = $rectangles.NOBODY;
  }
  if (predicted === over) {
    ends = enters = $rectangles.NOBODY;
  }
  if (entered === chosen) {
    leaves = begins = $rectangles.NOBODY;
  }
  return [ends, leaves, begins, enters];
}
