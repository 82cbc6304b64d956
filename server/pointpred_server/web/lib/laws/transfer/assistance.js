// Written by `make laws` from assistance.py: change that and run it again.
import { hypot, larger, smaller } from "../arithmetic.js";
import * as $records from "../records.js";
import * as $pixels from "./pixels.js";
export const USUAL_GUARD = [0.5, 0.5, 0.25];
export const SETTINGS = 17;
export const END = 24;
export function pull(rho, strength, dt, own_px, off_x, off_y) {
  const length = hypot(off_x, off_y);
  if (!(0 < length && length < Infinity)) {
    return 0;
  }
  const share = -Math.expm1(-rho * dt);
  return strength < Infinity ? smaller(share, strength * own_px / length) : share;
}
export function spread(way_px, sxx, sxy, syy, unclaimed) {
  if (sxx !== sxx) {
    return unclaimed;
  }
  if (!(Math.abs(sxx) < Infinity && Math.abs(sxy) < Infinity && Math.abs(syy) < Infinity)) {
    return Infinity;
  }
  return Math.sqrt(larger(0.5 * (sxx + syy) + hypot(0.5 * (sxx - syy), sxy), 0)) / way_px;
}
export function guide(guard, dt, own, way, guard_at = 0) {
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
  const trust = 1 - spread(distance, sxx, sxy, syy, guard[guard_at + 4]) / guard[guard_at + 3];
  const to_x = own_x / moved;
  const to_y = own_y / moved;
  const ahead = off_x * to_x + off_y * to_y;
  const beside = off_y * to_x - off_x * to_y;
  if (!(trust > 0 && ahead > 0)) {
    return [0, 0];
  }
  const share = -Math.expm1(-guard[guard_at] * dt);
  const longest = guard[guard_at + 1] * moved;
  const widest = guard[guard_at + 2] * longest;
  const along = trust * smaller(smaller(share * ahead, longest), larger(ahead - moved, 0));
  const across = trust * smaller(larger(share * beside * (ahead / distance), -widest), widest);
  return [along * to_x - across * to_y, along * to_y + across * to_x];
}
export function add(guard, owed, dt, own, way, guard_at = 0, owed_at = 0) {
  const values_1 = guide(guard, dt, own, way, guard_at);
  const x = values_1[0];
  const y = values_1[1];
  const whole_x = $pixels.carry(owed, 0, x, owed_at);
  const whole_y = $pixels.carry(owed, 1, y, owed_at);
  if (whole_x * own[0] + whole_y * own[1] < 0) {
    owed.fill(0, owed_at, owed_at + 2);
    return [0, 0];
  }
  return [whole_x, whole_y];
}
export function guarded_step(memory, report, memory_at = 0) {
  const values_1 = report;
  const t = values_1[0];
  const dx = values_1[1];
  const dy = values_1[2];
  const off_x = values_1[3];
  const off_y = values_1[4];
  const sxx = values_1[5];
  const sxy = values_1[6];
  const syy = values_1[7];
  const values_2 = $pixels.accept(memory, t, dx, dy, memory_at + 5);
  const usable = values_2[0];
  const dt = values_2[1];
  if (!usable || Math.abs(off_x) > $records.LARGEST || Math.abs(off_y) > $records.LARGEST) {
    return [NaN, NaN, NaN, NaN, NaN];
  }
  const scale = $pixels.turn(memory, t, dt, dx, dy, memory_at + 5);
  const own_x = scale * dx;
  const own_y = scale * dy;
  const carried_at = memory_at + 20;
  const x = $pixels.carry(memory, 0, own_x, carried_at);
  const y = $pixels.carry(memory, 1, own_y, carried_at);
  const values_3 = add(memory, memory, dt, [own_x, own_y], [off_x, off_y, sxx, sxy, syy], memory_at, memory_at + 22);
  const add_x = values_3[0];
  const add_y = values_3[1];
  return [t, x + add_x, y + add_y, add_x, add_y];
}
