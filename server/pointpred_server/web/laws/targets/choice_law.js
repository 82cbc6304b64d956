// Written by `make laws` from choice_law.py: change that and run it again.
import * as $cursor from "./cursor.js";
import * as $decision from "./decision.js";
import * as $posterior from "./posterior.js";
import * as $rectangles from "./rectangles.js";
export const KEEP = 0.4;
export const OUTSIDE = 0;
export const INSIDE = 1;
export const ENTERED = 2;
export const RELEASED = 3;
export function innermost(table, inside) {
  let best = $decision.NOBODY;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (inside[i] === OUTSIDE || inside[i] === RELEASED || table[i][$rectangles.LOG_WEIGHT] === -Infinity) {
      continue;
    }
    const area = table[i][$rectangles.WIDTH] * table[i][$rectangles.HEIGHT];
    if (best === $decision.NOBODY || area <= table[best][$rectangles.WIDTH] * table[best][$rectangles.HEIGHT]) {
      best = i;
    }
  }
  return best;
}
export function holder(table, x, y) {
  let best = $decision.NOBODY;
  let smallest = Infinity;
  let least = Infinity;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    const row = table[i];
    const across = Math.abs(row[$rectangles.CENTRE_X] - x);
    const down = Math.abs(row[$rectangles.CENTRE_Y] - y);
    if (across <= 0.5 * row[$rectangles.WIDTH] && down <= 0.5 * row[$rectangles.HEIGHT]) {
      const area = row[$rectangles.WIDTH] * row[$rectangles.HEIGHT];
      const away = across + down;
      if (area < smallest || area === smallest && away < least) {
        best = i;
        smallest = area;
        least = away;
      }
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
export function propose(s, event, released, remaining_s, targets, settings, standing, s_at = 0) {
  const x = event[1];
  const y = event[2];
  const table = targets[0];
  const inside = targets[1];
  const shares = targets[2];
  if (released) {
    standing = $decision.NOBODY;
  }
  const count = enter(table, inside, x, y, released);
  const ask = settings[0];
  const least_s = settings[2];
  const bounds = [ask, KEEP * ask, least_s, settings[3]];
  const chosen = $decision.decide(s, table, shares, standing, remaining_s, bounds, s_at);
  const over = innermost(table, inside);
  return [chosen, over === chosen ? $decision.NOBODY : over, count];
}
export function step_with_shares(s, event, remaining_s, targets, settings, standing, s_at = 0) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const pressed = event[3];
  const released = $cursor.follow(s, t, x, y, pressed, s_at);
  return propose(s, event, released, remaining_s, targets, settings, standing, s_at);
}
export function step(s, event, answer, targets, coefficients, settings, standing, s_at = 0, coefficients_at = 0) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const pressed = event[3];
  const table = targets[0];
  const shares = targets[2];
  const p = answer;
  const released = $cursor.follow(s, t, x, y, pressed, s_at);
  $posterior.scores(s, table, answer, coefficients, settings[1], shares, s_at, coefficients_at);
  $posterior.normalise(shares);
  return propose(s, event, released, p[6], targets, settings, standing, s_at);
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
    ends = begins = $decision.NOBODY;
  }
  if (entered === over) {
    leaves = enters = $decision.NOBODY;
  }
  if (predicted === over) {
    ends = enters = $decision.NOBODY;
  }
  if (entered === chosen) {
    leaves = begins = $decision.NOBODY;
  }
  return [ends, leaves, begins, enters];
}
