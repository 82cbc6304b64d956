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
export const KEY = 0;
export const X = 1;
export const Y = 2;
export const WEIGHT = 3;
export const WIDTH = 4;
export const COUNT = 0;
export const ENDED = 1;
export const PLACES = 2;
export const HISTORY = 258;
export const FINE = 0;
export const TOO_LIGHT = 41;
export const NO_SUCH_PLACE = 42;
export function fault(learned) {
  const count = Math.trunc(learned[COUNT]);
  for (let i = 0; i < count; i++) {
    if (!(learned[PLACES + WIDTH * i + WEIGHT] >= LIGHTEST)) {
      return [TOO_LIGHT, learned[PLACES + WIDTH * i + WEIGHT]];
    }
  }
  for (let age = 0, end_1 = Math.trunc(smaller(learned[ENDED], MOVEMENTS)); age < end_1; age++) {
    if (learned[HISTORY + age] >= count) {
      return [NO_SUCH_PLACE, learned[HISTORY + age]];
    }
  }
  return [FINE, 0];
}
export function nearest(memory, at, key, point, near) {
  const x = point[0];
  const y = point[1];
  let best = -1;
  let closest = near;
  for (let i = 0, end_1 = Math.trunc(memory[at + COUNT]); i < end_1; i++) {
    const place = at + PLACES + WIDTH * i;
    const away = hypot(memory[place + X] - x, memory[place + Y] - y);
    if (memory[place + KEY] === key && away <= closest) {
      best = i;
      closest = away;
    }
  }
  return best;
}
export function visited(memory, at, age) {
  const ended = Math.trunc(memory[at + ENDED]);
  if (age >= smaller(ended, MOVEMENTS)) {
    return -1;
  }
  return Math.trunc(memory[at + HISTORY + remainder(ended - 1 - age, MOVEMENTS)]);
}
export function new_place(memory, at) {
  const count = Math.trunc(memory[at + COUNT]);
  if (count < CAPACITY) {
    memory[at + COUNT] = count + 1;
    return count;
  }
  let free = 0;
  for (let i = 0; i < CAPACITY; i++) {
    if (memory[at + PLACES + WIDTH * i + WEIGHT] < memory[at + PLACES + WIDTH * free + WEIGHT]) {
      free = i;
    }
  }
  for (let age = 0; age < MOVEMENTS; age++) {
    if (memory[at + HISTORY + age] === free) {
      memory[at + HISTORY + age] = NOWHERE;
    }
  }
  return free;
}
export function visit(memory, at, key, end, near) {
  let place;
  const x = end[0];
  const y = end[1];
  for (let i = 0, end_1 = Math.trunc(memory[at + COUNT]); i < end_1; i++) {
    place = at + PLACES + WIDTH * i;
    memory[place + WEIGHT] = larger(KEEP * memory[place + WEIGHT], LIGHTEST);
  }
  let number = nearest(memory, at, key, end, near);
  if (number < 0) {
    number = new_place(memory, at);
    place = at + PLACES + WIDTH * number;
    memory[place + KEY] = key;
    memory[place + WEIGHT] = 0;
    memory[place + X] = x;
    memory[place + Y] = y;
  }
  place = at + PLACES + WIDTH * number;
  memory[place + WEIGHT] += 1;
  const share = larger(1 / memory[place + WEIGHT], STEADIEST);
  memory[place + X] += share * (x - memory[place + X]);
  memory[place + Y] += share * (y - memory[place + Y]);
  memory[at + HISTORY + remainder(Math.trunc(memory[at + ENDED]), MOVEMENTS)] = number;
  memory[at + ENDED] += 1;
  if (memory[at + ENDED] === MOST_ENDED) {
    memory[at + ENDED] -= MOVEMENTS;
  }
}
