// Written by `make laws` from track.py: change that and run it again.
import { hypot, larger, smaller } from "../../arithmetic.js";
import * as $submovements from "./submovements.js";
export const SLOW = 0.2;
export const SLOWER = 0.05;
export const SPAN_S = 0.05;
export const T = 0;
export const X = 1;
export const Y = 2;
export const WAY = 3;
export const FAR = 4;
export const CURSOR_PEAK = 5;
export const PEAK = 6;
export const PEAK_T = 7;
export const PEAK_D = 8;
export const PEAK_PATH = 9;
export const PUSH = 10;
export const PUSH_T = 11;
export const BRAKE = 12;
export const SUBMOVEMENT = 13;
export const FAST_T = 26;
export const MOVING_T = 27;
export const MOVED_T = 28;
export const STATES = 29;
export function advance(memory, at, point, hand, cursor_speed) {
  const t = point[0];
  const x = point[1];
  const y = point[2];
  const path = point[3];
  const speed = hypot(hand[3], hand[4]);
  const d = hypot(x, y);
  if (x !== memory[at + X] || y !== memory[at + Y]) {
    memory[at + MOVED_T] = t;
  }
  memory[at + WAY] += speed * (t - memory[at + T]);
  memory[at + T] = t;
  memory[at + X] = x;
  memory[at + Y] = y;
  memory[at + FAR] = larger(memory[at + FAR], d);
  memory[at + CURSOR_PEAK] = larger(memory[at + CURSOR_PEAK], cursor_speed);
  if (speed > memory[at + PEAK]) {
    memory[at + PEAK] = speed;
    memory[at + PEAK_T] = t;
    memory[at + PEAK_D] = d;
    memory[at + PEAK_PATH] = path;
  }
  const push = d > 0 ? (hand[5] * x + hand[6] * y) / d : 0;
  if (push > memory[at + PUSH]) {
    memory[at + PUSH] = push;
    memory[at + PUSH_T] = t;
  }
  memory[at + BRAKE] = smaller(memory[at + BRAKE], push);
  if (speed >= SLOW * memory[at + PEAK]) {
    memory[at + FAST_T] = t;
  }
  if (speed >= SLOWER * memory[at + PEAK]) {
    memory[at + MOVING_T] = t;
  }
  $submovements.divide(memory, at + SUBMOVEMENT, point, speed, memory[at + PEAK]);
}
