// Written by `make page` from predictor.py: change that and run it again.
import { hypot, larger, smaller } from "../../arithmetic.js";
import * as $matching from "./matching.js";
import * as $predictors_movement from "../movement.js";
import * as $records from "../../records.js";
export function distance(memory, at) {
  const away_x = memory[at + $predictors_movement.X] - memory[at + $predictors_movement.X0];
  return hypot(away_x, memory[at + $predictors_movement.Y] - memory[at + $predictors_movement.Y0]);
}
export function conclude(memory) {
  const at = $matching.counts(memory) + $matching.LEARNED;
  $matching.keep(memory, at, distance(memory, at));
}
export function resample(memory, at, since, x_before, y_before) {
  const most = memory[$matching.LONGEST] + $matching.TAPS;
  const now = memory[at + $predictors_movement.T] - memory[at + $predictors_movement.T0];
  const x = memory[at + $predictors_movement.X];
  const y = memory[at + $predictors_movement.Y];
  let due = memory[at + $matching.SAMPLES] * $matching.STEP_S;
  while (due <= now + $matching.STAMP_S && memory[at + $matching.SAMPLES] < most) {
    const back = smaller(larger((now - due) / since, 0), 1);
    const grid_x = x + back * (x_before - x);
    const grid_y = y + back * (y_before - y);
    const way = hypot(grid_x - memory[at + $matching.GRID_X], grid_y - memory[at + $matching.GRID_Y]);
    memory[at + $matching.GRID_X] = grid_x;
    memory[at + $matching.GRID_Y] = grid_y;
    $matching.sample(memory, at, way * $matching.RATE_HZ);
    due = memory[at + $matching.SAMPLES] * $matching.STEP_S;
  }
}
export function step(memory, motion) {
  const m = motion;
  const at = $matching.counts(memory) + $matching.LEARNED;
  const last_distance = distance(memory, at);
  const x_before = memory[at + $predictors_movement.X];
  const y_before = memory[at + $predictors_movement.Y];
  const values_1 = $predictors_movement.follow(memory, at, m);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, at, m, fault);
  }
  const phase = $predictors_movement.phase(memory, at, m);
  if (new_) {
    $matching.keep(memory, at, last_distance);
    memory.fill(0, at + $predictors_movement.STATES);
    memory[at + $matching.POINTS] = 1;
    $matching.sample(memory, at, 0);
  }
  if (new_ || m[0] === memory[at + $predictors_movement.T0]) {
    memory[at + $matching.GRID_X] = m[1];
    memory[at + $matching.GRID_Y] = m[2];
  }
  if (dt > 0) {
    memory[at + $matching.POINTS] += 1;
    resample(memory, at, dt, x_before, y_before);
  }
  const away = distance(memory, at);
  let best = -1;
  if (memory[at + $matching.POINTS] >= $matching.POINTS_LEAST) {
    best = $matching.winner(memory, at, dt > 0 ? 1 : 0);
  }
  if (best < 0 || !(away > 0)) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const ahead = memory[$matching.template(memory, best) + $matching.DISTANCE] / away - 1;
  const x0 = memory[at + $predictors_movement.X0];
  const y0 = memory[at + $predictors_movement.Y0];
  return $records.endpoint(m[0], m[1] + ahead * (m[1] - x0), m[2] + ahead * (m[2] - y0), phase);
}
export const TemplatePredictor = {
  step: step,
  conclude: conclude,
  fill: $matching.fill,
  sizes: $matching.sizes,
  settings: 26, learned: 4034, states: 1696,
  parameters: [
    { name: "templates", low: 0, high: 1000, default: 64, whole: true },
    { name: "longest_s", unit: "s", low: 0.2, high: 30, default: 3 },
    { name: "shortest_px", unit: "px", low: 0, high: 1000000, default: 10 },
  ],
};
