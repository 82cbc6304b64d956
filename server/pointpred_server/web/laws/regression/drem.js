// Written by `make laws` from drem.py: change that and run it again.
import { larger } from "../arithmetic.js";
import * as $delay from "./delay.js";
import * as $gradient from "./gradient.js";
export const STARTED = 0;
export const T = 1;
export const PHI = 2;
export const EXCITATION = 3;
export const REGRESSOR = 4;
export function work(n) {
  return n * n;
}
export function determinant(memory, at, n) {
  let result = 1;
  for (let k = 0; k < n; k++) {
    let pivot = k;
    for (let i = k + 1; i < n; i++) {
      if (Math.abs(memory[at + i * n + k]) > Math.abs(memory[at + pivot * n + k])) {
        pivot = i;
      }
    }
    const value = memory[at + pivot * n + k];
    if (value === 0) {
      return 0;
    }
    if (pivot !== k) {
      result = -result;
      for (let j = k; j < n; j++) {
        const top = at + k * n + j;
        const low = at + pivot * n + j;
        const value_1 = memory[low];
        const value_2 = memory[top];
        memory[top] = value_1;
        memory[low] = value_2;
      }
    }
    result *= value;
    for (let i = k + 1; i < n; i++) {
      const factor = memory[at + i * n + k] / value;
      for (let j = k + 1; j < n; j++) {
        memory[at + i * n + j] -= factor * memory[at + k * n + j];
      }
    }
  }
  return result;
}
export function mix3(memory, a, y, out) {
  const a11 = memory[a];
  const a12 = memory[a + 1];
  const a13 = memory[a + 2];
  const a21 = memory[a + 3];
  const a22 = memory[a + 4];
  const a23 = memory[a + 5];
  const a31 = memory[a + 6];
  const a32 = memory[a + 7];
  const a33 = memory[a + 8];
  const y1 = memory[y];
  const y2 = memory[y + 1];
  const y3 = memory[y + 2];
  const c11 = a22 * a33 - a23 * a32;
  const c12 = a23 * a31 - a21 * a33;
  const c13 = a21 * a32 - a22 * a31;
  const c21 = a13 * a32 - a12 * a33;
  const c22 = a11 * a33 - a13 * a31;
  const c23 = a12 * a31 - a11 * a32;
  const c31 = a12 * a23 - a13 * a22;
  const c32 = a13 * a21 - a11 * a23;
  const c33 = a11 * a22 - a12 * a21;
  memory[out] = c11 * y1 + c21 * y2 + c31 * y3;
  memory[out + 1] = c12 * y1 + c22 * y2 + c32 * y3;
  memory[out + 2] = c13 * y1 + c23 * y2 + c33 * y3;
  return a11 * c11 + a12 * c12 + a13 * c13;
}
export function mix(memory, a, y, n, out, scratch) {
  let phi;
  if (n === 3) {
    return mix3(memory, a, y, out);
  }
  for (let column = -1; column < n; column++) {
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) {
        memory[scratch + i * n + j] = j === column ? memory[y + i] : memory[a + i * n + j];
      }
    }
    const value = determinant(memory, scratch, n);
    if (column < 0) {
      phi = value;
    } else {
      memory[out + column] = value;
    }
  }
  return phi;
}
export function estimates(at, n) {
  return at + REGRESSOR + 2 * n;
}
export function ring(at, n) {
  return at + REGRESSOR + 5 * n + n * n + work(n);
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
  const phi = mix(memory, rows, extended, n, mixed, rows + n * n);
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
