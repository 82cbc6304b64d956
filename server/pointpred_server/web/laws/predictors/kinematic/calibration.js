// Written by `make page` from calibration.py: change that and run it again.
import { larger, smaller } from "../../arithmetic.js";
export const KNOTS = 10;
export const WIDTH = 0;
export const TAIL = 1;
export const SPREAD = 2;
export const FACTORS = 3;
export function factor(coefficients, at, share, which) {
  const place = smaller(larger(share * KNOTS - 0.5, 0), KNOTS - 1);
  const knot = smaller(Math.floor(place), KNOTS - 2);
  const low = coefficients[at + FACTORS * knot + which];
  const high = coefficients[at + FACTORS * (knot + 1) + which];
  return Math.exp(low + (place - knot) * (high - low));
}
