// Written by `make laws` from trials.py: change that and run it again.
import { hypot, larger } from "../arithmetic.js";
import * as $records from "../records.js";
export const ONSET_PX = 3;
export const ARRIVAL_PX = 8;
export const ARRIVAL_SHARE = 0.03;
export const GOOD = 0;
export const EMPTY = 1;
export const ONE_SAMPLE = 2;
export const UNUSABLE = 3;
export const BACKWARD = 4;
export const NEVER_LEFT = 5;
export const ARRIVED = 6;
export const INSTANT = 7;
export const VERDICT = 0;
export const ROW = 1;
export const ONSET = 2;
export const STOP = 3;
export const ARRIVAL = 4;
export const CUTS = 5;
export function fault(rows, first, stop) {
  if (stop === first) {
    return [EMPTY, first];
  }
  for (let i = first; i < stop; i++) {
    if ($records.fault_of_event($records.event_at(rows, i)) !== $records.FINE) {
      return [UNUSABLE, i];
    }
    if (i > first && rows[i][0] < rows[i - 1][0]) {
      return [BACKWARD, i];
    }
  }
  if (stop - first === 1) {
    return [ONE_SAMPLE, first];
  }
  return [GOOD, first];
}
export function selection(rows, first, stop) {
  for (let i = stop - 1; i > first; i--) {
    const pressed = (Math.trunc(rows[i][5]) & 1) === 1 && (Math.trunc(rows[i - 1][5]) & 1) === 0;
    if (pressed && hypot(rows[i][1] - rows[first][1], rows[i][2] - rows[first][2]) > ONSET_PX) {
      return i + 1;
    }
  }
  return stop;
}
export function departure(rows, first, stop) {
  for (let i = stop - 1; i > first; i--) {
    if (hypot(rows[i][1] - rows[first][1], rows[i][2] - rows[first][2]) <= ONSET_PX) {
      return i;
    }
  }
  return first;
}
export function settling(rows, onset, stop) {
  const x = rows[stop - 1][1];
  const y = rows[stop - 1][2];
  const near = larger(ARRIVAL_PX, ARRIVAL_SHARE * hypot(x - rows[onset][1], y - rows[onset][2]));
  for (let i = stop - 1, end_1 = onset - 1; i > end_1; i--) {
    if (hypot(rows[i][1] - x, rows[i][2] - y) > near) {
      return i + 1;
    }
  }
  return onset;
}
export function cut(rows, offsets, out) {
  for (let k = 0, end_1 = offsets.length - 1; k < end_1; k++) {
    const first = offsets[k];
    let stop = offsets[k + 1];
    const values_2 = fault(rows, first, stop);
    let verdict = values_2[0];
    let row = values_2[1];
    let onset = first;
    let arrival = first;
    if (verdict === GOOD) {
      stop = selection(rows, first, stop);
      onset = departure(rows, first, stop);
      arrival = settling(rows, onset, stop);
      row = onset;
      if (onset === stop - 1) {
        verdict = NEVER_LEFT;
      } else if (arrival === onset) {
        verdict = ARRIVED;
      } else if (rows[arrival][0] === rows[onset][0]) {
        verdict = INSTANT;
      }
    }
    out[k][VERDICT] = verdict;
    out[k][ROW] = row;
    out[k][ONSET] = onset;
    out[k][STOP] = stop;
    out[k][ARRIVAL] = arrival;
  }
}
