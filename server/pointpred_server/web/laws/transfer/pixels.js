// Written by `make laws` from pixels.py: change that and run it again.
import { hypot, smaller } from "../arithmetic.js";
import * as $records from "../records.js";
import * as $functions from "./functions.js";
export const PX_PER_COUNT = 0;
export const METRES_PER_COUNT = 1;
export const PERIOD_S = 2;
export const GAP_S = 3;
export const FUNCTION = 4;
export const STARTED = 12;
export const T = 13;
export const GAIN = 14;
export const CARRY = 15;
export const SETTINGS = 12;
export const USUAL_TIMES_S = [0.001, 0.1];
export function carry(memory, at, moved_px) {
  const rest = memory[at] * moved_px >= 0 ? memory[at] : 0;
  const whole = Math.trunc(rest + moved_px);
  memory[at] = rest + moved_px - whole;
  return whole;
}
export function accept(memory, at, t, dx, dy) {
  const fine = Math.abs(t) <= $records.LATEST_S && Math.abs(dx) <= $records.LARGEST && Math.abs(dy) <= $records.LARGEST;
  if (memory[at + STARTED] === 0) {
    return [fine, memory[at + PERIOD_S]];
  }
  return [fine && t >= memory[at + T], smaller(t - memory[at + T], memory[at + GAP_S])];
}
export function turn(memory, at, t, dt, dx, dy) {
  if (dt > 0) {
    const speed = hypot(dx, dy) * memory[at + METRES_PER_COUNT] / dt;
    memory[at + GAIN] = $functions.gain(memory, at + FUNCTION, speed);
  }
  memory[at + STARTED] = 1;
  memory[at + T] = t;
  return memory[at + GAIN] * memory[at + PX_PER_COUNT];
}
export function lay_out(memory, own, device, function_) {
  const cpi = device[0];
  const dpi = device[1];
  const period_s = device[2];
  const gap_s = device[3];
  const at = own.length;
  for (let i = 0; i < at; i++) {
    memory[i] = own[i];
  }
  memory[at + PX_PER_COUNT] = dpi / cpi;
  memory[at + METRES_PER_COUNT] = $records.METRES_PER_INCH / cpi;
  memory[at + PERIOD_S] = period_s;
  memory[at + GAP_S] = gap_s;
  for (let i = 0; i < $functions.SLOTS; i++) {
    memory[at + FUNCTION + i] = function_[i];
  }
}
