// Written by `make laws` from rectangle_mass.py: change that and run it again.
import { smaller, square } from "../arithmetic.js";
export const EFFECTIVE = 4.133;
export const NODES = [-0.906179845938664, -0.5384693101056831, 0, 0.5384693101056831, 0.906179845938664];
export const WEIGHTS = [0.23692688505618928, 0.4786286704993663, 0.5688888888888887, 0.4786286704993663, 0.23692688505618928];
export const PLACES = [-0.7745966692414834, 0, 0.7745966692414834, -0.8611363115940526, -0.33998104358485626, 0.33998104358485626, 0.8611363115940526, -0.906179845938664, -0.5384693101056831, 0, 0.5384693101056831, 0.906179845938664];
export const SHARES = [0.5555555555555557, 0.8888888888888888, 0.5555555555555557, 0.34785484513745357, 0.6521451548625464, 0.6521451548625464, 0.34785484513745357, 0.23692688505618928, 0.4786286704993663, 0.5688888888888887, 0.4786286704993663, 0.23692688505618928];
export const BEGINS = [0, 0, 0, 0, 3, 7];
export const OUTER = 0.906179845938664;
export const INNER = 0.5384693101056831;
export const W_OUTER = 0.23692688505618928;
export const W_INNER = 0.4786286704993663;
export const W_MIDDLE = 0.5688888888888887;
export const NEGLIGIBLE = -40;
export const STEEPEST = 300;
export const FLAT3 = 16;
export const FLAT4 = 6;
export const HEAVIEST = 8;
export function log_density(far, tail) {
  if (tail !== tail) {
    return -0.5 * far;
  }
  return -0.5 * (tail + 2) * Math.log(1 + far / tail);
}
export function node_sum(distance, tail) {
  let here, u, v;
  const far = distance[0];
  const gx = distance[1];
  const gy = distance[2];
  const gxy = distance[3];
  const hx = distance[4];
  const hy = distance[5];
  let nearest = Infinity;
  for (let i = 0; i < 5; i++) {
    u = NODES[i];
    for (let j = 0; j < 5; j++) {
      v = NODES[j];
      here = far + 2 * (u * gx + v * gy + u * v * gxy) + u * u * hx + v * v * hy;
      nearest = smaller(nearest, here);
    }
  }
  const top = log_density(nearest, tail);
  let total = 0;
  for (let i = 0; i < 5; i++) {
    u = NODES[i];
    for (let j = 0; j < 5; j++) {
      v = NODES[j];
      here = far + 2 * (u * gx + v * gy + u * v * gxy) + u * u * hx + v * v * hy;
      const less = log_density(here, tail) - top;
      if (less > NEGLIGIBLE) {
        total += WEIGHTS[i] * WEIGHTS[j] * Math.exp(less);
      }
    }
  }
  return Math.log(total) + top;
}
export function enough(half2, tail) {
  if (FLAT3 * half2 < tail) {
    return 3;
  }
  return FLAT4 * half2 < tail ? 4 : 5;
}
export function student_sum(distance, tail) {
  const far = distance[0];
  const gx = distance[1];
  const gy = distance[2];
  const gxy = distance[3];
  const hx = distance[4];
  const hy = distance[5];
  const power = -0.5 * (tail + 2);
  const whole = 1 / (tail + far);
  const across = enough(hy, tail);
  const along = enough(hx, tail);
  let total = 0;
  for (let i = BEGINS[along], end_1 = BEGINS[along] + along; i < end_1; i++) {
    const u = PLACES[i];
    let part = 0;
    const fixed = 1 + whole * (2 * u * gx + u * u * hx);
    const slope = 2 * whole * (gy + u * gxy);
    for (let j = BEGINS[across], end_2 = BEGINS[across] + across; j < end_2; j++) {
      const v = PLACES[j];
      part += SHARES[j] * Math.exp(power * Math.log(fixed + v * (slope + v * whole * hy)));
    }
    total += SHARES[i] * part;
  }
  return Math.log(total) + log_density(far, tail);
}
export function normal_sum(distance) {
  const gx = distance[1];
  const gy = distance[2];
  const gxy = distance[3];
  const hx = distance[4];
  const hy = distance[5];
  const xo = W_OUTER * Math.exp(-0.5 * OUTER * OUTER * hx);
  const xi = W_INNER * Math.exp(-0.5 * INNER * INNER * hx);
  const yo = W_OUTER * Math.exp(-0.5 * OUTER * OUTER * hy);
  const yi = W_INNER * Math.exp(-0.5 * INNER * INNER * hy);
  const po = Math.exp(OUTER * gx);
  const pi_ = Math.exp(INNER * gx);
  const qo = Math.exp(OUTER * gy);
  const qi = Math.exp(INNER * gy);
  const oo = Math.exp(-OUTER * OUTER * gxy);
  const oi = Math.exp(-OUTER * INNER * gxy);
  const ii = Math.exp(-INNER * INNER * gxy);
  const x1 = xo * po;
  const x2 = xi * pi_;
  const x4 = xi / pi_;
  const x5 = xo / po;
  const y1 = yo * qo;
  const y2 = yi * qi;
  const y4 = yi / qi;
  const y5 = yo / qo;
  const outer = (x1 * y1 + x5 * y5) * oo + (x1 * y5 + x5 * y1) / oo;
  const between = (x1 * y2 + x5 * y4 + x2 * y1 + x4 * y5) * oi + (x1 * y4 + x5 * y2 + x2 * y5 + x4 * y1) / oi;
  const inner = (x2 * y2 + x4 * y4) * ii + (x2 * y4 + x4 * y2) / ii;
  const cross = W_MIDDLE * (x1 + x2 + x4 + x5 + y1 + y2 + y4 + y5 + W_MIDDLE);
  return Math.log(outer + between + inner + cross);
}
export function log_mass(rectangle, spread) {
  let total;
  const dx = rectangle[0];
  const dy = rectangle[1];
  const width = rectangle[2];
  const height = rectangle[3];
  let sxx = spread[0];
  const sxy = spread[1];
  let syy = spread[2];
  const tail = spread[3];
  sxx += square(width / EFFECTIVE);
  syy += square(height / EFFECTIVE);
  const det = sxx * syy - sxy * sxy;
  const a = 0.5 * width;
  const b = 0.5 * height;
  const ixx = syy / det;
  const ixy = -sxy / det;
  const iyy = sxx / det;
  const far = ixx * dx * dx + 2 * ixy * dx * dy + iyy * dy * dy;
  const gx = a * (ixx * dx + ixy * dy);
  const gy = b * (ixy * dx + iyy * dy);
  const gxy = a * b * ixy;
  const hx = ixx * a * a;
  const hy = iyy * b * b;
  const distance = [far, gx, gy, gxy, hx, hy];
  if (tail !== tail && Math.abs(gx) + Math.abs(gy) + Math.abs(gxy) + hx + hy < STEEPEST) {
    total = normal_sum(distance) - 0.5 * far;
  } else if (tail <= HEAVIEST) {
    total = student_sum(distance, tail);
  } else {
    total = node_sum(distance, tail);
  }
  return total + Math.log(0.25 * width * height / (2 * Math.PI * Math.sqrt(det)));
}
