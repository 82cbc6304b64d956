// Written by `make laws` from ledger.py: change that and run it again.
import * as $decision from "./decision.js";
export const LATEST = 1000;
export const STANDING = 0;
export const SINCE = 1;
export const ENDED = 2;
export const ENDED_AT = 3;
export const ENDED_SINCE = 4;
export const PROPOSED = 5;
export const RETRACTED = 6;
export const ENTERED = 7;
export const STATES = 8;
export const MADE = 0;
export const ENTRY = 1;
export const ENTRY_SINCE = 2;
export function begin(movement, rows) {
  movement.fill(0);
  movement[STANDING] = movement[ENDED] = $decision.NOBODY;
  for (let i = 0, end_1 = rows.length; i < end_1; i++) {
    rows[i][MADE] = 0;
    rows[i][ENTRY] = NaN;
    rows[i][ENTRY_SINCE] = NaN;
  }
}
export function propose(movement, rows, t, place) {
  movement[PROPOSED] += 1;
  movement[STANDING] = place;
  movement[SINCE] = t;
  if (place !== $decision.NOBODY) {
    rows[place][MADE] += 1;
  }
}
export function withdraw(movement, t, place, released) {
  if (place === $decision.NOBODY || movement[STANDING] !== place) {
    return;
  }
  movement[STANDING] = $decision.NOBODY;
  if (released) {
    const value_1 = place;
    const value_2 = t;
    const value_3 = movement[SINCE];
    movement[ENDED] = value_1;
    movement[ENDED_AT] = value_2;
    movement[ENDED_SINCE] = value_3;
  } else {
    movement[RETRACTED] += 1;
  }
}
export function enter(movement, rows, t, place) {
  if (place !== $decision.NOBODY && rows[place][ENTRY] !== rows[place][ENTRY]) {
    rows[place][ENTRY] = t;
    rows[place][ENTRY_SINCE] = movement[STANDING] === place ? movement[SINCE] : NaN;
  }
}
export function close(movement, rows, t, place) {
  if (place === $decision.NOBODY) {
    return [0, NaN, NaN];
  }
  let entry = rows[place][ENTRY];
  let since = rows[place][ENTRY_SINCE];
  if (entry !== entry) {
    entry = t;
    if (movement[ENDED] === place && movement[ENDED_AT] === t) {
      since = movement[ENDED_SINCE];
    } else if (movement[STANDING] === place) {
      since = movement[SINCE];
    }
  }
  return [rows[place][MADE], entry - since, t - since];
}
