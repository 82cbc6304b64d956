// Written by `make laws` from levels.py: change that and run it again.
import { larger, smaller } from "../../arithmetic.js";
import * as $stages from "./stages.js";
import * as $mixture from "../mixture.js";
export const STEP = 6;
export const STEP_OF = 5;
export const STEP_LEAST = 0.2;
export const FURTHEST = 6;
export function offset(memory, at, share, which) {
  const values_1 = $stages.interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  const low = at + $mixture.LEVELS.length * stage + which;
  return memory[low] + part * (memory[low + $mixture.LEVELS.length] - memory[low]);
}
export function step_after(movements) {
  return larger(STEP / (movements + STEP_OF), STEP_LEAST);
}
export function add(memory, slot, change) {
  memory[slot] = smaller(larger(memory[slot] + change, -FURTHEST), FURTHEST);
}
export function learn(memory, at, share, which, inside, step) {
  const values_1 = $stages.interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  const missed = inside ? $mixture.LEVELS[which] - 1 : $mixture.LEVELS[which];
  const low = at + $mixture.LEVELS.length * stage + which;
  add(memory, low, step * (1 - part) * missed);
  add(memory, low + $mixture.LEVELS.length, step * part * missed);
}
