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
export const MOST_SHARE = 1000;
export function interpolation_among(share, count) {
  const spot = smaller(larger(share * count - 0.5, 0), count - 1);
  const stage = smaller(Math.floor(spot), count - 2);
  return [Math.trunc(stage), spot - stage];
}
export function interpolation(share) {
  return interpolation_among(share, STAGES);
}
export function belief(paid, size) {
  return smaller(larger(paid / (size + DOUBT), 0), 1);
}
export function bias(s, total, along, s_at = 0) {
  return s[s_at + 5] * total + s[s_at + 6] * along;
}
export function width_log(s, squares, s_at = 0) {
  return 0.5 * Math.log((squares + WIDTHS_OF) / (s[s_at + 9] + WIDTHS_OF));
}
export function tempo(s, s_at = 0) {
  return s[s_at + 12] / (s[s_at + 13] + TEMPO_OF);
}
export function tempo_factor(s, s_at = 0) {
  return Math.exp(tempo(s, s_at) * belief(s[s_at + 14], s[s_at + 15]));
}
export function correct(known, share, total, along, known_at = 0) {
  const values_1 = interpolation(share);
  const stage = values_1[0];
  const part = values_1[1];
  let shift = 0;
  let wide = 0;
  let broad = 0;
  let slow = 0;
  for (let side = 0; side < 2; side++) {
    const s_at = known_at + (stage + side) * 16;
    const weight = side === 1 ? part : 1 - part;
    shift += weight * bias(known, total, along, s_at) * belief(known[s_at + 7], known[s_at + 8]);
    wide += weight * width_log(known, known[s_at + 10], s_at);
    broad += weight * width_log(known, known[s_at + 11], s_at);
    slow += weight * tempo(known, s_at) * belief(known[s_at + 14], known[s_at + 15]);
  }
  return [shift, Math.exp(wide), Math.exp(broad), Math.exp(slow)];
}
export function bounded(value, most) {
  return smaller(larger(value, -most), most);
}
export function solve(s, s_at = 0) {
  const g00 = s[s_at] + RIDGE;
  const g01 = s[s_at + 1];
  const g11 = s[s_at + 2] + RIDGE;
  const determinant = larger(g00 * g11 - g01 * g01, RIDGE * RIDGE);
  const by_total = (g11 * s[s_at + 3] - g01 * s[s_at + 4]) / determinant;
  const by_ahead = (g00 * s[s_at + 4] - g01 * s[s_at + 3]) / determinant;
  s[s_at + 5] = bounded(by_total, MOST_SHARE);
  s[s_at + 6] = bounded(by_ahead, MOST_SHARE);
}
export function scale(s, squares, off, tail, s_at = 0) {
  const before = (squares + WIDTHS_OF) / (s[s_at + 9] + WIDTHS_OF);
  return (tail + 1) / (tail + off * off / before) * off * off;
}
export function forget(s, s_at = 0) {
  const total = s[s_at + 5];
  const ahead = s[s_at + 6];
  const sums = s_at;
  for (let i = 0; i < 16; i++) {
    s[sums + i] *= KEEP;
  }
  s[s_at + 5] = total;
  s[s_at + 6] = ahead;
}
export function learn(s, m, x, y, t, s_at = 0, m_at = 0) {
  forget(s, s_at);
  const dx = x - m[m_at + 2];
  const dy = y - m[m_at + 3];
  const off = (dx * m[m_at + 4] + dy * m[m_at + 5] - m[m_at + 6]) / m[m_at + 8];
  const aside = (dy * m[m_at + 4] - dx * m[m_at + 5] - m[m_at + 7]) / m[m_at + 9];
  const total = Math.sqrt(square(m[m_at + 12] + m[m_at + 6]) + square(m[m_at + 7]));
  const shift = bias(s, total, m[m_at + 6], s_at) / m[m_at + 8];
  const rest = off - shift;
  const paid = bounded(shift, FURTHEST);
  s[s_at + 7] += paid * bounded(off, FURTHEST);
  s[s_at + 8] += paid * paid;
  const weight = (m[m_at + 10] + 1) / (m[m_at + 10] + rest * rest);
  const f0 = total / m[m_at + 8];
  const f1 = m[m_at + 6] / m[m_at + 8];
  s[s_at] += weight * f0 * f0;
  s[s_at + 1] += weight * f0 * f1;
  s[s_at + 2] += weight * f1 * f1;
  s[s_at + 3] += weight * f0 * off;
  s[s_at + 4] += weight * f1 * off;
  solve(s, s_at);
  s[s_at + 10] += scale(s, s[s_at + 10], rest, m[m_at + 10], s_at);
  s[s_at + 11] += scale(s, s[s_at + 11], aside, m[m_at + 10], s_at);
  const left = t - m[m_at + 1];
  if (left > 0) {
    const late = bounded(Math.log(left / m[m_at + 11]), TEMPO_MOST);
    const slow = tempo(s, s_at);
    s[s_at + 14] += slow * late / (TEMPO_OFF * TEMPO_OFF);
    s[s_at + 15] += slow * slow / (TEMPO_OFF * TEMPO_OFF);
    s[s_at + 12] += late;
    s[s_at + 13] += 1;
  }
  s[s_at + 9] += 1;
}
