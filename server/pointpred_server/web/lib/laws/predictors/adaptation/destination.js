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
export function favour_near(s, held, start, near, s_at = 0, held_at = 0) {
  let before = 0;
  let after = 0;
  for (let i = 0, end_1 = Math.trunc(held[held_at]); i < end_1; i++) {
    const distance = hypot(held[held_at + i * 4 + 3] - start[0], held[held_at + i * 4 + 4] - start[1]);
    before += s[s_at + i + 4];
    const nearest = NEAREST * near;
    s[s_at + i + 4] *= distance > near ? Math.pow(larger(distance, nearest), -NEARNESS) : 0;
    after += s[s_at + i + 4];
  }
  for (let i = 0, end_2 = Math.trunc(held[held_at]); i < end_2; i++) {
    s[s_at + i + 4] *= after > 0 ? before / after : 0;
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
export function prepare(s, held, known, scene, start, s_at = 0, held_at = 0, known_at = 0) {
  const key = scene[0];
  const with_sequence = scene[1];
  const near = scene[2];
  const out = matrix($habits.RULES, $places.CAPACITY);
  s.fill(0, s_at, s_at + 133);
  s[s_at] = 1;
  s[s_at + 132] = 1;
  if (!$habits.shares(known, held, key, [start[0], start[1], near], out, known_at, held_at)) {
    return;
  }
  s[s_at + 1] = $habits.returns(known, known_at);
  s[s_at + 2] = $habits.usual_width(known, known_at);
  for (let rule = 0; rule < $habits.RULES; rule++) {
    const weight = $habits.rule_weight(known, rule, with_sequence, known_at);
    for (let i = 0; i < $places.CAPACITY; i++) {
      s[s_at + i + 4] += weight * out[rule][i];
    }
  }
  favour_near(s, held, start, near, s_at, held_at);
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
export function weigh(s, held, start, law_of_end, elsewhere, s_at = 0, held_at = 0) {
  const x0 = start[0];
  const y0 = start[1];
  const usual = elsewhere[0];
  const counts = elsewhere[1];
  s[s_at + 3] = counts;
  const count = Math.trunc(held[held_at]);
  let total = (1 - s[s_at + 1]) * usual;
  for (let i = 0; i < count; i++) {
    const before = s[s_at + i + 4];
    let share = 0;
    if (before > LEAST_SHARE) {
      const x = held[held_at + i * 4 + 3];
      const y = held[held_at + i * 4 + 4];
      const distance = hypot(x - x0, y - y0);
      const spread = s[s_at + 2] * distance;
      share = s[s_at + 1] * before * likelihood(law_of_end, x, y, distance, spread);
    }
    s[s_at + i + 68] = share;
    total += share;
  }
  let rest = 1;
  for (let i = 0; i < count; i++) {
    s[s_at + i + 68] /= total;
    rest -= s[s_at + i + 68];
  }
  s[s_at + 132] = larger(rest, 0);
}
export function spread_of(s, start, x, y, s_at = 0) {
  return s[s_at + 2] * hypot(x - start[0], y - start[1]);
}
export function candidates(s, held, start, elsewhere, out, s_at = 0, held_at = 0) {
  const size2 = 0.5 * (elsewhere[4] * elsewhere[4] + elsewhere[5] * elsewhere[5]);
  const rest = 1 - s[s_at + 3] * (1 - s[s_at + 132]);
  out[0][0] = rest;
  out[0][1] = elsewhere[0];
  out[0][2] = elsewhere[1];
  out[0][3] = size2;
  let count = 1;
  for (let i = 0, end_1 = Math.trunc(held[held_at]); i < end_1; i++) {
    const share = s[s_at + 3] * s[s_at + i + 68];
    if (share > NEGLIGIBLE) {
      const x = held[held_at + i * 4 + 3];
      const y = held[held_at + i * 4 + 4];
      const spread = spread_of(s, start, x, y, s_at);
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
export function combine(s, held, start, elsewhere, s_at = 0, held_at = 0) {
  const rows = matrix($places.CAPACITY + 1, 4);
  const count = candidates(s, held, start, elsewhere, rows, s_at, held_at);
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
