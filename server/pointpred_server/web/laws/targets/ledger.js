// Written by `make laws` from ledger.py: change that and run it again.
import * as $rectangles from "./rectangles.js";
export const LATEST = 1000;
export const MADE = 0;
export const ENTRY = 1;
export const ENTRY_SINCE = 2;
export const PROPOSED = 5;
export const RETRACTED = 6;
export const ENTERED = 7;
export const STATES = 8;
export function begin(s, rows, s_at = 0) {
  s.fill(0, s_at, s_at + 8);
  s[s_at] = s[s_at + 2] = $rectangles.NOBODY;
  for (let i = 0, end_1 = rows.length; i < end_1; i++) {
    rows[i][MADE] = 0;
    rows[i][ENTRY] = NaN;
    rows[i][ENTRY_SINCE] = NaN;
  }
}
export function propose(s, rows, t, place, s_at = 0) {
  s[s_at + 5] += 1;
  s[s_at] = place;
  s[s_at + 1] = t;
  if (place !== $rectangles.NOBODY) {
    rows[place][MADE] += 1;
  }
}
export function withdraw(s, t, place, released, s_at = 0) {
  if (place === $rectangles.NOBODY || s[s_at] !== place) {
    return;
  }
  s[s_at] = $rectangles.NOBODY;
  if (released) {
    const value_1 = place;
    const value_2 = t;
    const value_3 = s[s_at + 1];
    s[s_at + 2] = value_1;
    s[s_at + 3] = value_2;
    s[s_at + 4] = value_3;
  } else {
    s[s_at + 6] += 1;
  }
}
export function enter(s, rows, t, place, s_at = 0) {
  if (place !== $rectangles.NOBODY && rows[place][ENTRY] !== rows[place][ENTRY]) {
    rows[place][ENTRY] = t;
    rows[place][ENTRY_SINCE] = s[s_at] === place ? s[s_at + 1] : NaN;
  }
}
export function close(s, rows, t, place, s_at = 0) {
  if (place === $rectangles.NOBODY) {
    return [0, NaN, NaN];
  }
  let entry = rows[place][ENTRY];
  let since = rows[place][ENTRY_SINCE];
  if (entry !== entry) {
    entry = t;
    if (s[s_at + 2] === place && s[s_at + 3] === t) {
      since = s[s_at + 4];
    } else if (s[s_at] === place) {
      since = s[s_at + 1];
    }
  }
  return [rows[place][MADE], entry - since, t - since];
}
