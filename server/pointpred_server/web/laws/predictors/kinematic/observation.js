// Written by `make page` from observation.py: change that and run it again.
import * as $features from "./features.js";
import * as $history from "./history.js";
import * as $track from "./track.js";
import * as $predictors_movement from "../movement.js";
import * as $records from "../../records.js";
export const TRACK = 9;
export const TRACK_BEFORE = 38;
export const HEAD_BEFORE = 67;
export const HISTORY = 71;
export function rewind(memory, at, again) {
  const values_1 = again ? [TRACK_BEFORE, HEAD_BEFORE] : [TRACK, HISTORY];
  const source = values_1[0];
  const head = values_1[1];
  const values_2 = again ? [TRACK, HISTORY] : [TRACK_BEFORE, HEAD_BEFORE];
  const target = values_2[0];
  const head_target = values_2[1];
  for (let i = 0; i < $track.STATES; i++) {
    memory[at + target + i] = memory[at + source + i];
  }
  for (let i = 0; i < $history.HEAD; i++) {
    memory[at + head_target + i] = memory[at + head + i];
  }
}
export function follow(memory, at, m) {
  const started = memory[at + $predictors_movement.KNOWN];
  const last_t = memory[at + $predictors_movement.T];
  const values_1 = $predictors_movement.follow(memory, at, m);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return [fault, [0, 0, 0, 0]];
  }
  if (new_ || m[0] === memory[at + $predictors_movement.T0]) {
    memory.fill(0, at + TRACK, at + HISTORY);
    $history.begin(memory, at + HISTORY);
  } else {
    rewind(memory, at, started === 1 && m[0] === last_t);
  }
  const here = at + TRACK;
  const last = [memory[here + $track.T], memory[here + $track.X], memory[here + $track.Y]];
  const t0 = memory[at + $predictors_movement.T0];
  const x0 = memory[at + $predictors_movement.X0];
  const y0 = memory[at + $predictors_movement.Y0];
  const point = $history.extend(memory, at + HISTORY, last, [m[0] - t0, m[1] - x0, m[2] - y0]);
  const values_2 = $history.past(memory, at + HISTORY, point, $track.SPAN_S);
  const path_before = values_2[2];
  $track.advance(memory, here, point, m, (point[3] - path_before) / $track.SPAN_S);
  return [$records.FINE, point];
}
export function observe(memory, at, m, out) {
  const values_1 = follow(memory, at, m);
  const fault = values_1[0];
  const point = values_1[1];
  if (fault !== $records.FINE) {
    return [fault, [0, 0, 0, 0]];
  }
  const here = at + TRACK;
  const frame = $features.frame_of(memory, here, point, m);
  if (frame[0] > 0) {
    $features.fill_shape(memory, here, point, frame, out);
    $features.fill_pace(memory, here, point, m, frame, out);
    $features.fill_lags(memory, at + HISTORY, point, frame, out);
  }
  return [$records.FINE, frame];
}
