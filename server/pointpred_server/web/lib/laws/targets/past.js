// Written by `make laws` from past.py: change that and run it again.
import { larger, matrix, smaller } from "../arithmetic.js";
import * as $rectangles from "./rectangles.js";
export const GIVEN = 0;
export const OFTEN = 1;
export const LATELY = 2;
export const AFTER = 3;
export const ALIKE = 4;
export const RULES = 5;
export const FIRST_RULES = [12, 1, 1, 1, 1];
export const FADING_OF = 4;
export const ID = 0;
export const KIND = 1;
export const CAPACITY = 64;
export const KEEP = 0.97;
export const GIVEN_OF = 1;
export const LATE_AGE = 3;
export const OFTEN_AGE = 40;
export const FIRST_OF = 1;
export const NONE_MOST = 0.99;
export const NO_TARGET = 0;
export function elsewhere(s, first, s_at = 0) {
  const learned = (first * FIRST_OF + s[s_at + 135]) / (FIRST_OF + s[s_at + 134] + s[s_at + 135]);
  return larger(smaller(learned, NONE_MOST), first);
}
export function add_visit(s, k, keys, out, s_at = 0) {
  let place = -1;
  let alike = 0;
  for (let i = 0, end_1 = keys.length; i < end_1; i++) {
    if (keys[i][ID] === s[s_at + k + 1]) {
      place = i;
    }
    if (keys[i][KIND] === s[s_at + k + 65]) {
      alike += out[GIVEN][i];
    }
  }
  const weight = Math.exp(-k / OFTEN_AGE);
  if (place >= 0) {
    out[OFTEN][place] += weight;
    out[LATELY][place] += Math.exp(-k / LATE_AGE);
    if (k + 1 < Math.trunc(s[s_at]) && s[s_at + 1] !== NO_TARGET && s[s_at + k + 2] === s[s_at + 1]) {
      out[AFTER][place] += weight;
    }
  }
  if (alike > 0) {
    for (let i = 0, end_2 = keys.length; i < end_2; i++) {
      if (keys[i][KIND] === s[s_at + k + 65]) {
        out[ALIKE][i] += weight * out[GIVEN][i] / alike;
      }
    }
  }
}
export function shares(s, own, keys, out, s_at = 0) {
  for (let i = 0, end_1 = own.length; i < end_1; i++) {
    out[GIVEN][i] = own[i] > -Infinity ? Math.exp(own[i]) : 0;
  }
  for (let k = 0, end_2 = Math.trunc(s[s_at]); k < end_2; k++) {
    if (s[s_at + k + 1] !== NO_TARGET) {
      add_visit(s, k, keys, out, s_at);
    }
  }
  for (let rule = OFTEN; rule < RULES; rule++) {
    let total = GIVEN_OF;
    for (let i = 0, end_3 = own.length; i < end_3; i++) {
      out[rule][i] = out[GIVEN][i] > 0 ? out[rule][i] : 0;
      total += out[rule][i];
    }
    for (let i = 0, end_4 = own.length; i < end_4; i++) {
      out[rule][i] = (out[rule][i] + GIVEN_OF * out[GIVEN][i]) / total;
    }
  }
}
export function rule_weight(s, rule, s_at = 0) {
  const fading = FADING_OF / (FADING_OF + s[s_at + 134]);
  let total = 0;
  for (let k = 0; k < RULES; k++) {
    total += s[s_at + k + 129] + FIRST_RULES[k] * fading;
  }
  return (s[s_at + rule + 129] + FIRST_RULES[rule] * fading) / total;
}
export function weigh(s, own, keys, table, s_at = 0) {
  if (s[s_at + 134] === 0) {
    for (let i = 0, end_1 = own.length; i < end_1; i++) {
      table[i][$rectangles.LOG_WEIGHT] = own[i];
    }
    return;
  }
  const by_rule = matrix(RULES, own.length);
  shares(s, own, keys, by_rule, s_at);
  for (let i = 0, end_2 = own.length; i < end_2; i++) {
    let total = 0;
    for (let rule = 0; rule < RULES; rule++) {
      total += rule_weight(s, rule, s_at) * by_rule[rule][i];
    }
    table[i][$rectangles.LOG_WEIGHT] = total > 0 ? Math.log(total) : -Infinity;
  }
}
export function learn(s, own, keys, taken, s_at = 0) {
  s[s_at + 134] *= KEEP;
  s[s_at + 135] *= KEEP;
  if (taken < 0) {
    s[s_at + 135] += 1;
  } else {
    s[s_at + 134] += 1;
    const by_rule = matrix(RULES, own.length);
    shares(s, own, keys, by_rule, s_at);
    let total = 0;
    for (let rule = 0; rule < RULES; rule++) {
      by_rule[rule][taken] *= rule_weight(s, rule, s_at);
      total += by_rule[rule][taken];
    }
    for (let rule = 0; rule < RULES; rule++) {
      s[s_at + rule + 129] = KEEP * s[s_at + rule + 129] + (total > 0 ? by_rule[rule][taken] / total : 0);
    }
  }
  s[s_at] = smaller(s[s_at] + 1, CAPACITY);
  for (let k = Math.trunc(s[s_at]) - 1; k > 0; k--) {
    const value_1 = s[s_at + (k - 1) + 1];
    const value_2 = s[s_at + (k - 1) + 65];
    s[s_at + k + 1] = value_1;
    s[s_at + k + 65] = value_2;
  }
  s[s_at + 1] = taken >= 0 ? keys[taken][ID] : NO_TARGET;
  s[s_at + 65] = taken >= 0 ? keys[taken][KIND] : NO_TARGET;
}
