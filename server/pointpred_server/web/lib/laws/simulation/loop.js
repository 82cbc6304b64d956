// Written by `make laws` from loop.py: change that and run it again.
import { hypot, larger, remainder, square } from "../arithmetic.js";
import * as $assistance from "../transfer/assistance.js";
import * as $functions from "../transfer/functions.js";
import * as $pixels from "../transfer/pixels.js";
export const QUADRATURE = 16;
export const BISECTIONS = 40;
export const LONGEST_M = 2;
export const WAITING = 0;
export const BALLISTIC = 1;
export const CORRECTIVE = 2;
export const VERIFYING = 3;
export const PRESSING = 4;
export const DONE = 5;
export const PIECES_MOST = 4;
export const RING_ROWS = 256;
export const WANDER_S = 0.03;
export const NEAR_SHARE = 0.85;
export const SLOW_M_S = 0.008;
export const WORTHWHILE_PX = 10;
export function profile(u, skew) {
  if (u < 0) {
    return [0, 0, 0];
  }
  if (u > 1) {
    return [1, 0, 0];
  }
  const s = Math.PI * (u + skew * u * (1 - u));
  const rate = Math.PI * (1 + skew * (1 - 2 * u));
  const speed = 0.5 * Math.sin(s) * rate;
  return [0.5 * (1 - Math.cos(s)), speed, 0.5 * (Math.cos(s) * rate * rate - 2 * Math.PI * skew * Math.sin(s))];
}
export function cursor_distance(settings, amplitude, duration, settings_at = 0) {
  const peak = 0.5 * Math.PI * amplitude / duration;
  let total = 0;
  for (let i = 1; i < QUADRATURE; i++) {
    const weight = remainder(i, 2) === 1 ? 4 : 2;
    total += weight * $functions.cursor_speed(settings, peak * Math.sin(Math.PI * i / QUADRATURE), settings_at + 6);
  }
  return settings[settings_at + 2] * duration * total / (3 * QUADRATURE);
}
export function hand_distance(settings, distance_px, duration, settings_at = 0) {
  let low = 0;
  let high = LONGEST_M;
  for (let _ = 0; _ < BISECTIONS; _++) {
    const middle = 0.5 * (low + high);
    if (cursor_distance(settings, middle, duration, settings_at) < distance_px) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return 0.5 * (low + high);
}
export function ballistic_force(memory, t, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const piece_at = settings_at + Math.trunc(memory[s_at + 3]) * 6 + 31;
  const duration = memory[piece_at + 1];
  const curve = memory[piece_at + 4];
  const values_1 = profile((t - memory[s_at + 2]) / duration, memory[piece_at + 2]);
  const share = values_1[0];
  const rate = values_1[1];
  const bend = values_1[2];
  const speed = memory[s_at + 4] * rate / duration;
  const along = memory[s_at + 4] * bend / (duration * duration) + memory[settings_at + 14] * speed;
  const across = -2 * curve * (rate / duration) * speed;
  const angle = memory[s_at + 5] + curve * (1 - 2 * share);
  return [along * Math.cos(angle) - across * Math.sin(angle), along * Math.sin(angle) + across * Math.cos(angle)];
}
export function cursor_in_mind(memory, u, v, speed, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const late = Math.trunc(memory[settings_at + 18] / memory[settings_at] + 0.5);
  const seen_at = s_at + remainder(Math.trunc(memory[s_at]) - late, RING_ROWS) * 4 + 23;
  const gain = $functions.gain(memory, speed, settings_at + 6) * memory[settings_at + 2];
  return [memory[seen_at] + gain * (u - memory[seen_at + 2]), memory[seen_at + 1] + gain * (v - memory[seen_at + 3])];
}
export function acceleration(memory, t, place, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  let x = place[0];
  let y = place[1];
  const u = place[2];
  const v = place[3];
  const vx = place[4];
  const vy = place[5];
  const b1 = memory[settings_at + 14];
  if (memory[s_at + 1] === BALLISTIC) {
    const values_1 = ballistic_force(memory, t, memory_at);
    const along_x = values_1[0];
    const along_y = values_1[1];
    return [along_x - b1 * vx, along_y - b1 * vy];
  }
  if (memory[s_at + 1] !== CORRECTIVE) {
    return [-b1 * vx, -b1 * vy];
  }
  if (memory[settings_at + 3] > 0) {
    const values_2 = cursor_in_mind(memory, u, v, hypot(vx, vy), memory_at);
    x = values_2[0];
    y = values_2[1];
  }
  const b2 = memory[s_at + 6];
  return [-b1 * vx - b2 * (x - memory[settings_at + 24]), -b1 * vy - b2 * (y - memory[settings_at + 25])];
}
export function cursor_rate(settings, vx, vy, settings_at = 0) {
  const scale = settings[settings_at + 2] * $functions.gain(settings, hypot(vx, vy), settings_at + 6);
  return [scale * vx, scale * vy];
}
export function advance(memory, t, h, extra_x, extra_y, memory_at = 0) {
  let dx, dy;
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const keep = memory[settings_at + 17] > 0 ? Math.exp(-0.5 * h / memory[settings_at + 17]) : 0;
  const u = memory[s_at + 7];
  const v = memory[s_at + 8];
  const vx = memory[s_at + 9];
  const vy = memory[s_at + 10];
  let x = memory[s_at + 15];
  let y = memory[s_at + 16];
  const continuous = memory[settings_at + 3] === 0;
  const values_1 = acceleration(memory, t, [x, y, u, v, vx, vy], memory_at);
  let ax = values_1[0];
  let ay = values_1[1];
  ax = ax + keep * (memory[s_at + 11] - ax);
  ay = ay + keep * (memory[s_at + 12] - ay);
  const middle_x = vx + 0.5 * h * ax;
  const middle_y = vy + 0.5 * h * ay;
  if (continuous) {
    const values_2 = cursor_rate(memory, vx + extra_x, vy + extra_y, settings_at);
    dx = values_2[0];
    dy = values_2[1];
    x = x + 0.5 * h * dx;
    y = y + 0.5 * h * dy;
  }
  const middle_u = u + 0.5 * h * vx;
  const middle_v = v + 0.5 * h * vy;
  const values_3 = acceleration(memory, t + 0.5 * h, [x, y, middle_u, middle_v, middle_x, middle_y], memory_at);
  let bx = values_3[0];
  let by = values_3[1];
  bx = bx + keep * (ax - bx);
  by = by + keep * (ay - by);
  memory[s_at + 11] = bx;
  memory[s_at + 12] = by;
  memory[s_at + 9] = vx + h * bx;
  memory[s_at + 10] = vy + h * by;
  memory[s_at + 7] = u + h * (middle_x + extra_x);
  memory[s_at + 8] = v + h * (middle_y + extra_y);
  if (continuous) {
    const values_4 = cursor_rate(memory, middle_x + extra_x, middle_y + extra_y, settings_at);
    dx = values_4[0];
    dy = values_4[1];
    memory[s_at + 15] += h * dx;
    memory[s_at + 16] += h * dy;
  }
}
export function count(position_m, metres_per_count, counted) {
  return Math.trunc(position_m / metres_per_count - counted);
}
export function assist(memory, own_px, hat_x, hat_y, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const off_x = hat_x - memory[s_at + 15];
  const off_y = hat_y - memory[s_at + 16];
  const rho = memory[settings_at + 4];
  const strength = memory[settings_at + 5];
  const share = $assistance.pull(rho, strength, memory[settings_at], own_px, off_x, off_y);
  return share > 0 ? [share * off_x, share * off_y] : [0, 0];
}
export function report(memory, hat_x, hat_y, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const unit = memory[settings_at + 3];
  const dx = count(memory[s_at + 7], unit, memory[s_at + 17]);
  const dy = count(memory[s_at + 8], unit, memory[s_at + 18]);
  memory[s_at + 17] += dx;
  memory[s_at + 18] += dy;
  const gain = $functions.gain(memory, hypot(dx, dy) * unit / memory[settings_at], settings_at + 6);
  const scale = gain * memory[settings_at + 2] * unit;
  const values_1 = assist(memory, scale * hypot(dx, dy), hat_x, hat_y, memory_at);
  const pull_x = values_1[0];
  const pull_y = values_1[1];
  memory[s_at + 15] += $pixels.carry(memory, 0, scale * dx, s_at + 19);
  memory[s_at + 16] += $pixels.carry(memory, 1, scale * dy, s_at + 19);
  memory[s_at + 15] += $pixels.carry(memory, 0, pull_x, s_at + 21);
  memory[s_at + 16] += $pixels.carry(memory, 1, pull_y, s_at + 21);
  return [dx, dy];
}
export function enter(s, phase, t, s_at = 0) {
  s[s_at + 1] = phase;
  s[s_at + 2] = t;
}
export function correct(memory, t, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  enter(memory, CORRECTIVE, t, s_at);
  memory[s_at + 6] = memory[settings_at + 15];
  if (memory[settings_at + 15] === 0) {
    const gain = $functions.gain(memory, 0.5 * hypot(memory[s_at + 9], memory[s_at + 10]), settings_at + 6);
    memory[s_at + 6] = square(memory[settings_at + 16]) / (gain * memory[settings_at + 2]);
  }
}
export function launch(memory, number, t, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const way_x = memory[settings_at + 24] - memory[s_at + 15];
  const way_y = memory[settings_at + 25] - memory[s_at + 16];
  const way = hypot(way_x, way_y);
  if (number >= memory[settings_at + 30] || way < larger(WORTHWHILE_PX, 2 * memory[settings_at + 23])) {
    correct(memory, t, memory_at);
    return;
  }
  enter(memory, BALLISTIC, t, s_at);
  const piece_at = settings_at + number * 6 + 31;
  memory[s_at + 3] = number;
  const wanted = way * memory[piece_at];
  memory[s_at + 4] = hand_distance(memory, wanted, memory[piece_at + 1], settings_at);
  memory[s_at + 5] = Math.atan2(way_y, way_x) + memory[piece_at + 3];
}
export function decide(memory, t, memory_at = 0) {
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const phase = memory[s_at + 1];
  const since = memory[s_at + 2];
  if (phase === WAITING && t >= memory[settings_at + 26]) {
    launch(memory, 0, t, memory_at);
  } else if (phase === BALLISTIC) {
    const number = Math.trunc(memory[s_at + 3]);
    const piece_at = settings_at + number * 6 + 31;
    if (t - since >= memory[piece_at + 5] * memory[piece_at + 1]) {
      launch(memory, number + 1, t, memory_at);
    }
  } else if (phase === CORRECTIVE) {
    const off = hypot(memory[s_at + 15] - memory[settings_at + 21], memory[s_at + 16] - memory[settings_at + 22]);
    const slow = hypot(memory[s_at + 9], memory[s_at + 10]) < SLOW_M_S;
    const arrived = slow && off < NEAR_SHARE * memory[settings_at + 23];
    if (arrived || t > memory[settings_at + 29]) {
      enter(memory, VERIFYING, t, s_at);
    }
  } else if (phase === VERIFYING && t - since >= memory[settings_at + 27]) {
    enter(memory, PRESSING, t, s_at);
  } else if (phase === PRESSING && t - since >= memory[settings_at + 28]) {
    enter(memory, DONE, t, s_at);
  }
}
export function step(memory, chance, memory_at = 0) {
  let dx, dy;
  const settings_at = memory_at;
  const s_at = memory_at + 55;
  const values_1 = chance;
  const noise_x = values_1[0];
  const noise_y = values_1[1];
  const late_s = values_1[2];
  const hat_x = values_1[3];
  const hat_y = values_1[4];
  const period = memory[settings_at];
  const now = memory[s_at] * period;
  decide(memory, now, memory_at);
  const keep = Math.exp(-period / WANDER_S);
  const fresh = Math.sqrt(1 - keep * keep);
  memory[s_at + 13] = keep * memory[s_at + 13] + fresh * noise_x;
  memory[s_at + 14] = keep * memory[s_at + 14] + fresh * noise_y;
  const speed = hypot(memory[s_at + 9], memory[s_at + 10]);
  const size = memory[settings_at + 20] + memory[settings_at + 19] * speed;
  const extra_x = size * memory[s_at + 13];
  const extra_y = size * memory[s_at + 14];
  const before_x = memory[s_at + 15];
  const before_y = memory[s_at + 16];
  const substeps = Math.trunc(memory[settings_at + 1]);
  const h = period / substeps;
  for (let i = 0; i < substeps; i++) {
    advance(memory, now + i * h, h, extra_x, extra_y, memory_at);
  }
  dx = dy = 0;
  if (memory[settings_at + 3] > 0) {
    const values_2 = report(memory, hat_x, hat_y, memory_at);
    dx = values_2[0];
    dy = values_2[1];
  } else {
    const own_px = hypot(memory[s_at + 15] - before_x, memory[s_at + 16] - before_y);
    const values_3 = assist(memory, own_px, hat_x, hat_y, memory_at);
    const pull_x = values_3[0];
    const pull_y = values_3[1];
    memory[s_at + 15] += pull_x;
    memory[s_at + 16] += pull_y;
  }
  memory[s_at] += 1;
  const seen_at = s_at + remainder(Math.trunc(memory[s_at]), RING_ROWS) * 4 + 23;
  const value_4 = memory[s_at + 15];
  const value_5 = memory[s_at + 16];
  memory[seen_at] = value_4;
  memory[seen_at + 1] = value_5;
  const value_6 = memory[s_at + 7];
  const value_7 = memory[s_at + 8];
  memory[seen_at + 2] = value_6;
  memory[seen_at + 3] = value_7;
  return [memory[s_at] * period + late_s, memory[s_at + 15], memory[s_at + 16], dx, dy, memory[s_at + 1] === PRESSING ? 1 : 0, memory[s_at + 7], memory[s_at + 8], memory[s_at + 9] + extra_x, memory[s_at + 10] + extra_y, memory[s_at + 11], memory[s_at + 12], memory[s_at + 1], memory[s_at + 3]];
}
