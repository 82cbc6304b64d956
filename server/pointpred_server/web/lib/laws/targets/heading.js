// Written by `make laws` from heading.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $moments from "../predictors/adaptation/moments.js";
import * as $cursor from "./cursor.js";
import * as $past from "./past.js";
import * as $posterior from "./posterior.js";
import * as $rectangles from "./rectangles.js";
export const MOST = 32;
export const SHORTEST_PX = 3;
export const ELSEWHERE = 0.02;
export const LENGTH = 1586;
export const CURSOR = 200;
export const NONE = 216;
export function taken(rows, x, y) {
  let best = $rectangles.holder(rows, x, y);
  if (best !== $rectangles.NOBODY) {
    return best;
  }
  let least = 1;
  for (let i = 0, end_1 = rows.length; i < end_1; i++) {
    const row = rows[i];
    const off = larger(Math.abs(row[$rectangles.CENTRE_X] - x) / row[$rectangles.WIDTH], Math.abs(row[$rectangles.CENTRE_Y] - y) / row[$rectangles.HEIGHT]);
    if (off < least) {
      best = i;
      least = off;
    }
  }
  return best;
}
export function arrived(movement, x, y, near, end, movement_at = 0) {
  for (let k = Math.trunc(movement[movement_at + 11]) - 1, end_1 = -1; k > end_1; k--) {
    const m_at = movement_at + k * 32 + 15;
    if (hypot(movement[m_at + 19] - x, movement[m_at + 20] - y) > near) {
      return end;
    }
    end = movement[m_at];
  }
  return end;
}
export function ended(memory, rows, memory_at = 0) {
  const s_at = memory_at + 200;
  const movement_at = memory_at + 215;
  const distance = hypot(memory[s_at + 2] - memory[s_at + 6], memory[s_at + 3] - memory[s_at + 7]);
  const end = arrived(memory, memory[s_at + 2], memory[s_at + 3], larger($moments.NEAR_PX, $moments.NEAR_SHARE * distance), memory[s_at + 1], movement_at);
  const whole = memory[movement_at] >= $moments.SAMPLES_LEAST && distance >= SHORTEST_PX && end - memory[s_at + 5] >= $moments.LEAST_S;
  return Number(memory[memory_at + 1] === 1 && whole && rows.length > 0 ? end : NaN);
}
export function learn_target(memory, targets, memory_at = 0) {
  const s_at = memory_at + 200;
  const rows = targets[0];
  const own = targets[1];
  const keys = targets[2];
  const end = ended(memory, rows, memory_at);
  if (end === end) {
    $past.learn(memory, own, keys, taken(rows, memory[s_at + 2], memory[s_at + 3]), memory_at + 2);
  }
  memory.fill(0, memory_at + 215, memory_at + 1586);
}
export function begin(memory, targets, memory_at = 0) {
  const rows = targets[0];
  const own = targets[1];
  const keys = targets[2];
  const shares = targets[3];
  const none = $past.elsewhere(memory, memory[memory_at], memory_at + 2);
  $past.weigh(memory, own, keys, rows, memory_at + 2);
  memory[memory_at + 216] = none;
  let total = none;
  shares[rows.length] = none;
  for (let i = 0, end_1 = rows.length; i < end_1; i++) {
    shares[i] = rows[i][$rectangles.LOG_WEIGHT] > -Infinity ? (1 - none) * Math.exp(rows[i][$rectangles.LOG_WEIGHT]) : 0;
    total += shares[i];
  }
  for (let i = 0, end_2 = shares.length; i < end_2; i++) {
    shares[i] /= total;
  }
}
export function follow(memory, event, targets, memory_at = 0) {
  const t = event[0];
  const x = event[1];
  const y = event[2];
  const buttons = event[5];
  const s_at = memory_at + 200;
  const movement_at = memory_at + 215;
  const pressed = Number(Math.trunc(buttons) & 1);
  if ($cursor.begins(memory, t, pressed, s_at)) {
    learn_target(memory, targets, memory_at);
    begin(memory, targets, memory_at);
  }
  memory[movement_at] += t > memory[s_at + 1] || memory[movement_at] === 0 ? 1 : 0;
  memory[movement_at + 2] = $cursor.follow(memory, t, x, y, pressed, s_at) ? 1 : 0;
}
export function weigh(memory, answer, targets, coefficients, memory_at = 0, coefficients_at = 0) {
  const rows = targets[0];
  const shares = targets[3];
  const movement_at = memory_at + 215;
  $posterior.scores(memory, rows, answer, coefficients, memory[movement_at + 1], shares, memory_at + 200, coefficients_at);
  $posterior.normalise(shares);
  memory[movement_at + 3] = answer[6];
  memory[movement_at + 4] = 0;
}
