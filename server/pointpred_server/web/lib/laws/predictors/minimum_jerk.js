// Written by `make laws` from minimum_jerk.py: change that and run it again.
import { hypot, larger, smaller } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
import * as $stage from "../stage.js";
export function progress(ratio) {
  const tau = 0.5 * (1 + Math.sqrt(1 - Math.sqrt(smaller(larger(ratio, 0), 1))));
  return [tau, tau * tau * tau * (10 - tau * (15 - 6 * tau))];
}
export function step(s, motion, s_at = 0) {
  const m = motion;
  const values_1 = $predictors_movement.follow(s, m, s_at);
  const fault = values_1[0];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(s, m, fault, s_at);
  }
  const phase = $predictors_movement.phase(s, m, s_at);
  if (s[s_at + 7] < $predictors_movement.STILL_M_S) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const values_2 = progress(hypot(m[3], m[4]) / s[s_at + 7]);
  const tau = values_2[0];
  const done = values_2[1];
  const ahead = (1 - done) / done;
  return [m[0], m[1] + ahead * (m[1] - s[s_at + 5]), m[2] + ahead * (m[2] - s[s_at + 6]), NaN, NaN, NaN, (m[0] - s[s_at + 4]) * (1 - tau) / tau, phase, NaN, NaN];
}
export const MinimumJerkPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 0, learned: 0, states: 9,
  parameters: [

  ],
};
