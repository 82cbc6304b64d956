// Written by `make page` from rows.py: change that and run it again.
export const REFUSED = [NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN, NaN];
export function event_at(table, i) {
  const r = table[i];
  return [r[0], r[1], r[2], r[3], r[4], r[5]];
}
export function endpoint(t, x, y, phase) {
  return [t, x, y, NaN, NaN, NaN, NaN, phase, NaN, NaN];
}
