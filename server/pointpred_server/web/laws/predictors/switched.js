// Written by `make laws` from switched.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $drem from "../regression/drem.js";
import * as $stage from "../stage.js";
export const UNKNOWNS = 3;
export const PEAK = 0;
export const PLACE = 1;
export const ENDPOINT = 2;
export const DREM = 3;
export const THRESHOLD = 0;
export const BOUND = 1;
export const DELAY_S = 2;
export const GAMMA = 3;
export const AT = 4;
export const X_AXIS = 13;
export const Y_AXIS = 715;
export function advance(memory, axis, t, place, v, a) {
  const moved = place - memory[axis + PLACE];
  memory[axis + PLACE] = place;
  memory[axis + PEAK] = larger(memory[axis + PEAK], Math.abs(v));
  const before = memory[axis + ENDPOINT];
  const regression = axis + DREM;
  memory[regression + $drem.REGRESSOR] = -a;
  memory[regression + $drem.REGRESSOR + 1] = -v;
  memory[regression + $drem.REGRESSOR + 2] = 1;
  if (Math.abs(v) < memory[THRESHOLD] * memory[axis + PEAK]) {
    const third = $drem.estimates(regression, UNKNOWNS) + 2;
    memory[third] = before;
    const solved = $drem.advance(memory, regression, UNKNOWNS, memory[DELAY_S], memory[GAMMA], [t, place]);
    if (solved && Math.abs(memory[third] - before) < memory[BOUND] * Math.abs(place)) {
      memory[axis + ENDPOINT] = memory[third];
    }
  } else {
    $drem.remember(memory, regression, UNKNOWNS, memory[DELAY_S], t, place);
    if (a * v >= 0) {
      memory[axis + ENDPOINT] = before + 2 * moved;
    }
  }
  return memory[axis + ENDPOINT];
}
export function step(memory, motion) {
  const m = motion;
  const values_1 = $predictors_movement.follow(memory, m, AT);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  if (new_) {
    memory.fill(0, X_AXIS);
  }
  const x0 = memory[AT + 5];
  const y0 = memory[AT + 6];
  const since = m[0] - memory[AT + 4];
  const end_x = x0 + advance(memory, X_AXIS, since, m[1] - x0, m[3], m[5]);
  const end_y = y0 + advance(memory, Y_AXIS, since, m[2] - y0, m[4], m[6]);
  return $records.endpoint(m[0], end_x, end_y, $predictors_movement.phase(memory, m, AT));
}
export const SwitchedPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 4, learned: 0, states: 1413,
  parameters: [
    { name: "threshold", unit: "share of peak speed", low: 0, high: 10, default: 0.2 },
    { name: "bound", unit: "share of displacement", low: 0, high: 10, default: 0.1 },
    { name: "delay_s", unit: "s", low: 0.001, high: 1, default: 0.1 },
    { name: "gamma", unit: "1/s", low: 0, high: 1000000000, default: 10000 },
  ],
};
