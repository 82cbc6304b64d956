// Written by `make laws` from durations.py: change that and run it again.
import { larger, remainder, smaller } from "../../arithmetic.js";
export const CAPACITY = 12;
export const SHARES = [0, 0.25, 0.5, 0.75, 1];
export const KEEP = 0.97;
export const FIRST = [1, 0.92, 0.88, 0.9, 0.97];
export const FIRST_OF = 5;
export const LEAST = 0.05;
export const FINE = 0;
export const NO_DURATION = 11;
export const OTHER_MEDIAN = 12;
export function mixture(s, share, since, left, s_at = 0) {
  const by_clock = larger(s[s_at + 13] - since, 0);
  return larger((1 - share) * left + share * by_clock, LEAST * left);
}
export function mix(s, since, left, s_at = 0) {
  if (s[s_at] === 0) {
    return left;
  }
  return mixture(s, s[s_at + 20], since, left, s_at);
}
export function judge(s, since, predicted, left, duration, s_at = 0) {
  for (let k = 0, end_1 = SHARES.length; k < end_1; k++) {
    const off = mixture(s, SHARES[k], since, predicted, s_at) - left;
    s[s_at + k + 14] += Math.abs(off) / duration;
  }
}
export function forget(s, s_at = 0) {
  for (let k = 0, end_1 = SHARES.length; k < end_1; k++) {
    s[s_at + k + 14] *= KEEP;
  }
  s[s_at + 19] = KEEP * s[s_at + 19] + 1;
}
export function value_of_rank(s, rank, s_at = 0) {
  const count = Math.trunc(s[s_at]);
  for (let i = 0; i < count; i++) {
    let before = 0;
    for (let j = 0; j < count; j++) {
      if (s[s_at + j + 1] < s[s_at + i + 1] || s[s_at + j + 1] === s[s_at + i + 1] && j < i) {
        before += 1;
      }
    }
    if (before === rank) {
      return s[s_at + i + 1];
    }
  }
  return NaN;
}
export function median(s, s_at = 0) {
  const count = Math.trunc(s[s_at]);
  const upper = value_of_rank(s, Math.floor(count / 2), s_at);
  return remainder(count, 2) ? upper : (value_of_rank(s, Math.floor(count / 2) - 1, s_at) + upper) / 2;
}
export function fault(learned, learned_at = 0) {
  for (let i = 0, end_1 = Math.trunc(learned[learned_at]); i < end_1; i++) {
    if (!(learned[learned_at + i + 1] > 0)) {
      return [NO_DURATION, learned[learned_at + i + 1]];
    }
  }
  if (learned[learned_at] > 0 && learned[learned_at + 13] !== median(learned, learned_at)) {
    return [OTHER_MEDIAN, learned[learned_at + 13]];
  }
  return [FINE, 0];
}
export function remember(s, duration, s_at = 0) {
  const count = Math.trunc(smaller(s[s_at] + 1, CAPACITY));
  for (let j = count - 1; j > 0; j--) {
    s[s_at + j + 1] = s[s_at + (j - 1) + 1];
  }
  s[s_at] = count;
  s[s_at + 1] = duration;
  s[s_at + 13] = median(s, s_at);
  const usual = s[s_at + 14] / larger(s[s_at + 19], 1);
  let least = Infinity;
  for (let k = 0, end_1 = SHARES.length; k < end_1; k++) {
    const error = s[s_at + k + 14] + FIRST_OF * FIRST[k] * usual;
    if (error < least) {
      least = error;
      s[s_at + 20] = SHARES[k];
    }
  }
}
