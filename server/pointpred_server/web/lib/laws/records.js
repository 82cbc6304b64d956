// Written by `make laws` from records.py: change that and run it again.
export const LATEST_S = 100000000000;
export const LARGEST = 1000000000;
export const MOTION_MOST = 1e+300;
export const METRES_PER_INCH = 0.0254;
export const ROUNDING_S = 1e-06;
export const FINE = 0;
export const ORDER = 1;
export const EVENT_FIELD = 2;
export const MOTION_FIELD = 8;
export function refused(code, value) {
  return [NaN, code, value, NaN, NaN, NaN, NaN, NaN, NaN, NaN];
}
export function fault_of_event(event) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const dx = event[3];
  const dy = event[4];
  const buttons = event[5];
  if (!(Math.abs(t) <= LATEST_S)) {
    return EVENT_FIELD;
  }
  if (!(Math.abs(x) <= LARGEST)) {
    return EVENT_FIELD + 1;
  }
  if (!(Math.abs(y) <= LARGEST)) {
    return EVENT_FIELD + 2;
  }
  if (!(dx !== dx && dy !== dy)) {
    if (!(Math.abs(dx) <= LARGEST)) {
      return EVENT_FIELD + 3;
    }
    if (!(Math.abs(dy) <= LARGEST)) {
      return EVENT_FIELD + 4;
    }
  }
  if (!((0 <= buttons && buttons <= LARGEST) && buttons === Math.floor(buttons))) {
    return EVENT_FIELD + 5;
  }
  return FINE;
}
export function event_at(table, i) {
  const r = table[i];
  return [r[0], r[1], r[2], r[3], r[4], r[5]];
}
export function endpoint(t, x, y, phase) {
  return [t, x, y, NaN, NaN, NaN, NaN, phase, NaN, NaN];
}
