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
export function write_part(part, share, centre, spread, part_at = 0) {
  part[part_at] = share;
  part[part_at + 1] = centre[0];
  part[part_at + 2] = centre[1];
  part[part_at + 3] = spread * spread;
  part[part_at + 4] = 0;
  part[part_at + 5] = spread * spread;
  part[part_at + 6] = 0;
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
    write_part(memory, below, centre, spread, at + PARTS + 7 * count);
    rest -= below;
    count += 1;
    number = likeliest(memory, place_memory, going, below);
  }
  const elsewhere_at = at + PARTS;
  memory[at + COUNT] = count;
  memory[elsewhere_at] = larger(rest, 0);
  for (let i = 0, end_1 = ASKED - ELSEWHERE; i < end_1; i++) {
    memory[elsewhere_at + i + 1] = memory[now + ELSEWHERE + i];
  }
  for (let which = 0, end_2 = $mixture.LEVELS.length; which < end_2; which++) {
    memory[at + OFFSETS + which] = $levels.offset(memory, person, memory[now + TIME], which);
  }
}
export function judge(memory, person, at, end, share, step) {
  const count = Math.trunc(memory[at + COUNT]);
  const parts = matrix(MOST_PLACES + 1, 7);
  for (let k = 0; k < count; k++) {
    for (let i = 0; i < 7; i++) {
      parts[k][i] = memory[at + PARTS + 7 * k + i];
    }
  }
  const within = $mixture.content(parts, count, end[0], end[1], POINTS);
  const tail = parts[0][6];
  const near = memory[at + OFFSETS];
  const far = memory[at + OFFSETS + 1];
  for (let which = 0, end_1 = $mixture.LEVELS.length; which < end_1; which++) {
    const inside = within <= $mixture.corrected_probability($mixture.LEVELS[which], tail, near, far);
    $levels.learn(memory, person, share, which, inside, step);
  }
}
