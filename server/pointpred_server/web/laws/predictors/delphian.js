// Written by `make laws` from delphian.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const SLOPE = 0;
export const OFFSET = 1;
export const FALL = 2;
export const AT = 3;
export const PEAK_X = 12;
export const PEAK_Y = 13;
export const UNIT_X = 14;
export const UNIT_Y = 15;
export const FALLEN = 16;
export function step(memory, motion) {
  const m = motion;
  const before = memory[AT + 7];
  const values_1 = $predictors_movement.follow(memory, m, AT);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  const phase = $predictors_movement.phase(memory, m, AT);
  if (new_) {
    memory.fill(0, PEAK_X);
  }
  const peak = memory[AT + 7];
  const speed = hypot(m[3], m[4]);
  if (new_ || peak > before) {
    const away_x = m[1] - memory[AT + 5];
    const away_y = m[2] - memory[AT + 6];
    const away = hypot(away_x, away_y);
    memory[PEAK_X] = m[1];
    memory[PEAK_Y] = m[2];
    memory[FALLEN] = 0;
    memory[UNIT_X] = away > 0 ? away_x / away : 0;
    memory[UNIT_Y] = away > 0 ? away_y / away : 0;
  } else if (speed < (1 - memory[FALL]) * peak && peak >= $predictors_movement.STILL_M_S) {
    memory[FALLEN] = 1;
  }
  if (memory[FALLEN] === 0 || memory[UNIT_X] === 0 && memory[UNIT_Y] === 0) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const ahead = larger(memory[SLOPE] * peak + memory[OFFSET], 0);
  const end_x = memory[PEAK_X] + ahead * memory[UNIT_X];
  const end_y = memory[PEAK_Y] + ahead * memory[UNIT_Y];
  return $records.endpoint(m[0], end_x, end_y, phase);
}
export const DelphianPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 3, learned: 0, states: 14,
  parameters: [
    { name: "slope_px_s_m", unit: "px s/m", low: 0, high: 100000, default: 56 },
    { name: "offset_px", unit: "px", low: -10000, high: 10000, default: 111 },
    { name: "fall", low: 0, high: 0.9, default: 0.05 },
  ],
};
