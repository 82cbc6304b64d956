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
export const MOVEMENTS = 0;
export const OFFSETS = 1;
export function spread(memory, at, share) {
  const values_1 = $stages.interpolation_among(share, STAGES);
  const stage = values_1[0];
  const part = values_1[1];
  const low = memory[at + OFFSETS + stage];
  return SPREAD * Math.exp(low + part * (memory[at + OFFSETS + stage + 1] - low));
}
export function next_step(memory, at) {
  memory[at + MOVEMENTS] = smaller(memory[at + MOVEMENTS] + 1, MOVEMENTS_MOST);
  return larger(STEP / (memory[at + MOVEMENTS] + STEP_OF), STEP_LEAST);
}
export function judge(memory, at, share, step, claim, left) {
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
    const slot = at + OFFSETS + stage + side;
    const change = step * missed * (side === 1 ? part : 1 - part);
    memory[slot] = smaller(larger(memory[slot] + change, -FURTHEST), FURTHEST);
  }
}
