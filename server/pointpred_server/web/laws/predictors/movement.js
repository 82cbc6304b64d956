// Written by `make page` from movement.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $records from "../records.js";
export const STILL_M_S = 0.002;
export const CORRECTIVE_FRACTION = 0.2;
export const NUMBERS = 7;
export const KNOWN = 0;
export const T = 1;
export const X = 2;
export const Y = 3;
export const T0 = 4;
export const X0 = 5;
export const Y0 = 6;
export const PEAK = 7;
export const PATH = 8;
export const STATES = 9;
export const STILL = 0;
export const BALLISTIC = 1;
export const CORRECTIVE = 2;
export function fault_of(memory, at, m) {
  for (let i = 0; i < NUMBERS; i++) {
    if (!(Math.abs(m[i]) <= $records.MOTION_MOST)) {
      return $records.MOTION_FIELD + i;
    }
  }
  return memory[at + KNOWN] === 1 && m[0] < memory[at + T] ? $records.ORDER : $records.FINE;
}
export function refuse(memory, at, m, fault) {
  return $records.refused(fault, fault === $records.ORDER ? memory[at + T] : m[fault - $records.MOTION_FIELD]);
}
export function follow(memory, at, m) {
  const t = m[0];
  const x = m[1];
  const y = m[2];
  const fault = fault_of(memory, at, m);
  if (fault !== $records.FINE) {
    return [fault, false, 0];
  }
  const new_ = m[8] === 1 || memory[at + KNOWN] === 0;
  const dt = new_ ? 0 : t - memory[at + T];
  if (new_ || t === memory[at + T0]) {
    memory[at + T0] = t;
    memory[at + X0] = x;
    memory[at + Y0] = y;
    memory[at + PATH] = 0;
  } else {
    memory[at + PATH] += hypot(x - memory[at + X], y - memory[at + Y]);
  }
  if (new_) {
    memory[at + PEAK] = 0;
  }
  memory[at + KNOWN] = 1;
  memory[at + T] = t;
  memory[at + X] = x;
  memory[at + Y] = y;
  memory[at + PEAK] = larger(memory[at + PEAK], hypot(m[3], m[4]));
  return [$records.FINE, new_, dt];
}
export function phase(memory, at, m) {
  const speed = hypot(m[3], m[4]);
  if (speed < STILL_M_S) {
    return STILL;
  }
  return speed >= CORRECTIVE_FRACTION * memory[at + PEAK] ? BALLISTIC : CORRECTIVE;
}
