// Written by `make page` from regions.py: change that and run it again.
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
export function as_normal(sxx, sxy, syy, tail) {
  let factor = reach(HALF, tail) / reach(HALF, NaN);
  if (factor === Infinity) {
    factor = NaN;
  }
  return [factor * sxx, factor * sxy, factor * syy];
}
