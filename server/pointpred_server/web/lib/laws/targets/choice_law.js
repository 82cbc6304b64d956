// Written by `make laws` from choice_law.py: change that and run it again.
import { larger, remainder } from "../arithmetic.js";
import * as $decision from "./decision.js";
import * as $ledger from "./ledger.js";
import * as $past from "./past.js";
import * as $posterior from "./posterior.js";
import * as $rectangles from "./rectangles.js";
export const KEEP = 0.4;
export const OUTSIDE = 0;
export const INSIDE = 1;
export const ENTERED = 2;
export const RELEASED = 3;
export const LEAST_PX = 16;
export const STATES = 2;
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
export function update(s, memory, targets, keys, settings, account, rows, out, s_at = 0, memory_at = 0, account_at = 0) {
  const inside = targets[1];
  const now_at = memory_at + 200;
  const released = memory[memory_at + 217] === 1;
  const before = [Math.trunc(s[s_at]), Math.trunc(s[s_at + 1])];
  const left_s = memory[memory_at + 218];
  const values_1 = decide(memory, released, left_s, targets, settings, before[0], now_at);
  const chosen = values_1[0];
  const over = values_1[1];
  const count = values_1[2];
  if (before[0] === chosen && before[1] === over && count === 0) {
    return false;
  }
  for (let i = 0, end_2 = inside.length; i < end_2; i++) {
    if (inside[i] === ENTERED) {
      $ledger.note_entry(account, rows, memory[now_at + 1], keys[i][$past.ID], account_at);
    }
  }
  if (before[0] !== chosen && before[0] !== $rectangles.NOBODY) {
    $ledger.note_end(account, rows, memory[now_at + 1], keys[before[0]][$past.ID], released, account_at);
  }
  if (before[0] !== chosen && chosen !== $rectangles.NOBODY) {
    $ledger.note_proposal(account, rows, memory[now_at + 1], keys[chosen][$past.ID], account_at);
  }
  if (before[1] !== over && over !== $rectangles.NOBODY) {
    account[account_at + 14] += 1;
  }
  s[s_at] = chosen;
  s[s_at + 1] = over;
  const values_3 = changes(before, [chosen, over]);
  out[0] = values_3[0];
  out[1] = values_3[1];
  out[2] = values_3[2];
  out[3] = values_3[3];
  return true;
}
export function place_of(keys, key, first) {
  for (let k = 0, end_1 = keys.length; k < end_1; k++) {
    const i = remainder(first + k, keys.length);
    if (keys[i][$past.ID] === key) {
      return i;
    }
  }
  return $rectangles.NOBODY;
}
export function replace(s, t, before, now, account, rows, s_at = 0, account_at = 0) {
  const keys = before[0];
  const inside = before[1];
  const new_keys = now[0];
  const new_inside = now[1];
  let near = 0;
  for (let i = 0, end_1 = new_keys.length; i < end_1; i++) {
    const place = place_of(keys, new_keys[i][$past.ID], near);
    new_inside[i] = OUTSIDE;
    if (place !== $rectangles.NOBODY) {
      new_inside[i] = inside[place] === ENTERED ? INSIDE : inside[place];
      near = place + 1;
    }
  }
  const predicted = Math.trunc(s[s_at]);
  const entered = Math.trunc(s[s_at + 1]);
  if (predicted !== $rectangles.NOBODY) {
    s[s_at] = place_of(new_keys, keys[predicted][$past.ID], predicted);
    if (s[s_at] === $rectangles.NOBODY) {
      $ledger.note_end(account, rows, t, keys[predicted][$past.ID], false, account_at);
    }
  }
  if (entered !== $rectangles.NOBODY) {
    s[s_at + 1] = place_of(new_keys, keys[entered][$past.ID], entered);
  }
  return [predicted !== $rectangles.NOBODY && s[s_at] === $rectangles.NOBODY, entered !== $rectangles.NOBODY && s[s_at + 1] === $rectangles.NOBODY];
}
export function reset(s, inside, s_at = 0) {
  s[s_at] = s[s_at + 1] = $rectangles.NOBODY;
  for (let i = 0, end_1 = inside.length; i < end_1; i++) {
    if (inside[i] !== OUTSIDE) {
      inside[i] = RELEASED;
    }
  }
}
export function lay_places(places, table, keys, shares) {
  let known = 0;
  for (let i = 0, end_1 = places.length; i < end_1; i++) {
    table[i][$rectangles.CENTRE_X] = places[i][0];
    table[i][$rectangles.CENTRE_Y] = places[i][1];
    table[i][$rectangles.LOG_WEIGHT] = 0;
    shares[i] = places[i][2];
    keys[i][$past.ID] = places[i][3];
    table[i][$rectangles.WIDTH] = table[i][$rectangles.HEIGHT] = larger($posterior.EFFECTIVE * places[i][4], LEAST_PX);
    known += places[i][2];
  }
  shares[places.length] = larger(1 - known, 0);
}
