// Written by `make laws` from mixed_region.py: change that and run it again.
import { larger, matrix } from "../../arithmetic.js";
import * as $destination from "./destination.js";
import * as $levels from "./levels.js";
import * as $mixture from "../mixture.js";
export const MOST_PLACES = 4;
export const LEAST = 0.02;
export const LEAST_SPREAD = 0.5;
export const POINTS = 32;
export function likeliest(held, going, below, held_at = 0, going_at = 0) {
  let best = -1;
  let most = LEAST;
  for (let i = 0, end_1 = Math.trunc(held[held_at]); i < end_1; i++) {
    const share = going[going_at + i + 68];
    if (most < share && share < below) {
      best = i;
      most = share;
    }
  }
  return best;
}
export function claim(s, share, elsewhere, s_at = 0) {
  s[s_at] = 1;
  s[s_at + 1] = share;
  for (let i = 0, end_1 = elsewhere.length; i < end_1; i++) {
    s[s_at + i + 2] = elsewhere[i];
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
export function write(offsets, held, going, now, to, origin, start, offsets_at = 0, held_at = 0, going_at = 0, now_at = 0, to_at = 0) {
  let count = 1;
  let rest = 1;
  let below = 2;
  let number = likeliest(held, going, below, held_at, going_at);
  while (number >= 0 && count <= MOST_PLACES) {
    below = going[going_at + number + 68];
    const place_at = held_at + number * 4 + 2;
    const spread = larger($destination.spread_of(going, start, held[place_at + 1], held[place_at + 2], going_at), LEAST_SPREAD);
    write_part(to, below, [held[place_at + 1] + origin[0], held[place_at + 2] + origin[1]], spread, to_at + count * 7 + 1);
    rest -= below;
    count += 1;
    number = likeliest(held, going, below, held_at, going_at);
  }
  const elsewhere_at = to_at + 1;
  to[to_at] = count;
  to[elsewhere_at] = larger(rest, 0);
  for (let i = 0; i < 6; i++) {
    to[elsewhere_at + i + 1] = now[now_at + i + 2];
  }
  for (let which = 0, end_1 = $mixture.LEVELS.length; which < end_1; which++) {
    to[to_at + which + 36] = $levels.offset(offsets, now[now_at + 1], which, offsets_at);
  }
}
export function judge(offsets, stated, end, share, step, offsets_at = 0, stated_at = 0) {
  const count = Math.trunc(stated[stated_at]);
  const parts = matrix(MOST_PLACES + 1, 7);
  for (let k = 0; k < count; k++) {
    for (let i = 0; i < 7; i++) {
      parts[k][i] = stated[stated_at + k * 7 + i + 1];
    }
  }
  const within = $mixture.content(parts, count, end[0], end[1], POINTS);
  const tail = stated[stated_at + 7];
  const near = stated[stated_at + 36];
  const far = stated[stated_at + 37];
  for (let which = 0, end_1 = $mixture.LEVELS.length; which < end_1; which++) {
    const inside = within <= $mixture.corrected_probability($mixture.LEVELS[which], tail, near, far);
    $levels.learn(offsets, share, which, inside, step, offsets_at);
  }
}
