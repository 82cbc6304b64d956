// Written by `make laws` from mixture.py: change that and run it again.
import { larger, matrix, smaller } from "../arithmetic.js";
export const TURN_COS = -0.7373688780783197;
export const TURN_SIN = 0.6754902942615238;
export const LEVELS = [0.5, 0.8];
export const HEAVINESS_LEAST = 1e-06;
export const HEAVINESS_MOST = 40;
export const PROBABILITY_MOST = 0.999999999;
export function squared_radius(share, tail) {
  const normal = -2 * Math.log1p(-share);
  return Number(tail === 0 ? normal : tail * Math.expm1(normal / tail));
}
export function part_density(part, x, y, part_at = 0) {
  const sxx = part[part_at + 3];
  const sxy = part[part_at + 4];
  const syy = part[part_at + 5];
  const tail = part[part_at + 6];
  const determinant = sxx * syy - sxy * sxy;
  const dx = x - part[part_at + 1];
  const dy = y - part[part_at + 2];
  const far = (syy * dx * dx - 2 * sxy * dx * dy + sxx * dy * dy) / determinant;
  const log_density = tail === 0 ? -0.5 * far : -0.5 * (tail + 2) * Math.log1p(far / tail);
  return part[part_at] * Math.exp(log_density) / (2 * Math.PI * Math.sqrt(determinant));
}
export function density(parts, count, x, y) {
  let total = 0;
  for (let k = 0; k < count; k++) {
    total += part_density(parts[k], x, y);
  }
  return total;
}
export function densities(parts, count, points, out) {
  for (let k = 0; k < count; k++) {
    const part_at = 0;
    const wide = Math.sqrt(parts[k][part_at + 3]);
    const slant = parts[k][part_at + 4] / wide;
    const broad = Math.sqrt(parts[k][part_at + 5] - slant * slant);
    let cos = 1;
    let sin = 0;
    for (let i = 0; i < points; i++) {
      const radius = Math.sqrt(squared_radius((i + 0.5) / points, parts[k][part_at + 6]));
      const x = parts[k][part_at + 1] + radius * wide * cos;
      const y = parts[k][part_at + 2] + radius * (slant * cos + broad * sin);
      out[k][i] = density(parts, count, x, y);
      const value_1 = cos * TURN_COS - sin * TURN_SIN;
      const value_2 = cos * TURN_SIN + sin * TURN_COS;
      cos = value_1;
      sin = value_2;
    }
  }
}
export function share_above(parts, count, points, known, threshold) {
  let total = 0;
  for (let k = 0; k < count; k++) {
    let above = 0;
    for (let i = 0; i < points; i++) {
      above += known[k][i] > threshold ? 1 : 0;
    }
    total += parts[k][0] * above / points;
  }
  return total;
}
export function content(parts, count, x, y, points) {
  if (count === 1) {
    const part_at = 0;
    const own = part_density(parts[0], x, y, part_at);
    const best = part_density(parts[0], parts[0][part_at + 1], parts[0][part_at + 2], part_at);
    const power = parts[0][part_at + 6] === 0 ? 1 : parts[0][part_at + 6] / (parts[0][part_at + 6] + 2);
    return 1 - Math.pow(own / best, power);
  }
  const known = matrix(count, points);
  densities(parts, count, points, known);
  return share_above(parts, count, points, known, density(parts, count, x, y));
}
export function squared_radius_over_tail(level, heavy) {
  return Math.exp(-heavy * Math.log(1 - level)) - 1;
}
export function corrected_radius(level, heavy, offset) {
  const lower = Math.exp(smaller(offset, 0));
  return Math.exp(larger(offset, 0)) * (Math.exp(-heavy * Math.log(1 - level) * lower) - 1);
}
export function heaviness(tail) {
  return smaller(larger(2 / tail, HEAVINESS_LEAST), HEAVINESS_MOST);
}
export function corrected_probability(level, tail, near, far) {
  const radius = Math.log(-Math.log(1 - level));
  const half = Math.log(-Math.log(1 - LEVELS[0]));
  const most = Math.log(-Math.log(1 - LEVELS[1]));
  const part = smaller(larger((radius - half) / (most - half), 0), 1);
  const heavy = heaviness(tail);
  let own = corrected_radius(level, heavy, near + part * (far - near));
  if (level > LEVELS[0]) {
    own = larger(own, corrected_radius(LEVELS[0], heavy, near));
  }
  return smaller(1 - Math.exp(-Math.log(1 + own) / heavy), PROBABILITY_MOST);
}
