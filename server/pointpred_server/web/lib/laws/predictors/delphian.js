// Written by `make laws` from delphian.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const settings_at = memory_at;
  const s_at = memory_at + 3;
  const peak_at = memory_at + 12;
  const before = memory[s_at + 7];
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  const phase = $predictors_movement.phase(memory, m, s_at);
  if (new_) {
    memory.fill(0, peak_at, peak_at + 5);
  }
  const speed = hypot(m[3], m[4]);
  if (new_ || memory[s_at + 7] > before) {
    const away_x = m[1] - memory[s_at + 5];
    const away_y = m[2] - memory[s_at + 6];
    const away = hypot(away_x, away_y);
    memory[peak_at] = m[1];
    memory[peak_at + 1] = m[2];
    memory[peak_at + 4] = 0;
    memory[peak_at + 2] = away > 0 ? away_x / away : 0;
    memory[peak_at + 3] = away > 0 ? away_y / away : 0;
  } else if (speed < (1 - memory[settings_at + 2]) * memory[s_at + 7] && memory[s_at + 7] >= $predictors_movement.STILL_M_S) {
    memory[peak_at + 4] = 1;
  }
  if (memory[peak_at + 4] === 0 || memory[peak_at + 2] === 0 && memory[peak_at + 3] === 0) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const ahead = larger(memory[settings_at] * memory[s_at + 7] + memory[settings_at + 1], 0);
  return $records.endpoint(m[0], memory[peak_at] + ahead * memory[peak_at + 2], memory[peak_at + 1] + ahead * memory[peak_at + 3], phase);
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
