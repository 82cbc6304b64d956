// Written by `make laws` from hold.py: change that and run it again.
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export function step(s, motion, s_at = 0) {
  const m = motion;
  const values_1 = $predictors_movement.follow(s, m, s_at);
  const fault = values_1[0];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(s, m, fault, s_at);
  }
  return $records.endpoint(m[0], m[1], m[2], $predictors_movement.phase(s, m, s_at));
}
export const HoldPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 0, learned: 0, states: 9,
  parameters: [

  ],
};
