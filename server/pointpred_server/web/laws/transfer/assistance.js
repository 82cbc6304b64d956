// Written by `make laws` from assistance.py: change that and run it again.
import { hypot, larger, smaller } from "../arithmetic.js";
import * as $records from "../records.js";
import * as $pixels from "./pixels.js";
export const RHO = 0;
export const STRENGTH = 1;
export const SIDEWAYS = 2;
export const UNCERTAIN = 3;
export const UNCLAIMED = 4;
export const GUARDED = 5;
export const OWED = 22;
export const END = 24;
export const USUAL_GUARD = [0.5, 0.5, 0.25];
export function spread(way_px, sxx, sxy, syy, unclaimed) {
  if (sxx !== sxx) {
    return unclaimed;
  }
  if (!(Math.abs(sxx) < Infinity && Math.abs(sxy) < Infinity && Math.abs(syy) < Infinity)) {
    return Infinity;
  }
  return Math.sqrt(larger(0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy), 0)) / way_px;
}
export function guide(memory, at, dt, own, way) {
  const own_x = own[0];
  const own_y = own[1];
  const off_x = way[0];
  const off_y = way[1];
  const sxx = way[2];
  const sxy = way[3];
  const syy = way[4];
  const moved = hypot(own_x, own_y);
  const distance = hypot(off_x, off_y);
  if (!((0 < moved && moved < Infinity) && (0 < distance && distance < Infinity))) {
    return [0, 0];
  }
  const trust = 1 - spread(distance, sxx, sxy, syy, memory[at + UNCLAIMED]) / memory[at + UNCERTAIN];
  const to_x = own_x / moved;
  const to_y = own_y / moved;
  const ahead = off_x * to_x + off_y * to_y;
  const beside = off_y * to_x - off_x * to_y;
  if (!(trust > 0 && ahead > 0)) {
    return [0, 0];
  }
  const share = -Math.expm1(-memory[at + RHO] * dt);
  const longest = memory[at + STRENGTH] * moved;
  const widest = memory[at + SIDEWAYS] * longest;
  const along = trust * smaller(smaller(share * ahead, longest), larger(ahead - moved, 0));
  const across = trust * smaller(larger(share * beside * (ahead / distance), -widest), widest);
  return [along * to_x - across * to_y, along * to_y + across * to_x];
}
export function add(memory, at, owed, dt, own, way) {
  const values_1 = guide(memory, at, dt, own, way);
  const x = values_1[0];
  const y = values_1[1];
  const whole_x = $pixels.carry(memory, owed, x);
  const whole_y = $pixels.carry(memory, owed + 1, y);
  if (whole_x * own[0] + whole_y * own[1] < 0) {
    memory[owed] = memory[owed + 1] = 0;
    return [0, 0];
  }
  return [whole_x, whole_y];
}
export function guarded_step(memory, report) {
  const values_1 = report;
  const t = values_1[0];
  const dx = values_1[1];
  const dy = values_1[2];
  const off_x = values_1[3];
  const off_y = values_1[4];
  const sxx = values_1[5];
  const sxy = values_1[6];
  const syy = values_1[7];
  const values_2 = $pixels.accept(memory, GUARDED, t, dx, dy);
  const usable = values_2[0];
  const dt = values_2[1];
  if (!usable || Math.abs(off_x) > $records.LARGEST || Math.abs(off_y) > $records.LARGEST) {
    return [NaN, NaN, NaN, NaN, NaN];
  }
  const scale = $pixels.turn(memory, GUARDED, t, dt, dx, dy);
  const own_x = scale * dx;
  const own_y = scale * dy;
  const carried = GUARDED + $pixels.CARRY;
  const x = $pixels.carry(memory, carried, own_x);
  const y = $pixels.carry(memory, carried + 1, own_y);
  const values_3 = add(memory, 0, OWED, dt, [own_x, own_y], [off_x, off_y, sxx, sxy, syy]);
  const add_x = values_3[0];
  const add_y = values_3[1];
  return [t, x + add_x, y + add_y, add_x, add_y];
}
