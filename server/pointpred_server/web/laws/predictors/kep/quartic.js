// Written by `make page` from quartic.py: change that and run it again.
import { larger, smaller } from "../../arithmetic.js";
export const STEPS_MOST = 80;
export function value(p, w) {
  return p[0] + w * (p[1] + w * (p[2] + w * (p[3] + w * p[4])));
}
export function derivative(p) {
  return [p[1], 2 * p[2], 3 * p[3], 4 * p[4], 0];
}
export function bend(p, far) {
  const a = 6 * p[4];
  const b = 3 * p[3];
  const c = p[2];
  const discriminant = b * b - 4 * a * c;
  if (discriminant < 0) {
    return [far, far];
  }
  const half = -0.5 * (b + (b >= 0 ? Math.sqrt(discriminant) : -Math.sqrt(discriminant)));
  let one = a !== 0 ? half / a : far;
  let other = half !== 0 ? c / half : far;
  one = 0 < one && one < far ? one : far;
  other = 0 < other && other < far ? other : far;
  return [smaller(one, other), larger(one, other)];
}
export function between(p, low, high) {
  const at_low = value(p, low);
  if (!(at_low * value(p, high) < 0)) {
    return high;
  }
  let w = 0.5 * (low + high);
  for (let _ = 0; _ < STEPS_MOST; _++) {
    const here = value(p, w);
    if (here === 0) {
      return w;
    }
    if ((here > 0) === (at_low > 0)) {
      low = w;
    } else {
      high = w;
    }
    const slope = p[1] + w * (2 * p[2] + w * (3 * p[3] + w * 4 * p[4]));
    let new_ = slope !== 0 ? w - here / slope : low;
    if (!(low < new_ && new_ < high)) {
      new_ = 0.5 * (low + high);
    }
    if (Math.abs(new_ - w) <= 1e-13 * Math.abs(w)) {
      return new_;
    }
    w = new_;
  }
  return w;
}
export function first_zero(p, far) {
  if (!(p[0] > 0)) {
    return NaN;
  }
  const values_1 = bend(p, far);
  const bend_1 = values_1[0];
  const bend_2 = values_1[1];
  const bounds = [bend_1, bend_2, far];
  const slope = derivative(p);
  let left = 0;
  for (let i = 0; i < 3; i++) {
    const turn = between(slope, left, bounds[i]);
    if (value(p, turn) <= 0) {
      return between(p, left, turn);
    }
    if (value(p, bounds[i]) <= 0) {
      return between(p, turn, bounds[i]);
    }
    left = bounds[i];
  }
  return NaN;
}
