// Written by `make laws` from stages.py: change that and run it again.
import { larger, smaller, square } from "../../arithmetic.js";
export const STAGES = 5;
export const KEEP = 0.97;
export const RIDGE = 20;
export const DOUBT = 5;
export const WIDTHS_OF = 2;
export const TEMPO_OF = 10;
export const FURTHEST = 4;
export const TEMPO_MOST = 0.4;
export const TEMPO_OFF = 0.3;
export const G00 = 0;
export const G01 = 1;
export const G11 = 2;
export const R0 = 3;
export const R1 = 4;
export const TOTAL = 5;
export const AHEAD = 6;
export const BIAS_PAID = 7;
export const BIAS_SIZE = 8;
export const COUNT = 9;
export const WIDE = 10;
export const BROAD = 11;
export const TEMPO = 12;
export const TIMED = 13;
export const TEMPO_PAID = 14;
export const TEMPO_SIZE = 15;
export const WIDTH = 16;
export const MOST_SHARE = 1000;
export const PRESENT = 0;
export const PARTS = 1;
export const MOMENT = 13;
export const T = 1;
export function interpolation_among(share, count) {
  const spot = smaller(larger(share * count - 0.5, 0), count - 1);
  const stage = smaller(Math.floor(spot), count - 2);
  return [Math.trunc(stage), spot - stage];
}
export function interpolation(share) {
  return interpolation_among(share, STAGES);
}
export function belief(memory, at, paid) {
  return smaller(larger(memory[at + paid] / (memory[at + paid + 1] + DOUBT), 0), 1);
}
export function bias(memory, at, total, along) {
  return memory[at + TOTAL] * total + memory[at + AHEAD] * along;
}
export function width_log(memory, at, which) {
  return 0.5 * Math.log((memory[at + which] + WIDTHS_OF) / (memory[at + COUNT] + WIDTHS_OF));
}
export function tempo(memory, at) {
  return memory[at + TEMPO] / (memory[at + TIMED] + TEMPO_OF);
}
export function tempo_factor(memory, at) {
  return Math.exp(tempo(memory, at) * belief(memory, at, TEMPO_PAID));
}
export function correct(memory, at, share, total, along) {
  const values_1 = interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  let shift = 0;
  let wide = 0;
  let broad = 0;
  let slow = 0;
  for (let side = 0; side < 2; side++) {
    const a = at + (stage + side) * WIDTH;
    const weight = side === 1 ? part : 1 - part;
    shift += weight * bias(memory, a, total, along) * belief(memory, a, BIAS_PAID);
    wide += weight * width_log(memory, a, WIDE);
    broad += weight * width_log(memory, a, BROAD);
    slow += weight * tempo(memory, a) * belief(memory, a, TEMPO_PAID);
  }
  return [shift, Math.exp(wide), Math.exp(broad), Math.exp(slow)];
}
export function bounded(value, most) {
  return smaller(larger(value, -most), most);
}
export function solve(memory, at) {
  const g00 = memory[at + G00] + RIDGE;
  const g01 = memory[at + G01];
  const g11 = memory[at + G11] + RIDGE;
  const determinant = larger(g00 * g11 - g01 * g01, RIDGE * RIDGE);
  const by_total = (g11 * memory[at + R0] - g01 * memory[at + R1]) / determinant;
  const by_ahead = (g00 * memory[at + R1] - g01 * memory[at + R0]) / determinant;
  memory[at + TOTAL] = bounded(by_total, MOST_SHARE);
  memory[at + AHEAD] = bounded(by_ahead, MOST_SHARE);
}
export function scale(memory, at, which, off, tail) {
  const before = (memory[at + which] + WIDTHS_OF) / (memory[at + COUNT] + WIDTHS_OF);
  memory[at + which] += (tail + 1) / (tail + off * off / before) * off * off;
}
export function record(memory, place, moment) {
  memory[place + PRESENT] = 1;
  for (let i = 0, end_1 = moment.length; i < end_1; i++) {
    memory[place + PARTS + i] = moment[i];
  }
}
export function moment_at(memory, place) {
  const p = place + PARTS;
  return [memory[p + 0], memory[p + 1], memory[p + 2], memory[p + 3], memory[p + 4], memory[p + 5], memory[p + 6], memory[p + 7], memory[p + 8], memory[p + 9], memory[p + 10], memory[p + 11]];
}
export function learn(memory, at, m, x, y, t) {
  for (let i = 0; i < WIDTH; i++) {
    if (i !== TOTAL && i !== AHEAD) {
      memory[at + i] *= KEEP;
    }
  }
  const dx = x - m[1];
  const dy = y - m[2];
  const off = (dx * m[3] + dy * m[4] - m[5]) / m[7];
  const aside = (dy * m[3] - dx * m[4] - m[6]) / m[8];
  const total = Math.sqrt(square(m[11] + m[5]) + m[6] * m[6]);
  const shift = bias(memory, at, total, m[5]) / m[7];
  const rest = off - shift;
  const paid = bounded(shift, FURTHEST);
  memory[at + BIAS_PAID] += paid * bounded(off, FURTHEST);
  memory[at + BIAS_SIZE] += paid * paid;
  const weight = (m[9] + 1) / (m[9] + rest * rest);
  const f0 = total / m[7];
  const f1 = m[5] / m[7];
  memory[at + G00] += weight * f0 * f0;
  memory[at + G01] += weight * f0 * f1;
  memory[at + G11] += weight * f1 * f1;
  memory[at + R0] += weight * f0 * off;
  memory[at + R1] += weight * f1 * off;
  solve(memory, at);
  scale(memory, at, WIDE, rest, m[9]);
  scale(memory, at, BROAD, aside, m[9]);
  const left = t - m[0];
  if (left > 0) {
    const late = bounded(Math.log(left / m[10]), TEMPO_MOST);
    const slow = tempo(memory, at);
    memory[at + TEMPO_PAID] += slow * late / (TEMPO_OFF * TEMPO_OFF);
    memory[at + TEMPO_SIZE] += slow * slow / (TEMPO_OFF * TEMPO_OFF);
    memory[at + TEMPO] += late;
    memory[at + TIMED] += 1;
  }
  memory[at + COUNT] += 1;
}
