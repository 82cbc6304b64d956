// Written by `make laws` from network.py: change that and run it again.
import { larger, remainder, smaller } from "../../arithmetic.js";
import * as $features from "./features.js";
export const BASES = 5;
export const BASIS_ALONG = [9, 40, 42, 45, 28];
export const BASIS_ACROSS = [50, 55, 57, 60, 52];
export const SIDES = [57, 60];
export const SIDE_SOFT = 0.01;
export const WIDTH_LOGS = [-9, 4];
export const TAIL_LOGS = [0.3, 4];
export const LEFT_LOGS = [-6, 4];
export const SPREAD_LOGS = [-3, 1.5];
export const HEAD_START_S = 0.05;
export const EXTREME = 6;
export const GATE_SLOPE = 0.16666666666666666;
export const KNOTS = 10;
export const WIDTH_FACTOR = 0;
export const TAIL_FACTOR = 1;
export const SPREAD_FACTOR = 2;
export function side(values) {
  const bent = values[SIDES[0]] + values[SIDES[1]];
  return bent / Math.pow(bent * bent + SIDE_SOFT * SIDE_SOFT, 0.5);
}
export function layer(coefficients, at, inputs, sums, coefficients_at = 0) {
  const width = sums.length;
  const count = inputs.length;
  const offset = at + count * width;
  for (let j = 0; j < width; j++) {
    sums[j] = coefficients[coefficients_at + offset + j + 132];
  }
  for (let k = 0, end_1 = Math.floor(count / 8); k < end_1; k++) {
    const p = 8 * k;
    const w = at + 8 * k * width;
    const a = inputs[p];
    const b = inputs[p + 1];
    const c = inputs[p + 2];
    const d = inputs[p + 3];
    const e = inputs[p + 4];
    const f = inputs[p + 5];
    const g = inputs[p + 6];
    const h = inputs[p + 7];
    const wa = coefficients_at + w + 132;
    const wb = coefficients_at + w + width + 132;
    const wc = coefficients_at + w + 2 * width + 132;
    const wd = coefficients_at + w + 3 * width + 132;
    const we = coefficients_at + w + 4 * width + 132;
    const wf = coefficients_at + w + 5 * width + 132;
    const wg = coefficients_at + w + 6 * width + 132;
    const wh = coefficients_at + w + 7 * width + 132;
    for (let j = 0; j < width; j++) {
      const four = sums[j] + a * coefficients[wa + j] + b * coefficients[wb + j] + c * coefficients[wc + j] + d * coefficients[wd + j];
      sums[j] = four + e * coefficients[we + j] + f * coefficients[wf + j] + g * coefficients[wg + j] + h * coefficients[wh + j];
    }
  }
  for (let i = count - remainder(count, 8); i < count; i++) {
    const value = inputs[i];
    const weights = coefficients_at + at + i * width + 132;
    for (let j = 0; j < width; j++) {
      sums[j] += value * coefficients[weights + j];
    }
  }
  return offset + width;
}
export function activate(sums) {
  for (let j = 0, end_1 = sums.length; j < end_1; j++) {
    sums[j] *= smaller(larger(sums[j] * GATE_SLOPE + 0.5, 0), 1);
  }
}
export function evaluate(coefficients, values, out, coefficients_at = 0) {
  const mirror = side(values);
  const count = values.length;
  const inputs = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    let value = i >= $features.ODD ? values[i] * mirror : values[i];
    value = (value - coefficients[coefficients_at + i + 2]) * coefficients[coefficients_at + i + 67];
    inputs[i] = smaller(larger(value, -EXTREME), EXTREME);
  }
  const first = new Float64Array(Math.trunc(coefficients[coefficients_at]));
  const second = new Float64Array(Math.trunc(coefficients[coefficients_at + 1]));
  let at = layer(coefficients, 0, inputs, first, coefficients_at);
  activate(first);
  at = layer(coefficients, at, first, second, coefficients_at);
  activate(second);
  return layer(coefficients, at, second, out, coefficients_at);
}
export function factor(calibration, share, which, calibration_at = 0) {
  const place = smaller(larger(share * KNOTS - 0.5, 0), KNOTS - 1);
  const knot = smaller(Math.floor(place), KNOTS - 2);
  const low = calibration[calibration_at + knot * 3 + which];
  const high = calibration[calibration_at + (knot + 1) * 3 + which];
  return Math.exp(low + (place - knot) * (high - low));
}
