// Written by `make laws` from durations.py: change that and run it again.
import { larger, remainder, smaller } from "../../arithmetic.js";
export const CAPACITY = 12;
export const SHARES = [0, 0.25, 0.5, 0.75, 1];
export const KEEP = 0.97;
export const FIRST = [1, 0.92, 0.88, 0.9, 0.97];
export const FIRST_OF = 5;
export const LEAST = 0.05;
export const COUNT = 0;
export const DURATIONS = 1;
export const MEDIAN = 13;
export const ERRORS = 14;
export const MOVEMENTS = 19;
export const BEST = 20;
export const FINE = 0;
export const NO_DURATION = 11;
export const OTHER_MEDIAN = 12;
export function mixture(memory, at, share, since, left) {
  const by_clock = larger(memory[at + MEDIAN] - since, 0);
  return larger((1 - share) * left + share * by_clock, LEAST * left);
}
export function mix(memory, at, since, left) {
  if (memory[at + COUNT] === 0) {
    return left;
  }
  return mixture(memory, at, memory[at + BEST], since, left);
}
export function judge(memory, at, since, predicted, left, duration) {
  for (let k = 0, end_1 = SHARES.length; k < end_1; k++) {
    const off = mixture(memory, at, SHARES[k], since, predicted) - left;
    memory[at + ERRORS + k] += Math.abs(off) / duration;
  }
}
export function forget(memory, at) {
  for (let k = 0, end_1 = SHARES.length; k < end_1; k++) {
    memory[at + ERRORS + k] *= KEEP;
  }
  memory[at + MOVEMENTS] = KEEP * memory[at + MOVEMENTS] + 1;
}
export function value_of_rank(values, at, count, rank) {
  for (let i = at, end_1 = at + count; i < end_1; i++) {
    let before = 0;
    for (let j = at, end_2 = at + count; j < end_2; j++) {
      if (values[j] < values[i] || values[j] === values[i] && j < i) {
        before += 1;
      }
    }
    if (before === rank) {
      return values[i];
    }
  }
  return NaN;
}
export function median(values, at, count) {
  const upper = value_of_rank(values, at, count, Math.floor(count / 2));
  return remainder(count, 2) ? upper : (value_of_rank(values, at, count, Math.floor(count / 2) - 1) + upper) / 2;
}
export function fault(learned) {
  const count = Math.trunc(learned[COUNT]);
  for (let i = 0; i < count; i++) {
    if (!(learned[DURATIONS + i] > 0)) {
      return [NO_DURATION, learned[DURATIONS + i]];
    }
  }
  if (count > 0 && learned[MEDIAN] !== median(learned, DURATIONS, count)) {
    return [OTHER_MEDIAN, learned[MEDIAN]];
  }
  return [FINE, 0];
}
export function remember(memory, at, duration) {
  const count = Math.trunc(smaller(memory[at + COUNT] + 1, CAPACITY));
  for (let j = count - 1; j > 0; j--) {
    memory[at + DURATIONS + j] = memory[at + DURATIONS + j - 1];
  }
  memory[at + COUNT] = count;
  memory[at + DURATIONS] = duration;
  memory[at + MEDIAN] = median(memory, at + DURATIONS, count);
  const usual = memory[at + ERRORS] / larger(memory[at + MOVEMENTS], 1);
  let least = Infinity;
  for (let k = 0, end_1 = SHARES.length; k < end_1; k++) {
    const error = memory[at + ERRORS + k] + FIRST_OF * FIRST[k] * usual;
    if (error < least) {
      least = error;
      memory[at + BEST] = SHARES[k];
    }
  }
}
