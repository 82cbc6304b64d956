// Written by `make laws` from moments.py: change that and run it again.
import * as $records from "../../records.js";
export const COUNT = 0;
export const APART = 1;
export const CURSOR_X = 2;
export const CURSOR_Y = 3;
export const FIRST = 4;
export const T = 0;
export const APART_S = 0.0071;
export function new_moment(memory, at, cursor, width, most) {
  const t = cursor[0];
  const x = cursor[1];
  const y = cursor[2];
  let count = Math.trunc(memory[at + COUNT]);
  let last = at + FIRST + width * (count - 1);
  if (count === 0 || t !== memory[last + T]) {
    if (count === 0) {
      memory[at + APART] = APART_S;
    } else if (t - memory[last + T] < memory[at + APART]) {
      return -1;
    }
    if (count === most) {
      if (x === memory[at + CURSOR_X] && y === memory[at + CURSOR_Y]) {
        return -1;
      }
      count = Math.floor(most / 2);
      for (let k = 1, end_1 = count; k < end_1; k++) {
        for (let i = 0; i < width; i++) {
          memory[at + FIRST + width * k + i] = memory[at + FIRST + 2 * width * k + i];
        }
      }
      memory[at + APART] *= 2;
    }
    memory[at + COUNT] = count + 1;
    last = at + FIRST + width * count;
  }
  memory[at + CURSOR_X] = x;
  memory[at + CURSOR_Y] = y;
  memory[last + T] = t;
  return last;
}
export function moment_at(memory, at, k, span, share, width) {
  const start = span[0];
  const end = span[1];
  const due = share * (end - start) + $records.ROUNDING_S + 0.5 * memory[at + APART];
  while (k + 1 < memory[at + COUNT] && memory[at + FIRST + width * (k + 1) + T] - start <= due) {
    k += 1;
  }
  return k;
}
