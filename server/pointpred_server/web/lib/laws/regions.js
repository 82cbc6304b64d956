// Written by `make laws` from regions.py: change that and run it again.
import { hypot, smaller } from "./arithmetic.js";
export const NEARLY_NORMAL = 1e+16;
export const LARGEST_LOG = 700;
export const HALF = 0.5;
export function reach(level, tail) {
  const normal = -2 * Math.log1p(-level);
  if (!(tail < NEARLY_NORMAL)) {
    return normal;
  }
  if (tail <= 0) {
    return NaN;
  }
  if (normal / tail > LARGEST_LOG) {
    return Infinity;
  }
  return tail * Math.expm1(normal / tail);
}
export function ellipse(level, sxx, sxy, syy, tail) {
  const determinant = sxx * syy - sxy * sxy;
  const far = reach(level, tail);
  if (!(sxx > 0 && syy > 0 && (0 < determinant && determinant < Infinity) && far > 0)) {
    return [NaN, NaN, NaN];
  }
  const larger = 0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy);
  const major = Math.sqrt(far * larger);
  const minor = Math.sqrt(far * (determinant / larger));
  if (!Number.isFinite(major)) {
    return [NaN, NaN, NaN];
  }
  return [major, smaller(minor, major), 0.5 * Math.atan2(2 * sxy, sxx - syy)];
}
export function as_normal(sxx, sxy, syy, tail) {
  let factor = reach(HALF, tail) / reach(HALF, NaN);
  if (factor === Infinity) {
    factor = NaN;
  }
  return [factor * sxx, factor * sxy, factor * syy];
}
