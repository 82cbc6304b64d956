// Written by `make laws` from posterior.py: change that and run it again.
import { hypot, larger, smaller, square } from "../arithmetic.js";
import * as $records from "../records.js";
import * as $rectangles from "./rectangles.js";
export const EFFECTIVE = 4.133;
export const ANGLE = 0.15;
export const ALONG = 0.5;
export const ACROSS = 0.2;
export const LEAST = 0.1;
export const FEATURES = 6;
export const FITTED = /* @__PURE__ */ new Float64Array([0, -0.3066, -0.49, -1.485, 0.02719, -0.9111, 0.5877, -0.4726, -0.3215, -0.2528, 0.1177, -0.09325, -0.8728, -1.422, 0.2136, 0.815, 0, -0.2966, -0.4696, -1.845, 0.05997, -0.4758, 0.0001748, -0.5646, -0.4291, -0.5543, 0.171, -0.2724, -1.358, -1.322, -0.1863, 0.1166]);
export const FITTED_PAGES = /* @__PURE__ */ new Float64Array([0.3016, -0.1244, -0.4561, -0.01862, -0.03106, -0.4446, 0.5945, -0.2008, -0.09255, 0.1306, -0.0288, 0, -2.041, -1.813, 0, 0, 0, -0.1987, -0.491, -0.0658, 0.001723, -1.418, 2.236e-05, -0.3598, -0.3276, -0.05819, 0.07053, -0.5739, -2.091, -0.8464, 0, 0]);
export const FITTED_NONE = 0.25;
export const FITTED_TARGETS = 16;
export const LEAST_MASS = 0.001;
export const FLATTEST = 1e-12;
export const TAILS = [0.001, 1000000000];
export function unclaimed(s, x, y, s_at = 0) {
  let gx = x - s[s_at + 2];
  let gy = y - s[s_at + 3];
  const done_x = s[s_at + 2] - s[s_at + 6];
  const done_y = s[s_at + 3] - s[s_at + 7];
  const left = hypot(gx, gy);
  const done = hypot(done_x, done_y);
  if (left === 0) {
    gx = done_x;
    gy = done_y;
  }
  const size = hypot(gx, gy);
  const reach = larger(left + LEAST * done, 1);
  const across = square(ACROSS * reach);
  if (size === 0) {
    return [across, 0, across];
  }
  const more = square(ALONG * reach) - across;
  const ux = gx / size;
  const uy = gy / size;
  return [across + more * ux * ux, more * ux * uy, across + more * uy * uy];
}
export function direction(x, y) {
  const size = hypot(x, y);
  return size > 0 ? [x / size, y / size] : [0, 0];
}
export function situation(s, s_at = 0) {
  const x = s[s_at + 2];
  const y = s[s_at + 3];
  const way = hypot(x - s[s_at + 6], y - s[s_at + 7]);
  const sweep = s[s_at + 12] * (s[s_at + 1] - s[s_at + 5]);
  const values_1 = direction(x - s[s_at + 8], y - s[s_at + 9]);
  const trail_x = values_1[0];
  const trail_y = values_1[1];
  const values_2 = direction(s[s_at + 10], s[s_at + 11]);
  const ux = values_2[0];
  const uy = values_2[1];
  return [x, y, trail_x, trail_y, ux, uy, Math.log(larger(way, 1)), Math.log(larger(sweep, 1))];
}
export function log_mass(predicted, dx, dy, width, height) {
  const sxx = predicted[2] + square(width / EFFECTIVE);
  const sxy = predicted[3];
  const syy = predicted[4] + square(height / EFFECTIVE);
  const det = sxx * syy - sxy * sxy;
  const area = width * height / (2 * Math.PI);
  const far = larger((syy * dx * dx - 2 * sxy * dx * dy + sxx * dy * dy) / det, 0);
  const flat = 0.5 * Math.log(area * area / det);
  if (predicted[5] !== predicted[5]) {
    return flat - 0.5 * far;
  }
  return flat - (0.5 * predicted[5] + 1) * Math.log(1 + far / predicted[5]);
}
export function feature(row, now, predicted) {
  let off;
  const x = row[$rectangles.CENTRE_X];
  const y = row[$rectangles.CENTRE_Y];
  const width = row[$rectangles.WIDTH];
  const height = row[$rectangles.HEIGHT];
  const gx = x - now[0];
  const gy = y - now[1];
  const size = 0.5 * (width + height);
  const far2 = gx * gx + gy * gy;
  const far = Math.sqrt(far2);
  const straight = ANGLE * ANGLE * far2 + 0.0625 * size * size;
  let trail = 0;
  let heading = 0;
  if (now[2] !== 0 || now[3] !== 0) {
    off = larger(far - now[2] * gx - now[3] * gy, 0);
    trail = Math.log(1 + 2 * far * off / straight);
  }
  if (now[4] !== 0 || now[5] !== 0) {
    off = larger(far - now[4] * gx - now[5] * gy, 0);
    heading = Math.log(1 + 2 * far * off / straight);
  }
  const left = larger(far, 1);
  const log_left = Math.log(left);
  return [log_mass(predicted, x - predicted[0], y - predicted[1], width, height), trail, heading, log_left - now[6], log_left - now[7], Math.log(1 + 2 * left / size)];
}
export function lawful(predicted) {
  const sxx = predicted[2];
  const sxy = predicted[3];
  const syy = predicted[4];
  const tail = predicted[5];
  if (!((0 < sxx && sxx <= $records.LARGEST * $records.LARGEST) && (0 < syy && syy <= $records.LARGEST * $records.LARGEST) && Math.abs(sxy) <= $records.LARGEST * $records.LARGEST)) {
    return false;
  }
  return sxx * syy - sxy * sxy > FLATTEST * sxx * syy && (tail !== tail || TAILS[0] <= tail && tail <= TAILS[1]);
}
export function log_total(mean) {
  return Math.log(larger(FITTED_TARGETS * mean, LEAST_MASS));
}
export function scores(s, table, answer, coefficients, elsewhere, out, s_at = 0, coefficients_at = 0) {
  let x = answer[1];
  let y = answer[2];
  let sxx = answer[3];
  let sxy = answer[4];
  let syy = answer[5];
  const tail = answer[8];
  const claimed = Math.abs(x) <= $records.LARGEST && Math.abs(y) <= $records.LARGEST;
  if (!claimed) {
    x = s[s_at + 2];
    y = s[s_at + 3];
  }
  let fit_at = coefficients_at;
  let predicted = [x, y, sxx, sxy, syy, tail];
  if (!claimed || !lawful(predicted)) {
    const values_1 = unclaimed(s, x, y, s_at);
    sxx = values_1[0];
    sxy = values_1[1];
    syy = values_1[2];
    fit_at = coefficients_at + 16;
    predicted = [x, y, sxx, sxy, syy, NaN];
  }
  const now = situation(s, s_at);
  const weight = new Float64Array(FEATURES);
  const fast = s[s_at + 14] > 0 ? smaller(s[s_at + 12] / s[s_at + 14], 1) : 0;
  for (let j = 0; j < FEATURES; j++) {
    weight[j] = (1 - fast) * coefficients[fit_at + j] + fast * coefficients[fit_at + j + 6];
  }
  const count = table.length;
  let total = 0;
  const usual = Math.log(FITTED_TARGETS * (1 - elsewhere) / (1 - FITTED_NONE));
  for (let i = 0; i < count; i++) {
    if (table[i][$rectangles.LOG_WEIGHT] === -Infinity) {
      out[i] = -Infinity;
      continue;
    }
    const values_2 = feature(table[i], now, predicted);
    const f0 = values_2[0];
    const f1 = values_2[1];
    const f2 = values_2[2];
    const f3 = values_2[3];
    const f4 = values_2[4];
    const f5 = values_2[5];
    const score = weight[0] * f0 + weight[1] * f1 + weight[2] * f2;
    out[i] = table[i][$rectangles.LOG_WEIGHT] + usual + score + weight[3] * f3 + weight[4] * f4 + weight[5] * f5;
    total += Math.exp(table[i][$rectangles.LOG_WEIGHT] + f0);
  }
  const none = (1 - fast) * coefficients[fit_at + 12] + fast * coefficients[fit_at + 13];
  const around = (1 - fast) * coefficients[fit_at + 14] + fast * coefficients[fit_at + 15];
  out[count] = none + around * log_total(total) + Math.log(elsewhere / FITTED_NONE);
}
export function normalise(out) {
  let most = -Infinity;
  for (let i = 0, end_1 = out.length; i < end_1; i++) {
    most = larger(most, out[i]);
  }
  let total = 0;
  for (let i = 0, end_2 = out.length; i < end_2; i++) {
    out[i] = Math.exp(out[i] - most);
    total += out[i];
  }
  for (let i = 0, end_3 = out.length; i < end_3; i++) {
    out[i] /= total;
  }
}
