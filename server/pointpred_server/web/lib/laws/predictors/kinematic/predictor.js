// Written by `make laws` from predictor.py: change that and run it again.
import { larger, smaller, square } from "../../arithmetic.js";
import * as $features from "./features.js";
import * as $network from "./network.js";
import * as $predictors_movement from "../movement.js";
import * as $records from "../../records.js";
import * as $stage from "../../stage.js";
export function bounded_exp(logarithm, bounds) {
  return Math.exp(smaller(larger(logarithm, bounds[0]), bounds[1]));
}
export function step(s, motion, coefficients, s_at = 0, coefficients_at = 0) {
  const m = motion;
  const values = new Float64Array(65);
  const values_1 = $features.observe(s, m, values, s_at);
  const fault = values_1[0];
  const frame = values_1[1];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(s, m, fault, s_at);
  }
  const phase = $predictors_movement.phase(s, m, s_at);
  const reach = frame[0];
  const ux = frame[2];
  const uy = frame[3];
  if (reach === 0) {
    return $records.endpoint(m[0], m[1], m[2], phase);
  }
  const sums = new Float64Array(12);
  const at = $network.evaluate(coefficients, values, sums, coefficients_at);
  const calibration_at = coefficients_at + at + 132;
  const out_at = 0;
  let along = sums[out_at];
  let across = sums[out_at + 1] * $network.side(values);
  for (let i = 0; i < $network.BASES; i++) {
    along += sums[out_at + i + 2] * values[$network.BASIS_ALONG[i]];
    across += sums[out_at + i + 2] * values[$network.BASIS_ACROSS[i]];
  }
  const since = m[0] - s[s_at + 4];
  const left = (since + $network.HEAD_START_S) * bounded_exp(sums[out_at + 10], $network.LEFT_LOGS);
  const share = since / (since + left);
  const scale = reach * $network.factor(coefficients, share, $network.WIDTH_FACTOR, calibration_at);
  const wide = square(scale * bounded_exp(sums[out_at + 7], $network.WIDTH_LOGS));
  const broad = square(scale * bounded_exp(sums[out_at + 8], $network.WIDTH_LOGS));
  const tail = bounded_exp(sums[out_at + 9], $network.TAIL_LOGS);
  const spread = bounded_exp(sums[out_at + 11], $network.SPREAD_LOGS);
  return [m[0], m[1] + reach * (along * ux - across * uy), m[2] + reach * (along * uy + across * ux), wide * ux * ux + broad * uy * uy, (wide - broad) * ux * uy, wide * uy * uy + broad * ux * ux, left, phase, tail * $network.factor(coefficients, share, $network.TAIL_FACTOR, calibration_at), spread * $network.factor(coefficients, share, $network.SPREAD_FACTOR, calibration_at)];
}
export const KinematicPredictor = {
  step: step,
  fill: $stage.copy_values,
  settings: 0, learned: 0, states: 273,
  parameters: [

  ],
};
