// Written by `make laws` from hold.py: change that and run it again.
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export const AT = 0;
export function step(memory, motion) {
  const m = motion;
  const values_1 = $predictors_movement.follow(memory, m, AT);
  const fault = values_1[0];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  return $records.endpoint(m[0], m[1], m[2], $predictors_movement.phase(memory, m, AT));
}
export const HoldPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 0, learned: 0, states: 9,
  parameters: [

  ],
};
