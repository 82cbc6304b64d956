// Written by `make laws` from arrival_intervals.py: change that and run it again.
import { larger, smaller } from "../../arithmetic.js";
import * as $stages from "./stages.js";
export const LEVELS = [0.5, 0.8];
export const DEVIATIONS = [0.6744897501960817, 1.2815515655446004];
export const STAGES = 3;
export const SPREAD = 0.6;
export const SHARES = [0.6666666666666666, 1.3333333333333333];
export const STEP = 12;
export const STEP_OF = 5;
export const STEP_LEAST = 0.15;
export const FURTHEST = 3;
export const MOVEMENTS_MOST = 1000000;
export function spread(s, share, s_at = 0) {
  const values_1 = $stages.interpolation_among(share, STAGES);
  const stage = values_1[0];
  const part = values_1[1];
  const low = s[s_at + stage + 1];
  return SPREAD * Math.exp(low + part * (s[s_at + stage + 2] - low));
}
export function next_step(s, s_at = 0) {
  s[s_at] = smaller(s[s_at] + 1, MOVEMENTS_MOST);
  return larger(STEP / (s[s_at] + STEP_OF), STEP_LEAST);
}
export function judge(s, share, step, claim, left, s_at = 0) {
  const off = Math.abs(Math.log(left / claim[0]));
  let missed = 0;
  for (let k = 0, end_1 = LEVELS.length; k < end_1; k++) {
    const inside = off <= DEVIATIONS[k] * claim[1];
    missed += SHARES[k] * (inside ? LEVELS[k] - 1 : LEVELS[k]);
  }
  const values_2 = $stages.interpolation_among(share, STAGES);
  const stage = values_2[0];
  const part = values_2[1];
  for (let side = 0; side < 2; side++) {
    const change = step * missed * (side === 1 ? part : 1 - part);
    s[s_at + stage + side + 1] = $stages.bounded(s[s_at + stage + side + 1] + change, FURTHEST);
  }
}
