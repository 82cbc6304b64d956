// Written by `make laws` from delay.py: change that and run it again.
import { smaller } from "../arithmetic.js";
export const PER_DELAY = 64;
export const COUNT = 0;
export const NEWEST = 1;
export const SAMPLES = 2;
export function capacity(delays) {
  return delays * PER_DELAY + 4;
}
export function push(memory, at, width, samples, spacing, t) {
  const size = 1 + width;
  const count = Math.trunc(memory[at + COUNT]);
  let newest = Math.trunc(memory[at + NEWEST]);
  let keep = count > 0;
  if (keep) {
    const last_t = memory[at + SAMPLES + newest * size];
    keep = t > last_t;
    if (keep && count > 1) {
      const before = newest > 0 ? newest - 1 : samples - 1;
      keep = last_t - memory[at + SAMPLES + before * size] >= spacing;
    }
  }
  if (keep) {
    newest = newest + 1 < samples ? newest + 1 : 0;
  }
  if (keep || count === 0) {
    memory[at + COUNT] = smaller(count + 1, samples);
    memory[at + NEWEST] = newest;
  }
  memory[at + SAMPLES + newest * size] = t;
  return at + SAMPLES + newest * size + 1;
}
export function find(memory, at, width, samples, t) {
  const size = 1 + width;
  const count = Math.trunc(memory[at + COUNT]);
  const newest = Math.trunc(memory[at + NEWEST]);
  const last = at + SAMPLES + newest * size;
  if (count > 0 && t >= memory[last]) {
    return [true, last + 1, last + 1, 0];
  }
  let oldest = newest - count + 1;
  if (oldest < 0) {
    oldest += samples;
  }
  if (count === 0 || t < memory[at + SAMPLES + oldest * size]) {
    return [false, at, at, 0];
  }
  let low = 0;
  let high = count - 1;
  let before = at + SAMPLES + oldest * size;
  let after = last;
  while (high - low > 1) {
    const middle = Math.floor((low + high) / 2);
    let row = oldest + middle;
    if (row >= samples) {
      row -= samples;
    }
    const place = at + SAMPLES + row * size;
    if (memory[place] <= t) {
      low = middle;
      before = place;
    } else {
      high = middle;
      after = place;
    }
  }
  return [true, before + 1, after + 1, (t - memory[before]) / (memory[after] - memory[before])];
}
