// Written by `make page` from known_places.py: change that and run it again.
import { larger } from "../../arithmetic.js";
import * as $correction from "./correction.js";
import * as $destination from "./destination.js";
import * as $places from "./places.js";
export const X = 0;
export const Y = 1;
export const P = 2;
export const BEFORE = 3;
export const VISITS = 4;
export const NUMBER = 5;
export const SPREAD = 6;
export function last_end(memory, known, key) {
  for (let age = 0; age < $places.MOVEMENTS; age++) {
    const number = $places.visited(memory, known, age);
    const place = known + $places.PLACES + $places.WIDTH * larger(number, 0);
    if (number >= 0 && memory[place + $places.KEY] === key) {
      return [memory[place + $places.X], memory[place + $places.Y]];
    }
  }
  return [0, 0];
}
export function list_places(memory, person, at, parts, scene, out) {
  const known = person + $correction.KNOWN;
  const going = at + $correction.DESTINATION;
  const waits = memory[going + $destination.READY] === 0;
  let start = [memory[at + $correction.X0] - scene[1], memory[at + $correction.Y0] - scene[2]];
  if (waits) {
    if (memory[at + $correction.STARTED] === 0) {
      start = last_end(memory, known, scene[0]);
    }
    $correction.prepare(memory, person, going, parts, scene, start);
  }
  let count = 0;
  const returns = memory[going + $destination.RETURNS];
  for (let i = 0, end_1 = Math.trunc(memory[known + $places.COUNT]); i < end_1; i++) {
    const place = known + $places.PLACES + $places.WIDTH * i;
    if (memory[place + $places.KEY] === scene[0]) {
      const x = memory[place + $places.X];
      const y = memory[place + $places.Y];
      const before = returns * memory[going + $destination.BEFORE + i];
      out[count][X] = x + scene[1];
      out[count][Y] = y + scene[2];
      out[count][P] = waits ? before : memory[going + $destination.NOW + i];
      out[count][BEFORE] = before;
      out[count][VISITS] = memory[place + $places.WEIGHT];
      out[count][NUMBER] = i;
      out[count][SPREAD] = $destination.spread_of(memory, going, start, x, y);
      count += 1;
    }
  }
  if (waits) {
    memory.fill(0, going, going + $destination.STATES);
  }
  return count;
}
