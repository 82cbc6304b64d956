// Written by `make laws` from mixed_region.py: change that and run it again.
import { larger, matrix } from "../../arithmetic.js";
import * as $destination from "./destination.js";
import * as $levels from "./levels.js";
import * as $places from "./places.js";
import * as $mixture from "../mixture.js";
export const MOST_PLACES = 4;
export const LEAST = 0.02;
export const LEAST_SPREAD = 0.5;
export const POINTS = 32;
export const COUNT = 0;
export const PARTS = 1;
export const OFFSETS = 36;
export const CLAIMED = 0;
export const TIME = 1;
export const ELSEWHERE = 2;
export const ASKED = 8;
export function likeliest(memory, place_memory, going, below) {
  let best = -1;
  let most = LEAST;
  for (let i = 0, end_1 = Math.trunc(memory[place_memory + $places.COUNT]); i < end_1; i++) {
    const share = memory[going + $destination.NOW + i];
    if (most < share && share < below) {
      best = i;
      most = share;
    }
  }
  return best;
}
export function claim(memory, now, share, elsewhere) {
  memory[now + CLAIMED] = 1;
  memory[now + TIME] = share;
  for (let i = 0, end_1 = elsewhere.length; i < end_1; i++) {
    memory[now + ELSEWHERE + i] = elsewhere[i];
  }
}
export function write_part(memory, part, share, centre, spread) {
  memory[part + $mixture.SHARE] = share;
  memory[part + $mixture.X] = centre[0];
  memory[part + $mixture.Y] = centre[1];
  memory[part + $mixture.SXX] = spread * spread;
  memory[part + $mixture.SXY] = 0;
  memory[part + $mixture.SYY] = spread * spread;
  memory[part + $mixture.TAIL] = 0;
}
export function write(memory, known, now, at, origin, start) {
  const person = known[0];
  const place_memory = known[1];
  const going = known[2];
  let count = 1;
  let rest = 1;
  let below = 2;
  let number = likeliest(memory, place_memory, going, below);
  while (number >= 0 && count <= MOST_PLACES) {
    below = memory[going + $destination.NOW + number];
    const place = place_memory + $places.PLACES + $places.WIDTH * number;
    const x = memory[place + $places.X];
    const y = memory[place + $places.Y];
    const spread = larger($destination.spread_of(memory, going, start, x, y), LEAST_SPREAD);
    const centre = [x + origin[0], y + origin[1]];
    write_part(memory, at + PARTS + $mixture.WIDTH * count, below, centre, spread);
    rest -= below;
    count += 1;
    number = likeliest(memory, place_memory, going, below);
  }
  memory[at + COUNT] = count;
  memory[at + PARTS + $mixture.SHARE] = larger(rest, 0);
  for (let i = 0, end_1 = ASKED - ELSEWHERE; i < end_1; i++) {
    memory[at + PARTS + $mixture.X + i] = memory[now + ELSEWHERE + i];
  }
  for (let which = 0, end_2 = $mixture.LEVELS.length; which < end_2; which++) {
    memory[at + OFFSETS + which] = $levels.offset(memory, person, memory[now + TIME], which);
  }
}
export function judge(memory, person, at, end, share, step) {
  const count = Math.trunc(memory[at + COUNT]);
  const parts = matrix(MOST_PLACES + 1, $mixture.WIDTH);
  for (let k = 0; k < count; k++) {
    for (let i = 0; i < $mixture.WIDTH; i++) {
      parts[k][i] = memory[at + PARTS + $mixture.WIDTH * k + i];
    }
  }
  const within = $mixture.content(parts, count, end[0], end[1], POINTS);
  const tail = parts[0][$mixture.TAIL];
  const near = memory[at + OFFSETS];
  const far = memory[at + OFFSETS + 1];
  for (let which = 0, end_1 = $mixture.LEVELS.length; which < end_1; which++) {
    const inside = within <= $mixture.corrected_probability($mixture.LEVELS[which], tail, near, far);
    $levels.learn(memory, person, share, which, inside, step);
  }
}
