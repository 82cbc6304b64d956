// Written by `make laws` from endpoint.py: change that and run it again.
import { hypot, larger, square } from "../arithmetic.js";
import * as $posterior from "./posterior.js";
import * as $rectangles from "./rectangles.js";
export const WIDER = 2;
export const NARROWEST = 0.25;
export const NEGLIGIBLE = 0.001;
export const STEPS = 8;
export const LEAST_PX2 = 1;
export const RADII2 = 0.5;
export const TAIL = 3;
export function elsewhere(s, answer, s_at = 0) {
  const x = answer[1];
  const y = answer[2];
  let sxx = answer[3];
  let sxy = answer[4];
  let syy = answer[5];
  const tail = answer[8];
  const stated = [x, y, sxx, sxy, syy, tail];
  if ($posterior.lawful(stated)) {
    return stated;
  }
  const values_1 = $posterior.unclaimed(s, x, y, s_at);
  sxx = values_1[0];
  sxy = values_1[1];
  syy = values_1[2];
  return [x, y, sxx, sxy, syy, NaN];
}
export function write_target(row, predicted, share, part, part_at = 0) {
  let a, b, c;
  const x = predicted[0];
  const y = predicted[1];
  const sxx = predicted[2];
  const sxy = predicted[3];
  const syy = predicted[4];
  const tail = predicted[5];
  const across = square(row[$rectangles.WIDTH] / $posterior.EFFECTIVE);
  const down = square(row[$rectangles.HEIGHT] / $posterior.EFFECTIVE);
  const dx = x - row[$rectangles.CENTRE_X];
  const dy = y - row[$rectangles.CENTRE_Y];
  const least_x = (1 + NARROWEST) * across;
  const least_y = (1 + NARROWEST) * down;
  let wide = WIDER;
  if (tail === tail) {
    a = wide * sxx + least_x;
    b = wide * sxy;
    c = wide * syy + least_y;
    const far2 = (c * dx * dx - 2 * b * dx * dy + a * dy * dy) / (a * c - b * b);
    wide *= (tail + far2) / (tail + 2);
  }
  a = wide * sxx + least_x;
  b = wide * sxy;
  c = wide * syy + least_y;
  const scaled = 1 / (a * c - b * b);
  part[part_at] = share;
  part[part_at + 1] = row[$rectangles.CENTRE_X] + across * (c * dx - b * dy) * scaled;
  part[part_at + 2] = row[$rectangles.CENTRE_Y] + down * (a * dy - b * dx) * scaled;
  part[part_at + 3] = across - across * across * c * scaled;
  part[part_at + 4] = across * down * b * scaled;
  part[part_at + 5] = down - down * down * a * scaled;
  part[part_at + 6] = 0;
}
export function mixture(table, shares, predicted, least, out) {
  let count = 1;
  let rest = 1;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    if (shares[i] >= least) {
      write_target(table[i], predicted, shares[i], out[count]);
      rest -= shares[i];
      count += 1;
    }
  }
  const first_at = 0;
  out[0][first_at] = larger(rest, 0);
  out[0][first_at + 1] = predicted[0];
  out[0][first_at + 2] = predicted[1];
  out[0][first_at + 3] = predicted[2];
  out[0][first_at + 4] = predicted[3];
  out[0][first_at + 5] = predicted[4];
  out[0][first_at + 6] = predicted[5] === predicted[5] ? predicted[5] : 0;
  return count;
}
export function geometric_median(parts, count) {
  let part_at;
  let x = 0;
  let y = 0;
  for (let k = 0; k < count; k++) {
    part_at = 0;
    x += parts[k][part_at] * parts[k][part_at + 1];
    y += parts[k][part_at] * parts[k][part_at + 2];
  }
  for (let _ = 0; _ < STEPS; _++) {
    let sum_x = 0;
    let sum_y = 0;
    let total = 0;
    for (let k = 0; k < count; k++) {
      part_at = 0;
      const dx = parts[k][part_at + 1] - x;
      const dy = parts[k][part_at + 2] - y;
      const weight = parts[k][part_at] / Math.sqrt(dx * dx + dy * dy + larger(0.5 * (parts[k][part_at + 3] + parts[k][part_at + 5]), LEAST_PX2));
      sum_x += weight * parts[k][part_at + 1];
      sum_y += weight * parts[k][part_at + 2];
      total += weight;
    }
    x = sum_x / total;
    y = sum_y / total;
  }
  return [x, y];
}
export function ellipse(parts, count, centre, way) {
  const x = centre[0];
  const y = centre[1];
  const size = hypot(way[0], way[1]);
  const values_1 = size > 0 ? [way[0] / size, way[1] / size] : [1, 0];
  const ux = values_1[0];
  const uy = values_1[1];
  let wide = 0;
  let broad = 0;
  for (let k = 0; k < count; k++) {
    const part_at = 0;
    const dx = parts[k][part_at + 1] - x;
    const dy = parts[k][part_at + 2] - y;
    const along = dx * ux + dy * uy;
    const across = dy * ux - dx * uy;
    const cross = 2 * parts[k][part_at + 4] * ux * uy;
    wide += parts[k][part_at] * Math.sqrt(along * along + parts[k][part_at + 3] * ux * ux + cross + parts[k][part_at + 5] * uy * uy);
    broad += parts[k][part_at] * Math.sqrt(across * across + parts[k][part_at + 3] * uy * uy - cross + parts[k][part_at + 5] * ux * ux);
  }
  const wide2 = RADII2 * wide * wide;
  const broad2 = RADII2 * broad * broad;
  const sxx = wide2 * ux * ux + broad2 * uy * uy;
  const syy = wide2 * uy * uy + broad2 * ux * ux;
  return [x, y, sxx, (wide2 - broad2) * ux * uy, syy, TAIL];
}
