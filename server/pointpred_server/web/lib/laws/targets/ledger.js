// Written by `make laws` from ledger.py: change that and run it again.
import * as $rectangles from "./rectangles.js";
export const LATEST = 1000;
export const MADE = 0;
export const ENTRY = 1;
export const ENTRY_SINCE = 2;
export const KEY = 3;
export const FIELDS = 4;
export const STATES = 16;
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
export function row_of(s, rows, key, new_, s_at = 0) {
  const count = Math.trunc(s[s_at + 15]);
  for (let i = 0; i < count; i++) {
    if (rows[i][KEY] === key) {
      return i;
    }
  }
  if (!new_ || count === rows.length) {
    return $rectangles.NOBODY;
  }
  s[s_at + 15] += 1;
  rows[count][MADE] = 0;
  rows[count][ENTRY] = NaN;
  rows[count][ENTRY_SINCE] = NaN;
  rows[count][KEY] = key;
  return count;
}
export function note_proposal(s, rows, t, key, s_at = 0) {
  propose(s, rows, t, row_of(s, rows, key, true, s_at), s_at + 7);
}
export function note_end(s, rows, t, key, released, s_at = 0) {
  withdraw(s, t, row_of(s, rows, key, false, s_at), released, s_at + 7);
}
export function note_entry(s, rows, t, key, s_at = 0) {
  enter(s, rows, t, row_of(s, rows, key, true, s_at), s_at + 7);
}
export function add(s, movement, s_at = 0) {
  const proposed = movement[0];
  const hit = movement[1];
  const wasted = movement[2];
  const retracted = movement[3];
  const entered = movement[4];
  s[s_at] += 1;
  s[s_at + 1] += proposed;
  s[s_at + 2] += proposed - wasted;
  s[s_at + 3] += hit;
  s[s_at + 4] += wasted;
  s[s_at + 5] += retracted;
  s[s_at + 6] += entered;
}
export function drop(s, s_at = 0) {
  s.fill(0, s_at + 7, s_at + 15);
  s[s_at + 7] = s[s_at + 9] = $rectangles.NOBODY;
  s[s_at + 15] = 0;
}
export function finish(s, rows, t, key, s_at = 0) {
  const values_1 = close(s, rows, t, row_of(s, rows, key, false, s_at), s_at + 7);
  const right = values_1[0];
  const entry_s = values_1[1];
  const click_s = values_1[2];
  const proposed = s[s_at + 12];
  const retracted = s[s_at + 13];
  const entered = s[s_at + 14];
  const hit = entry_s === entry_s ? 1 : 0;
  add(s, [proposed, hit, proposed - right, retracted, entered], s_at);
  drop(s, s_at);
  return [proposed, proposed - right, retracted, entered, entry_s, click_s];
}
