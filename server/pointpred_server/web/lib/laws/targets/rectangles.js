// Written by `make laws` from rectangles.py: change that and run it again.
import { larger } from "../arithmetic.js";
export const MOST_TARGETS = 1000;
export const NOBODY = -1;
export const CENTRE_X = 0;
export const CENTRE_Y = 1;
export const WIDTH = 2;
export const HEIGHT = 3;
export const LOG_WEIGHT = 4;
export const FIELDS = 5;
export const LEAST = /* @__PURE__ */ new Float64Array([-1000000000, -1000000000, 0.001, 0.001, 0]);
export function complete(rows) {
  let most = -Infinity;
  for (let i = 0, end_1 = rows.length; i < end_1; i++) {
    rows[i][CENTRE_X] += 0.5 * rows[i][WIDTH];
    rows[i][CENTRE_Y] += 0.5 * rows[i][HEIGHT];
    const weight = rows[i][LOG_WEIGHT];
    rows[i][LOG_WEIGHT] = weight > 0 ? Math.log(weight) : -Infinity;
    most = larger(most, rows[i][LOG_WEIGHT]);
  }
  if (most === -Infinity) {
    return;
  }
  let total = 0;
  for (let i = 0, end_2 = rows.length; i < end_2; i++) {
    total += Math.exp(rows[i][LOG_WEIGHT] - most);
  }
  for (let i = 0, end_3 = rows.length; i < end_3; i++) {
    rows[i][LOG_WEIGHT] -= most + Math.log(total);
  }
}
export function holder(table, x, y) {
  let best = NOBODY;
  let smallest = Infinity;
  let least = Infinity;
  for (let i = 0, end_1 = table.length; i < end_1; i++) {
    const row = table[i];
    const across = Math.abs(row[CENTRE_X] - x);
    const down = Math.abs(row[CENTRE_Y] - y);
    if (across <= 0.5 * row[WIDTH] && down <= 0.5 * row[HEIGHT]) {
      const area = row[WIDTH] * row[HEIGHT];
      const away = across + down;
      if (area < smallest || area === smallest && away < least) {
        best = i;
        smallest = area;
        least = away;
      }
    }
  }
  return best;
}
