// Written by `make laws` from predictor.py: change that and run it again.
import { larger, smaller, square } from "../../arithmetic.js";
import * as $features from "./features.js";
import * as $network from "./network.js";
import * as $predictors_movement from "../movement.js";
import * as $records from "../../records.js";
import * as $stage from "../../stage.js";
export const AT = 0;
export function bounded_exp(logarithm, bounds) {
  return Math.exp(smaller(larger(logarithm, bounds[0]), bounds[1]));
}
export function step(memory, motion, coefficients) {
  const m = motion;
  const values = new Float64Array($features.FEATURES);
  const values_1 = $features.observe(memory, AT, m, values);
  const fault = values_1[0];
  const frame = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, AT);
  }
  const phase = $predictors_movement.phase(memory, m, AT);
  const reach = frame[0];
  const ux = frame[2];
  const uy = frame[3];
  if (reach === 0) {
    return $records.endpoint(m[0], m[1], m[2], phase);
  }
  const out = new Float64Array($network.OUTPUTS);
  const calibration_at = $network.evaluate(coefficients, values, out);
  let along = out[$network.ALONG];
  let across = out[$network.ACROSS] * $network.side(values);
  for (let i = 0; i < $network.BASES; i++) {
    along += out[$network.BASIS + i] * values[$network.BASIS_ALONG[i]];
    across += out[$network.BASIS + i] * values[$network.BASIS_ACROSS[i]];
  }
  const since = m[0] - memory[AT + 4];
  const left = (since + $network.HEAD_START_S) * bounded_exp(out[$network.LEFT], $network.LEFT_LOGS);
  const share = since / (since + left);
  const scale = reach * $network.factor(coefficients, calibration_at, share, $network.WIDTH_FACTOR);
  const wide = square(scale * bounded_exp(out[$network.WIDE], $network.WIDTH_LOGS));
  const broad = square(scale * bounded_exp(out[$network.BROAD], $network.WIDTH_LOGS));
  const tail = bounded_exp(out[$network.TAIL], $network.TAIL_LOGS);
  const spread = bounded_exp(out[$network.SPREAD], $network.SPREAD_LOGS);
  return [m[0], m[1] + reach * (along * ux - across * uy), m[2] + reach * (along * uy + across * ux), wide * ux * ux + broad * uy * uy, (wide - broad) * ux * uy, wide * uy * uy + broad * ux * ux, left, phase, tail * $network.factor(coefficients, calibration_at, share, $network.TAIL_FACTOR), spread * $network.factor(coefficients, calibration_at, share, $network.SPREAD_FACTOR)];
}
export const KinematicPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 0, learned: 0, states: 273,
  parameters: [

  ],
};
