// Written by `make laws` from places.py: change that and run it again.
import { hypot, larger, remainder, smaller } from "../../arithmetic.js";
export const CAPACITY = 64;
export const MOVEMENTS = 128;
export const MOST_ENDED = 131072;
export const KEEP = 0.97;
export const LIGHTEST = 1e-09;
export const NOWHERE = -1;
export const NEAR_SHARE = 0.03;
export const STEADIEST = 0.1;
export const FINE = 0;
export const TOO_LIGHT = 41;
export const NO_SUCH_PLACE = 42;
export function fault(learned, learned_at = 0) {
  const count = Math.trunc(learned[learned_at]);
  for (let i = 0; i < count; i++) {
    if (!(learned[learned_at + i * 4 + 5] >= LIGHTEST)) {
      return [TOO_LIGHT, learned[learned_at + i * 4 + 5]];
    }
  }
  for (let age = 0, end_1 = Math.trunc(smaller(learned[learned_at + 1], MOVEMENTS)); age < end_1; age++) {
    if (learned[learned_at + age + 258] >= count) {
      return [NO_SUCH_PLACE, learned[learned_at + age + 258]];
    }
  }
  return [FINE, 0];
}
export function nearest(s, key, point, near, s_at = 0) {
  const x = point[0];
  const y = point[1];
  let best = -1;
  let closest = near;
  for (let i = 0, end_1 = Math.trunc(s[s_at]); i < end_1; i++) {
    const place_at = s_at + i * 4 + 2;
    const away = hypot(s[place_at + 1] - x, s[place_at + 2] - y);
    if (s[place_at] === key && away <= closest) {
      best = i;
      closest = away;
    }
  }
  return best;
}
export function visited(s, age, s_at = 0) {
  const ended = Math.trunc(s[s_at + 1]);
  if (age >= smaller(ended, MOVEMENTS)) {
    return -1;
  }
  return Math.trunc(s[s_at + remainder(ended - 1 - age, MOVEMENTS) + 258]);
}
export function new_place(s, s_at = 0) {
  const count = Math.trunc(s[s_at]);
  if (count < CAPACITY) {
    s[s_at] = count + 1;
    return count;
  }
  let free = 0;
  for (let i = 0; i < CAPACITY; i++) {
    if (s[s_at + i * 4 + 5] < s[s_at + free * 4 + 5]) {
      free = i;
    }
  }
  for (let age = 0; age < MOVEMENTS; age++) {
    if (s[s_at + age + 258] === free) {
      s[s_at + age + 258] = NOWHERE;
    }
  }
  return free;
}
export function visit(s, key, end, near, s_at = 0) {
  const x = end[0];
  const y = end[1];
  for (let i = 0, end_1 = Math.trunc(s[s_at]); i < end_1; i++) {
    s[s_at + i * 4 + 5] = larger(KEEP * s[s_at + i * 4 + 5], LIGHTEST);
  }
  let number = nearest(s, key, end, near, s_at);
  if (number < 0) {
    number = new_place(s, s_at);
    const new_at = s_at + number * 4 + 2;
    s[new_at] = key;
    s[new_at + 3] = 0;
    s[new_at + 1] = x;
    s[new_at + 2] = y;
  }
  const place_at = s_at + number * 4 + 2;
  s[place_at + 3] += 1;
  const share = larger(1 / s[place_at + 3], STEADIEST);
  s[place_at + 1] += share * (x - s[place_at + 1]);
  s[place_at + 2] += share * (y - s[place_at + 2]);
  s[s_at + remainder(Math.trunc(s[s_at + 1]), MOVEMENTS) + 258] = number;
  s[s_at + 1] += 1;
  if (s[s_at + 1] === MOST_ENDED) {
    s[s_at + 1] -= MOVEMENTS;
  }
}
