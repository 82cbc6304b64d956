// Written by `make laws` from pixels.py: change that and run it again.
import { hypot, smaller } from "../arithmetic.js";
import * as $records from "../records.js";
import * as $functions from "./functions.js";
export const USUAL_TIMES_S = [0.001, 0.1];
export function carry(carried, axis, moved_px, carried_at = 0) {
  const rest = carried[carried_at + axis] * moved_px >= 0 ? carried[carried_at + axis] : 0;
  const whole = Math.trunc(rest + moved_px);
  carried[carried_at + axis] = rest + moved_px - whole;
  return whole;
}
/** @returns {[boolean, number]} */
export function accept(memory, t, dx, dy, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 12;
  const fine = Math.abs(t) <= $records.LATEST_S && Math.abs(dx) <= $records.LARGEST && Math.abs(dy) <= $records.LARGEST;
  if (memory[s_at] === 0) {
    return [fine, memory[settings_at + 2]];
  }
  return [fine && t >= memory[s_at + 1], smaller(t - memory[s_at + 1], memory[settings_at + 3])];
}
export function turn(memory, t, dt, dx, dy, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 12;
  if (dt > 0) {
    const speed = hypot(dx, dy) * memory[settings_at + 1] / dt;
    memory[s_at + 2] = $functions.gain(memory, speed, settings_at + 4);
  }
  memory[s_at] = 1;
  memory[s_at + 1] = t;
  return memory[s_at + 2] * memory[settings_at];
}
export function lay_out(memory, own, device, function_, function_at = 0) {
  const cpi = device[0];
  const dpi = device[1];
  const period_s = device[2];
  const gap_s = device[3];
  for (let i = 0, end_1 = own.length; i < end_1; i++) {
    memory[i] = own[i];
  }
  const settings_at = own.length;
  memory[settings_at] = dpi / cpi;
  memory[settings_at + 1] = $records.METRES_PER_INCH / cpi;
  memory[settings_at + 2] = period_s;
  memory[settings_at + 3] = gap_s;
  memory[settings_at + 4] = function_[function_at];
  for (let i = 0; i < 7; i++) {
    memory[settings_at + i + 5] = function_[function_at + i + 1];
  }
}
