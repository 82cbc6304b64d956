// Written by `make laws` from distances.py: change that and run it again.
import { larger, remainder, smaller, square } from "../../arithmetic.js";
import * as $moments from "./moments.js";
export const CAPACITY = 12;
export const LEAST = 2;
export const WIDTHS = [0.02, 0.08, 0.35];
export const AGES = [1.5, 12];
export const LAWS = 6;
export const UNKNOWN_LOGS = 3;
export const UNKNOWN_SHARE = 0.98;
export const FORGET = 0.05;
export const LEAST_LIKELY = 1e-12;
export const ARC = 0.5;
export const LOGISTIC = 1.7;
export const HALVINGS = 10;
export const NEGLIGIBLE = 0.0001;
export const OFF_ONE = 1e-06;
export const LEAST_UNKNOWN = 0.049;
export const FINE = 0;
export const TOO_SHORT = 1;
export const TOO_SURE = 2;
export const NO_SHARES = 3;
export function fault(learned, learned_at = 0) {
  const count = Math.trunc(learned[learned_at]);
  if (count === 0) {
    return [FINE, 0];
  }
  for (let i = 0; i < count; i++) {
    if (!(learned[learned_at + i + 1] >= $moments.SHORTEST_PX)) {
      return [TOO_SHORT, learned[learned_at + i + 1]];
    }
  }
  if (!(learned[learned_at + LAWS + 13] >= LEAST_UNKNOWN)) {
    return [TOO_SURE, learned[learned_at + LAWS + 13]];
  }
  let total = 0;
  for (let i = 0; i < 7; i++) {
    total += learned[learned_at + i + 13];
  }
  if (!(Math.abs(total - 1) <= OFF_ONE)) {
    return [NO_SHARES, total];
  }
  return [FINE, 0];
}
export function age_weight(age, count, time) {
  let total = 0;
  for (let j = 0; j < count; j++) {
    total += Math.exp(-j / time);
  }
  return Math.exp(-age / time) / total;
}
export function judge(s, distance, s_at = 0) {
  const count = Math.trunc(s[s_at]);
  let total = 0;
  for (let k = 0; k < LAWS; k++) {
    const width = WIDTHS[remainder(k, WIDTHS.length)];
    const time = AGES[Math.floor(k / WIDTHS.length)];
    let likely = 0;
    for (let j = 0; j < count; j++) {
      const off = Math.log(distance / s[s_at + j + 1]) / width;
      likely += age_weight(j, count, time) * Math.exp(-0.5 * smaller(off * off, 1000)) / (width * Math.sqrt(2 * Math.PI));
    }
    s[s_at + k + 13] *= larger(UNKNOWN_LOGS * likely, LEAST_LIKELY);
    total += s[s_at + k + 13];
  }
  total += s[s_at + LAWS + 13];
  for (let k = 0; k < LAWS; k++) {
    const first = (1 - UNKNOWN_SHARE) / LAWS;
    s[s_at + k + 13] = (1 - FORGET) * s[s_at + k + 13] / total + FORGET * first;
  }
  s[s_at + LAWS + 13] = (1 - FORGET) * s[s_at + LAWS + 13] / total + FORGET * UNKNOWN_SHARE;
}
export function remember(s, distance, s_at = 0) {
  if (s[s_at] === 0) {
    s.fill((1 - UNKNOWN_SHARE) / LAWS, s_at + 13, s_at + LAWS + 13);
    s[s_at + LAWS + 13] = UNKNOWN_SHARE;
  }
  if (s[s_at] >= LEAST) {
    judge(s, distance, s_at);
  }
  for (let j = CAPACITY - 1; j > 0; j--) {
    s[s_at + j + 1] = s[s_at + (j - 1) + 1];
  }
  s[s_at + 1] = distance;
  s[s_at] = smaller(s[s_at] + 1, CAPACITY);
  const count = Math.trunc(s[s_at]);
  for (let j = 0; j < count; j++) {
    for (let w = 0, end_1 = WIDTHS.length; w < end_1; w++) {
      let weight = 0;
      for (let a = 0, end_2 = AGES.length; a < end_2; a++) {
        weight += s[s_at + a * WIDTHS.length + w + 13] * age_weight(j, count, AGES[a]);
      }
      s[s_at + j * 3 + w + 20] = weight;
    }
  }
}
export function likelihood(s, distance, s_at = 0) {
  const count = Math.trunc(s[s_at]);
  if (count < LEAST) {
    return 1;
  }
  let likely = s[s_at + LAWS + 13];
  for (let j = 0; j < count; j++) {
    for (let w = 0, end_1 = WIDTHS.length; w < end_1; w++) {
      const off = Math.log(distance / s[s_at + j + 1]) / WIDTHS[w];
      const near = Math.exp(-0.5 * smaller(off * off, 1000)) / (WIDTHS[w] * Math.sqrt(2 * Math.PI));
      likely += s[s_at + j * 3 + w + 20] * UNKNOWN_LOGS * near;
    }
  }
  return likely;
}
export function combine(s, reached, predicted, s_at = 0) {
  let middle;
  const ahead = predicted[0];
  const wide = predicted[1];
  const broad = predicted[2];
  const tail = predicted[3];
  const count = Math.trunc(s[s_at]);
  if (count < LEAST) {
    return [ahead, wide, 1];
  }
  const most = count * WIDTHS.length + 1;
  const weight = new Float64Array(most);
  const shift = new Float64Array(most);
  const width = new Float64Array(most);
  let total = s[s_at + LAWS + 13];
  let low = 0;
  let high = 0;
  let parts = 1;
  weight[0] = total;
  shift[0] = 0;
  width[0] = wide;
  for (let j = 0; j < count; j++) {
    const distance = s[s_at + j + 1];
    const gap = distance / Math.sqrt(1 + ARC * square(broad / distance)) - reached - ahead;
    for (let w = 0, end_1 = WIDTHS.length; w < end_1; w++) {
      const kernel2 = square(WIDTHS[w] * distance);
      const both2 = wide * wide + kernel2;
      const fits = Math.pow(1 + gap * gap / both2 / tail, -0.5 * (tail + 1)) / Math.sqrt(2 * Math.PI * both2);
      const part = s[s_at + j * 3 + w + 20] * UNKNOWN_LOGS * distance * fits;
      if (part > NEGLIGIBLE * total) {
        weight[parts] = part;
        shift[parts] = gap * wide * wide / both2;
        width[parts] = wide * Math.sqrt(kernel2 / both2);
        low = smaller(low, shift[parts]);
        high = larger(high, shift[parts]);
        total += part;
        parts += 1;
      }
    }
  }
  for (let _ = 0; _ < HALVINGS; _++) {
    middle = 0.5 * (low + high);
    let below = 0;
    for (let k = 0, end_2 = parts; k < end_2; k++) {
      const off = LOGISTIC * (shift[k] - middle) / width[k];
      below += weight[k] / (1 + Math.exp(smaller(larger(off, -50), 50)));
    }
    if (below < 0.5 * total) {
      low = middle;
    } else {
      high = middle;
    }
  }
  middle = 0.5 * (low + high);
  let around = 0;
  for (let k = 0, end_3 = parts; k < end_3; k++) {
    around += weight[k] * (square(width[k]) + square(shift[k] - middle));
  }
  return [ahead + middle, smaller(Math.sqrt(around / total), wide), total];
}
