// Written by `make laws` from least_squares.py: change that and run it again.
import { hypot } from "../arithmetic.js";
export const SAMPLES = 0;
export const EFFECTIVE = 1;
export const RESIDUAL = 2;
export const REGRESSOR = 3;
export function root(at, n) {
  return at + REGRESSOR + 2 * n;
}
export function advance(memory, at, n, forgetting, output) {
  const w = at + REGRESSOR;
  const z = at + REGRESSOR + n;
  const r = root(at, n);
  if (forgetting < 1) {
    const keep = Math.sqrt(forgetting);
    for (let i = 0, end_1 = n + n * n; i < end_1; i++) {
      memory[z + i] *= keep;
    }
  }
  let rest = output;
  for (let i = 0; i < n; i++) {
    const top = memory[r + i * n + i];
    const low = memory[w + i];
    const length = hypot(top, low);
    if (low === 0 || length === 0) {
      continue;
    }
    const cosine = top / length;
    const sine = low / length;
    for (let j = i; j < n; j++) {
      const upper = memory[r + i * n + j];
      const lower = memory[w + j];
      memory[r + i * n + j] = cosine * upper + sine * lower;
      memory[w + j] = cosine * lower - sine * upper;
    }
    const value_2 = cosine * memory[z + i] + sine * rest;
    const value_3 = cosine * rest - sine * memory[z + i];
    memory[z + i] = value_2;
    rest = value_3;
  }
  memory[at + SAMPLES] += 1;
  memory[at + EFFECTIVE] = forgetting * memory[at + EFFECTIVE] + 1;
  memory[at + RESIDUAL] = forgetting * memory[at + RESIDUAL] + rest * rest;
}
export function excitation(memory, at, n, j) {
  const r = root(at, n);
  let square = 0;
  for (let i = 0, end_1 = j + 1; i < end_1; i++) {
    square += memory[r + i * n + j] * memory[r + i * n + j];
  }
  return square > 0 ? Math.abs(memory[r + j * n + j]) / Math.sqrt(square) : 0;
}
export function solve(memory, at, n, least, out) {
  for (let j = 0; j < n; j++) {
    if (excitation(memory, at, n, j) < least) {
      return false;
    }
  }
  const r = root(at, n);
  const z = at + REGRESSOR + n;
  for (let back = 0; back < n; back++) {
    const i = n - 1 - back;
    let value = memory[z + i];
    for (let j = i + 1; j < n; j++) {
      value -= memory[r + i * n + j] * memory[out + j];
    }
    memory[out + i] = value / memory[r + i * n + i];
  }
  return true;
}
