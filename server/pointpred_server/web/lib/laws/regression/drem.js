// Written by `make laws` from drem.py: change that and run it again.
import { larger, table, view } from "../arithmetic.js";
import * as $delay from "./delay.js";
import * as $gradient from "./gradient.js";
export function parts(memory, n) {
  const tables = 5 * n;
  const ring = tables + 2 * n * n;
  return [view(memory, 0, n), view(memory, n, 2 * n), view(memory, 2 * n, 3 * n), view(memory, 3 * n, 4 * n), view(memory, 4 * n, 5 * n), table(view(memory, tables, tables + n * n), n, n), view(memory, tables + n * n, ring), view(memory, ring)];
}
export function determinant(a) {
  const n = a.length;
  let result = 1;
  for (let k = 0; k < n; k++) {
    let pivot = k;
    for (let i = k + 1; i < n; i++) {
      if (Math.abs(a[i][k]) > Math.abs(a[pivot][k])) {
        pivot = i;
      }
    }
    const value = a[pivot][k];
    if (value === 0) {
      return 0;
    }
    if (pivot !== k) {
      result = -result;
      for (let j = k; j < n; j++) {
        const value_1 = a[pivot][j];
        const value_2 = a[k][j];
        a[k][j] = value_1;
        a[pivot][j] = value_2;
      }
    }
    result *= value;
    for (let i = k + 1; i < n; i++) {
      const factor = a[i][k] / value;
      for (let j = k + 1; j < n; j++) {
        a[i][j] -= factor * a[k][j];
      }
    }
  }
  return result;
}
export function mix3(a, y, out) {
  const a11 = a[0][0];
  const a12 = a[0][1];
  const a13 = a[0][2];
  const a21 = a[1][0];
  const a22 = a[1][1];
  const a23 = a[1][2];
  const a31 = a[2][0];
  const a32 = a[2][1];
  const a33 = a[2][2];
  const c11 = a22 * a33 - a23 * a32;
  const c12 = a23 * a31 - a21 * a33;
  const c13 = a21 * a32 - a22 * a31;
  const c21 = a13 * a32 - a12 * a33;
  const c22 = a11 * a33 - a13 * a31;
  const c23 = a12 * a31 - a11 * a32;
  const c31 = a12 * a23 - a13 * a22;
  const c32 = a13 * a21 - a11 * a23;
  const c33 = a11 * a22 - a12 * a21;
  out[0] = c11 * y[0] + c21 * y[1] + c31 * y[2];
  out[1] = c12 * y[0] + c22 * y[1] + c32 * y[2];
  out[2] = c13 * y[0] + c23 * y[1] + c33 * y[2];
  return a11 * c11 + a12 * c12 + a13 * c13;
}
export function mix(a, y, out, scratch) {
  let phi;
  const n = y.length;
  if (n === 3) {
    return mix3(a, y, out);
  }
  const replaced = table(scratch, n, n);
  for (let column = -1; column < n; column++) {
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) {
        replaced[i][j] = j === column ? y[i] : a[i][j];
      }
    }
    const value = determinant(replaced);
    if (column < 0) {
      phi = value;
    } else {
      out[column] = value;
    }
  }
  return phi;
}
export function extend(r, delay_s, t) {
  const n = r[0].length;
  const past_at = 0;
  const samples = $delay.capacity(n - 1);
  for (let i = 0; i < n; i++) {
    const row = r[5][i];
    const values_1 = $delay.delayed(r[7], samples, t - i * delay_s, row, past_at);
    const known = values_1[0];
    const y = values_1[1];
    if (!known) {
      return false;
    }
    let square = 0;
    for (let j = 0; j < n; j++) {
      row[j] = r[1][j] > 0 ? row[j] / r[1][j] : 0;
      square += row[j] * row[j];
    }
    if (square === 0) {
      return false;
    }
    const norm = Math.sqrt(square);
    for (let j = 0; j < n; j++) {
      row[j] /= norm;
    }
    r[3][i] = y / norm;
  }
  return true;
}
export function remember(s, r, delay_s, t, y, s_at = 0) {
  const h = s[s_at] === 1 ? t - s[s_at + 1] : 0;
  s[s_at] = 1;
  s[s_at + 1] = t;
  const n = r[0].length;
  $delay.push(r[7], $delay.capacity(n - 1), delay_s / $delay.PER_DELAY, t, r[0], y);
  for (let j = 0; j < n; j++) {
    r[1][j] = larger(r[1][j], Math.abs(r[0][j]));
  }
  return h;
}
export function advance(s, r, delay_s, gamma, t, y, s_at = 0) {
  const h = remember(s, r, delay_s, t, y, s_at);
  s[s_at + 2] = 0;
  if (!extend(r, delay_s, t)) {
    return false;
  }
  const phi = mix(r[5], r[3], r[4], r[6]);
  s[s_at + 2] = phi;
  s[s_at + 3] += gamma * phi * phi * h;
  for (let i = 0, end_1 = r[2].length; i < end_1; i++) {
    if (r[1][i] > 0) {
      r[2][i] = $gradient.descend(r[2][i], r[4][i] / r[1][i], phi, gamma, h);
    }
  }
  return true;
}
