// Written by `make laws` from endpoint.py: change that and run it again.
import { hypot, smaller } from "../../arithmetic.js";
import * as $records from "../../records.js";
export const WEIGHT_S = 0.05;
export const FRACTIONS = /* @__PURE__ */ new Float64Array([0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 1, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95, 1]);
export const TIME_AVERAGED = 0;
export const COVERAGE = 1;
export const BY_TIME = 2;
export const BY_PATH = 10;
export const SINGLE_AXIS = 17;
export const MEASURES = 37;
export const SOUND = -1;
export function measure_trial(rows, answers, fractions, arrival, out) {
  const last = rows.length - 1;
  const end_x = rows[last][1];
  const end_y = rows[last][2];
  const way_x = end_x - rows[0][1];
  const way_y = end_y - rows[0][2];
  const distance2 = way_x * way_x + way_y * way_y;
  const upright = Math.abs(way_y) > Math.abs(way_x);
  const start_t = rows[0][0];
  const span_t = rows[arrival][0] - rows[0][0];
  let next_time = BY_TIME;
  let next_path = BY_PATH;
  let next_axis = SINGLE_AXIS;
  let weighted = 0;
  let weights = 0;
  let answered = 0;
  for (let i = 0, end_1 = last + 1; i < end_1; i++) {
    const x = rows[i][1];
    const y = rows[i][2];
    let error_x = x - end_x;
    let error_y = y - end_y;
    if (answers[i][1] === answers[i][1]) {
      answered += 1;
      error_x = answers[i][1] - end_x;
      error_y = answers[i][2] - end_y;
    }
    const error = hypot(error_x, error_y);
    if (!(error < Infinity)) {
      return i;
    }
    if (i < arrival) {
      const weight = smaller(rows[i + 1][0] - rows[i][0], WEIGHT_S);
      weighted += weight * error;
      weights += weight;
    }
    while (next_time < BY_PATH && (i === last || rows[i + 1][0] > start_t + fractions[next_time - BY_TIME] * span_t + $records.ROUNDING_S)) {
      out[next_time] = error;
      next_time += 1;
    }
    const done_x = x - rows[0][1];
    const done_y = y - rows[0][2];
    let progress = done_x * way_x + done_y * way_y;
    while (next_path < SINGLE_AXIS && progress >= fractions[next_path - BY_TIME] * distance2) {
      out[next_path] = error;
      next_path += 1;
    }
    const along = upright ? Math.abs(way_y) : Math.abs(way_x);
    progress = upright ? done_y : done_x;
    if ((upright ? way_y : way_x) < 0) {
      progress = -progress;
    }
    while (next_axis < MEASURES && progress >= fractions[next_axis - BY_TIME] * along) {
      out[next_axis] = Math.abs(upright ? error_y : error_x);
      next_axis += 1;
    }
  }
  out[TIME_AVERAGED] = weighted / weights;
  out[COVERAGE] = answered / (last + 1);
  return SOUND;
}
