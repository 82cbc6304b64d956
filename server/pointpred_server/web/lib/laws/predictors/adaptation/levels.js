// Written by `make laws` from levels.py: change that and run it again.
import { larger } from "../../arithmetic.js";
import * as $stages from "./stages.js";
import * as $mixture from "../mixture.js";
export const STEP = 6;
export const STEP_OF = 5;
export const STEP_LEAST = 0.2;
export const FURTHEST = 6;
export function offset(s, share, which, s_at = 0) {
  const values_1 = $stages.interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  const low = s[s_at + stage * 2 + which];
  return low + part * (s[s_at + (stage + 1) * 2 + which] - low);
}
export function step_after(movements) {
  return larger(STEP / (movements + STEP_OF), STEP_LEAST);
}
export function learn(s, share, which, inside, step, s_at = 0) {
  const values_1 = $stages.interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  const missed = inside ? $mixture.LEVELS[which] - 1 : $mixture.LEVELS[which];
  s[s_at + stage * 2 + which] = $stages.bounded(s[s_at + stage * 2 + which] + step * (1 - part) * missed, FURTHEST);
  s[s_at + (stage + 1) * 2 + which] = $stages.bounded(s[s_at + (stage + 1) * 2 + which] + step * part * missed, FURTHEST);
}
