// Written by `make page` from drem.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $delay from "./delay.js";
import * as $gradient from "./gradient.js";
import * as $mixing from "./mixing.js";
export const STARTED = 0;
export const T = 1;
export const PHI = 2;
export const EXCITATION = 3;
export const REGRESSOR = 4;
export function estimates(at, n) {
  return at + REGRESSOR + 2 * n;
}
export function ring(at, n) {
  return at + REGRESSOR + 5 * n + n * n + $mixing.work(n);
}
export function extend(memory, at, n, delay_s, t) {
  const scale = at + REGRESSOR + n;
  const output = at + REGRESSOR + 3 * n;
  const rows = output + 2 * n;
  const past = ring(at, n);
  const samples = $delay.capacity(n - 1);
  for (let i = 0; i < n; i++) {
    const values_1 = $delay.find(memory, past, n + 1, samples, t - i * delay_s);
    const long_enough = values_1[0];
    const before = values_1[1];
    const after = values_1[2];
    const share = values_1[3];
    if (!long_enough) {
      return false;
    }
    let square = 0;
    for (let j = 0; j < n; j++) {
      let value = memory[before + j] + share * (memory[after + j] - memory[before + j]);
      value = memory[scale + j] > 0 ? value / memory[scale + j] : 0;
      memory[rows + i * n + j] = value;
      square += value * value;
    }
    if (square === 0) {
      return false;
    }
    const norm = Math.sqrt(square);
    for (let j = 0; j < n; j++) {
      memory[rows + i * n + j] /= norm;
    }
    const y = memory[before + n] + share * (memory[after + n] - memory[before + n]);
    memory[output + i] = y / norm;
  }
  return true;
}
export function remember(memory, at, n, delay_s, t, output) {
  const scale = at + REGRESSOR + n;
  const h = memory[at + STARTED] === 1 ? t - memory[at + T] : 0;
  memory[at + STARTED] = 1;
  memory[at + T] = t;
  const slot = $delay.push(memory, ring(at, n), n + 1, $delay.capacity(n - 1), delay_s / $delay.PER_DELAY, t);
  for (let j = 0; j < n; j++) {
    const value = memory[at + REGRESSOR + j];
    memory[slot + j] = value;
    memory[scale + j] = larger(memory[scale + j], Math.abs(value));
  }
  memory[slot + n] = output;
  return h;
}
export function advance(memory, at, n, delay_s, gamma, sample) {
  const scale = at + REGRESSOR + n;
  const theta = estimates(at, n);
  const extended = at + REGRESSOR + 3 * n;
  const mixed = extended + n;
  const rows = extended + 2 * n;
  const t = sample[0];
  const output = sample[1];
  const h = remember(memory, at, n, delay_s, t, output);
  memory[at + PHI] = 0;
  if (!extend(memory, at, n, delay_s, t)) {
    return false;
  }
  const phi = $mixing.mix(memory, rows, extended, n, mixed, rows + n * n);
  memory[at + PHI] = phi;
  memory[at + EXCITATION] += gamma * phi * phi * h;
  for (let i = 0; i < n; i++) {
    if (memory[scale + i] > 0) {
      const target = memory[mixed + i] / memory[scale + i];
      memory[theta + i] = $gradient.descend(memory[theta + i], target, phi, gamma, h);
    }
  }
  return true;
}
