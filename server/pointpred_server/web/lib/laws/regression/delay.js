// Written by `make laws` from delay.py: change that and run it again.
import { smaller } from "../arithmetic.js";
export const PER_DELAY = 64;
export function capacity(delays) {
  return delays * PER_DELAY + 4;
}
export function push(ring, samples, spacing, t, w, y, ring_at = 0) {
  const n = w.length;
  const size = n + 2;
  const count = Math.trunc(ring[ring_at]);
  let newest = Math.trunc(ring[ring_at + 1]);
  let keep = count > 0;
  if (keep) {
    const last_t = ring[ring_at + newest * size + 2];
    keep = t > last_t;
    if (keep && count > 1) {
      const before = newest > 0 ? newest - 1 : samples - 1;
      keep = last_t - ring[ring_at + before * size + 2] >= spacing;
    }
  }
  if (keep) {
    newest = newest + 1 < samples ? newest + 1 : 0;
  }
  if (keep || count === 0) {
    ring[ring_at] = smaller(count + 1, samples);
    ring[ring_at + 1] = newest;
  }
  const at = newest * size;
  ring[ring_at + at + 2] = t;
  for (let j = 0; j < n; j++) {
    ring[ring_at + at + j + 3] = w[j];
  }
  ring[ring_at + at + n + 3] = y;
}
/** @returns {[boolean, number]} */
export function delayed(ring, samples, t, w, ring_at = 0) {
  let first;
  const n = w.length;
  const size = n + 2;
  const count = Math.trunc(ring[ring_at]);
  const newest = Math.trunc(ring[ring_at + 1]);
  let oldest = newest - count + 1;
  if (oldest < 0) {
    oldest += samples;
  }
  let before = newest * size;
  let after = newest * size;
  let share = 0;
  if (count === 0 || t < ring[ring_at + oldest * size + 2]) {
    return [false, 0];
  }
  if (t < ring[ring_at + after + 2]) {
    before = oldest * size;
    let low = 0;
    let high = count - 1;
    while (high - low > 1) {
      const middle = Math.floor((low + high) / 2);
      let row = oldest + middle;
      if (row >= samples) {
        row -= samples;
      }
      if (ring[ring_at + row * size + 2] <= t) {
        low = middle;
        before = row * size;
      } else {
        high = middle;
        after = row * size;
      }
    }
    share = (t - ring[ring_at + before + 2]) / (ring[ring_at + after + 2] - ring[ring_at + before + 2]);
  }
  for (let j = 0; j < n; j++) {
    first = ring[ring_at + before + j + 3];
    w[j] = first + share * (ring[ring_at + after + j + 3] - first);
  }
  first = ring[ring_at + before + n + 3];
  return [true, first + share * (ring[ring_at + after + n + 3] - first)];
}
