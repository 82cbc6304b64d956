// Written by `make laws` from least_squares.py: change that and run it again.
import { hypot, table, view } from "../arithmetic.js";
export function parts(memory, n) {
  return [view(memory, 0, n), view(memory, n, 2 * n), table(view(memory, 2 * n, 2 * n + n * n), n, n)];
}
export function advance(s, regression, forgetting, output, s_at = 0) {
  const w = regression[0];
  const z = regression[1];
  const r = regression[2];
  const n = w.length;
  if (forgetting < 1) {
    const keep = Math.sqrt(forgetting);
    for (let i = 0; i < n; i++) {
      z[i] *= keep;
      for (let j = 0; j < n; j++) {
        r[i][j] *= keep;
      }
    }
  }
  let rest = output;
  for (let i = 0; i < n; i++) {
    const top = r[i][i];
    const low = w[i];
    const length = hypot(top, low);
    if (low === 0 || length === 0) {
      continue;
    }
    const cosine = top / length;
    const sine = low / length;
    for (let j = i; j < n; j++) {
      const upper = r[i][j];
      const lower = w[j];
      r[i][j] = cosine * upper + sine * lower;
      w[j] = cosine * lower - sine * upper;
    }
    const value_1 = cosine * z[i] + sine * rest;
    const value_2 = cosine * rest - sine * z[i];
    z[i] = value_1;
    rest = value_2;
  }
  s[s_at] += 1;
  s[s_at + 1] = forgetting * s[s_at + 1] + 1;
  s[s_at + 2] = forgetting * s[s_at + 2] + rest * rest;
}
export function excitation(r, j) {
  let square = 0;
  for (let i = 0, end_1 = j + 1; i < end_1; i++) {
    square += r[i][j] * r[i][j];
  }
  return square > 0 ? Math.abs(r[j][j]) / Math.sqrt(square) : 0;
}
export function solve(regression, least, out) {
  const z = regression[1];
  const r = regression[2];
  const n = z.length;
  for (let j = 0; j < n; j++) {
    if (excitation(r, j) < least) {
      return false;
    }
  }
  for (let back = 0; back < n; back++) {
    const i = n - 1 - back;
    let value = z[i];
    for (let j = i + 1; j < n; j++) {
      value -= r[i][j] * out[j];
    }
    out[i] = value / r[i][i];
  }
  return true;
}
