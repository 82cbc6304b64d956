// Written by `make page` from levels.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
export const LEVELS = [0.5, 0.8];
export const LOWEST = 1e-06;
export const HIGHEST = 40;
export const MOST = 0.999999999;
export function squared_radius(level, heavy) {
  return Math.exp(-heavy * Math.log(1 - level)) - 1;
}
export function corrected_radius(level, heavy, offset) {
  const lower = Math.exp(smaller(offset, 0));
  return Math.exp(larger(offset, 0)) * (Math.exp(-heavy * Math.log(1 - level) * lower) - 1);
}
export function heaviness(tail) {
  return smaller(larger(2 / tail, LOWEST), HIGHEST);
}
export function probability(level, tail, near, far) {
  const radius = Math.log(-Math.log(1 - level));
  const half = Math.log(-Math.log(1 - LEVELS[0]));
  const most = Math.log(-Math.log(1 - LEVELS[1]));
  const part = smaller(larger((radius - half) / (most - half), 0), 1);
  const heavy = heaviness(tail);
  let own = corrected_radius(level, heavy, near + part * (far - near));
  if (level > LEVELS[0]) {
    own = larger(own, corrected_radius(LEVELS[0], heavy, near));
  }
  return smaller(1 - Math.exp(-Math.log(1 + own) / heavy), MOST);
}
