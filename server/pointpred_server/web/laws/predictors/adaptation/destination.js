// Written by `make laws` from destination.py: change that and run it again.
import { hypot, larger, matrix } from "../../arithmetic.js";
import * as $distances from "./distances.js";
import * as $habits from "./habits.js";
import * as $places from "./places.js";
export const NEARNESS = 1.25;
export const NEAREST = 2.5;
export const LEAST_SHARE = 0.0001;
export const NEGLIGIBLE = 0.001;
export const STEPS = 10;
export const READY = 0;
export const RETURNS = 1;
export const WIDTH = 2;
export const COUNTS = 3;
export const BEFORE = 4;
export const NOW = 68;
export const ELSEWHERE = 132;
export const STATES = 133;
export function favour_near(memory, place_memory, at, start, near) {
  let before = 0;
  let after = 0;
  for (let i = 0, end_1 = Math.trunc(memory[place_memory + $places.COUNT]); i < end_1; i++) {
    const place = place_memory + $places.PLACES + $places.WIDTH * i;
    const distance = hypot(memory[place + $places.X] - start[0], memory[place + $places.Y] - start[1]);
    before += memory[at + BEFORE + i];
    const nearest = NEAREST * near;
    memory[at + BEFORE + i] *= distance > near ? Math.pow(larger(distance, nearest), -NEARNESS) : 0;
    after += memory[at + BEFORE + i];
  }
  for (let i = 0, end_2 = Math.trunc(memory[place_memory + $places.COUNT]); i < end_2; i++) {
    memory[at + BEFORE + i] *= after > 0 ? before / after : 0;
  }
}
export function shift_law(heading, dx, dy) {
  const x = heading[0];
  const y = heading[1];
  const ux = heading[2];
  const uy = heading[3];
  const wide = heading[4];
  const broad = heading[5];
  const tail = heading[6];
  return [x + dx, y + dy, ux, uy, wide, broad, tail];
}
export function scaled(end, shape, factor, tail) {
  const wide2 = factor * end[4] * end[4];
  const broad2 = factor * end[5] * end[5];
  const cross = factor * shape * end[4] * end[5];
  const ux = end[2];
  const uy = end[3];
  const sxx = wide2 * ux * ux - 2 * cross * ux * uy + broad2 * uy * uy;
  const sxy = (wide2 - broad2) * ux * uy + cross * (ux * ux - uy * uy);
  const syy = wide2 * uy * uy + 2 * cross * ux * uy + broad2 * ux * ux;
  return [end[0], end[1], sxx, sxy, syy, tail];
}
export function prepare(memory, known, at, scene, start) {
  const place_memory = known[0];
  const habit_memory = known[1];
  const key = scene[0];
  const with_sequence = scene[1];
  const near = scene[2];
  const out = matrix($habits.RULES, $places.CAPACITY);
  memory.fill(0, at, at + STATES);
  memory[at + READY] = 1;
  memory[at + ELSEWHERE] = 1;
  if (!$habits.shares(memory, place_memory, habit_memory, key, [start[0], start[1], near], out)) {
    return;
  }
  memory[at + RETURNS] = $habits.returns(memory, habit_memory);
  memory[at + WIDTH] = $habits.usual_width(memory, habit_memory);
  for (let rule = 0; rule < $habits.RULES; rule++) {
    const weight = $habits.rule_weight(memory, habit_memory, rule, with_sequence);
    for (let i = 0; i < $places.CAPACITY; i++) {
      memory[at + BEFORE + i] += weight * out[rule][i];
    }
  }
  favour_near(memory, place_memory, at, start, near);
}
export function likelihood(law_of_end, x, y, distance, spread) {
  const ux = law_of_end[2];
  const uy = law_of_end[3];
  const wide = law_of_end[4];
  const broad = law_of_end[5];
  const tail = law_of_end[6];
  const dx = x - law_of_end[0];
  const dy = y - law_of_end[1];
  const along = dx * ux + dy * uy;
  const across = dy * ux - dx * uy;
  const wide2 = wide * wide + spread * spread;
  const broad2 = broad * broad + spread * spread;
  const far2 = along * along / wide2 + across * across / broad2;
  const density = Math.pow(1 + far2 / tail, -0.5 * (tail + 2)) / (2 * Math.PI * Math.sqrt(wide2 * broad2));
  return density * 2 * Math.PI * distance * distance * $distances.UNKNOWN_LOGS;
}
export function weigh(memory, place_memory, at, start, law_of_end, elsewhere) {
  const x0 = start[0];
  const y0 = start[1];
  const usual = elsewhere[0];
  const counts = elsewhere[1];
  memory[at + COUNTS] = counts;
  const returns = memory[at + RETURNS];
  const count = Math.trunc(memory[place_memory + $places.COUNT]);
  let total = (1 - returns) * usual;
  for (let i = 0; i < count; i++) {
    const before = memory[at + BEFORE + i];
    let share = 0;
    if (before > LEAST_SHARE) {
      const place = place_memory + $places.PLACES + $places.WIDTH * i;
      const x = memory[place + $places.X];
      const y = memory[place + $places.Y];
      const distance = hypot(x - x0, y - y0);
      const spread = memory[at + WIDTH] * distance;
      share = returns * before * likelihood(law_of_end, x, y, distance, spread);
    }
    memory[at + NOW + i] = share;
    total += share;
  }
  let rest = 1;
  for (let i = 0; i < count; i++) {
    memory[at + NOW + i] /= total;
    rest -= memory[at + NOW + i];
  }
  memory[at + ELSEWHERE] = larger(rest, 0);
}
export function spread_of(memory, at, start, x, y) {
  return memory[at + WIDTH] * hypot(x - start[0], y - start[1]);
}
export function candidates(memory, place_memory, at, start, elsewhere, out) {
  const size2 = 0.5 * (elsewhere[4] * elsewhere[4] + elsewhere[5] * elsewhere[5]);
  const counts = memory[at + COUNTS];
  const rest = 1 - counts * (1 - memory[at + ELSEWHERE]);
  out[0][0] = rest;
  out[0][1] = elsewhere[0];
  out[0][2] = elsewhere[1];
  out[0][3] = size2;
  let count = 1;
  for (let i = 0, end_1 = Math.trunc(memory[place_memory + $places.COUNT]); i < end_1; i++) {
    const share = counts * memory[at + NOW + i];
    if (share > NEGLIGIBLE) {
      const place = place_memory + $places.PLACES + $places.WIDTH * i;
      const x = memory[place + $places.X];
      const y = memory[place + $places.Y];
      const spread = spread_of(memory, at, start, x, y);
      out[count][0] = share;
      out[count][1] = x;
      out[count][2] = y;
      out[count][3] = spread * spread;
      count += 1;
    }
  }
  return count;
}
export function geometric_median(rows, count) {
  let x = 0;
  let y = 0;
  let total = 0;
  for (let k = 0; k < count; k++) {
    x += rows[k][0] * rows[k][1];
    y += rows[k][0] * rows[k][2];
    total += rows[k][0];
  }
  x = x / total;
  y = y / total;
  for (let _ = 0; _ < STEPS; _++) {
    let sum_x = 0;
    let sum_y = 0;
    let sum_w = 0;
    for (let k = 0; k < count; k++) {
      const dx = rows[k][1] - x;
      const dy = rows[k][2] - y;
      const w = rows[k][0] / Math.sqrt(dx * dx + dy * dy + rows[k][3]);
      sum_x += w * rows[k][1];
      sum_y += w * rows[k][2];
      sum_w += w;
    }
    x = sum_x / sum_w;
    y = sum_y / sum_w;
  }
  return [x, y];
}
export function combine(memory, place_memory, at, start, elsewhere) {
  const rows = matrix($places.CAPACITY + 1, 4);
  const count = candidates(memory, place_memory, at, start, elsewhere, rows);
  if (count === 1) {
    return elsewhere;
  }
  const values_1 = geometric_median(rows, count);
  const x = values_1[0];
  const y = values_1[1];
  const ux = elsewhere[2];
  const uy = elsewhere[3];
  const wide = elsewhere[4];
  const broad = elsewhere[5];
  const tail = elsewhere[6];
  let new_wide = 0;
  let new_broad = 0;
  let total = 0;
  for (let k = 0; k < count; k++) {
    const dx = rows[k][1] - x;
    const dy = rows[k][2] - y;
    const share = rows[k][0];
    const along = dx * ux + dy * uy;
    const across = dy * ux - dx * uy;
    const values_2 = k === 0 ? [wide * wide, broad * broad] : [rows[k][3], rows[k][3]];
    const wide2 = values_2[0];
    const broad2 = values_2[1];
    new_wide += share * Math.sqrt(along * along + wide2);
    new_broad += share * Math.sqrt(across * across + broad2);
    total += share;
  }
  return [x, y, ux, uy, new_wide / total, new_broad / total, tail];
}
