// Written by `make page` from rows.py: change that and run it again.
export const REFUSED = [NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN];
export function endpoint(t, x, y, phase) {
  return [t, x, y, NaN, NaN, NaN, NaN, phase, NaN, NaN];
}
