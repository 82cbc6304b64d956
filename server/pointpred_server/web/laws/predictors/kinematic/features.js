// Written by `make laws` from features.py: change that and run it again.
import { hypot, larger, smaller } from "../../arithmetic.js";
import * as $history from "./history.js";
import * as $submovements from "./submovements.js";
import * as $track from "./track.js";
import * as $minimum_jerk from "../minimum_jerk.js";
import * as $predictors_movement from "../movement.js";
import * as $records from "../../records.js";
export const LAGS_S = [0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5];
export const LOG_REACH = 0;
export const LOG_TIME = 1;
export const TIME = 2;
export const DISTANCE = 3;
export const STRAIGHTNESS = 4;
export const RETURN = 5;
export const CURSOR_PEAK = 6;
export const LOG_PEAK = 7;
export const LOG_SPEED = 8;
export const V_ALONG = 9;
export const A_ALONG = 10;
export const SPEED_OF_PEAK = 11;
export const V_ALIGNED = 12;
export const SINCE_PEAK = 13;
export const PEAK_SHARE = 14;
export const PEAK_TIME = 15;
export const PEAK_DISTANCE = 16;
export const PEAK_PATH = 17;
export const MEAN_OF_PEAK = 18;
export const PUSH = 19;
export const BRAKE = 20;
export const SINCE_PUSH = 21;
export const SUBS = 22;
export const SINCE_SUB = 23;
export const SUB_PEAK = 24;
export const SPEED_OF_SUB = 25;
export const SINCE_SUB_PEAK = 26;
export const FALLING = 27;
export const SUB_ALONG = 28;
export const SUB_PATH = 29;
export const JERK_AHEAD = 30;
export const SUB_JERK_AHEAD = 31;
export const SLOW_FOR = 32;
export const SLOWER_FOR = 33;
export const STILL_FOR = 34;
export const LOG_MEAN = 35;
export const STOP_TIME = 36;
export const STOP_WAY = 37;
export const LAG_ALONG = 38;
export const ODD = 50;
export const V_ACROSS = 50;
export const A_ACROSS = 51;
export const SUB_ACROSS = 52;
export const LAG_ACROSS = 53;
export const FEATURES = 65;
export const REACH_S = 0.06;
export const SOON_S = 0.1;
export const TRACK = 9;
export const TRACK_BEFORE = 38;
export const HEAD_BEFORE = 67;
export const HISTORY = 71;
export function ahead(ratio) {
  const values_1 = $minimum_jerk.progress(ratio);
  const done = values_1[1];
  return (1 - done) / done;
}
export function direction(x, y, vx, vy) {
  const d = hypot(x, y);
  if (d > 0) {
    return [x / d, y / d];
  }
  const speed = hypot(vx, vy);
  if (speed > 0) {
    return [vx / speed, vy / speed];
  }
  return [1, 0];
}
export function frame_of(memory, at, point, m) {
  const values_1 = direction(point[1], point[2], m[3], m[4]);
  const ux = values_1[0];
  const uy = values_1[1];
  if (!(point[3] > 0)) {
    return [0, 0, ux, uy];
  }
  const reach = point[3] + REACH_S * memory[at + $track.CURSOR_PEAK];
  return [reach, memory[at + $track.WAY] + REACH_S * memory[at + $track.PEAK] + 0.0001, ux, uy];
}
export function fill_shape(memory, at, point, frame, out) {
  const t = point[0];
  const x = point[1];
  const y = point[2];
  const path = point[3];
  const reach = frame[0];
  const hand = frame[1];
  const sub = at + $track.SUBMOVEMENT;
  const d = hypot(x, y);
  const peak = memory[at + $track.PEAK] + 1e-09;
  out[LOG_REACH] = Math.log(hand);
  out[LOG_TIME] = Math.log(t + 0.02);
  out[TIME] = t;
  out[DISTANCE] = d / reach;
  out[STRAIGHTNESS] = d / path;
  out[RETURN] = d / larger(memory[at + $track.FAR], 1e-09);
  out[CURSOR_PEAK] = memory[at + $track.CURSOR_PEAK] * SOON_S / reach;
  out[LOG_PEAK] = Math.log(memory[at + $track.PEAK] + 0.0003);
  out[SINCE_PEAK] = t - memory[at + $track.PEAK_T];
  out[PEAK_SHARE] = memory[at + $track.PEAK_T] / (t + 0.001);
  out[PEAK_TIME] = memory[at + $track.PEAK_T];
  out[PEAK_DISTANCE] = memory[at + $track.PEAK_D] / reach;
  out[PEAK_PATH] = memory[at + $track.PEAK_PATH] / path;
  out[MEAN_OF_PEAK] = memory[at + $track.WAY] / (t + 0.001) / peak;
  out[PUSH] = memory[at + $track.PUSH] * SOON_S * 0.1 / hand;
  out[BRAKE] = memory[at + $track.BRAKE] * SOON_S * 0.1 / hand;
  out[SINCE_PUSH] = t - memory[at + $track.PUSH_T];
  out[SUBS] = smaller(memory[sub + $submovements.COUNT], 6);
  out[SINCE_SUB] = t - memory[sub + $submovements.T];
  out[SUB_PEAK] = memory[sub + $submovements.PEAK] / peak;
  out[SINCE_SUB_PEAK] = t - memory[sub + $submovements.PEAK_T];
  out[FALLING] = memory[sub + $submovements.FALLING];
  out[SUB_PATH] = (path - memory[sub + $submovements.PATH]) / reach;
  out[SLOW_FOR] = t - memory[at + $track.FAST_T];
  out[SLOWER_FOR] = t - memory[at + $track.MOVING_T];
  out[STILL_FOR] = t - memory[at + $track.MOVED_T];
  out[LOG_MEAN] = Math.log(memory[at + $track.WAY] / (t + 0.01) + 0.0003);
}
export function fill_pace(memory, at, point, m, frame, out) {
  const reach = frame[0];
  const hand = frame[1];
  const ux = frame[2];
  const uy = frame[3];
  const sub = at + $track.SUBMOVEMENT;
  const sub_x = point[1] - memory[sub + $submovements.X];
  const sub_y = point[2] - memory[sub + $submovements.Y];
  const peak = memory[at + $track.PEAK] + 1e-09;
  const sub_peak = memory[sub + $submovements.PEAK] + 1e-09;
  const v = hypot(m[3], m[4]);
  const v_along = m[3] * ux + m[4] * uy;
  const a_along = m[5] * ux + m[6] * uy;
  out[LOG_SPEED] = Math.log(v + 0.003);
  out[V_ALONG] = v_along * SOON_S / hand;
  out[A_ALONG] = a_along * SOON_S * 0.1 / hand;
  out[SPEED_OF_PEAK] = v / peak;
  out[V_ALIGNED] = v_along / (v + 1e-06);
  out[SPEED_OF_SUB] = v / sub_peak;
  const of_peak = point[0] > memory[at + $track.PEAK_T] ? v / peak : 1;
  const of_sub = point[0] > memory[sub + $submovements.PEAK_T] ? v / sub_peak : 1;
  out[JERK_AHEAD] = ahead(of_peak) * hypot(point[1], point[2]) / reach;
  out[SUB_JERK_AHEAD] = ahead(of_sub) * hypot(sub_x, sub_y) / reach;
  const braking = larger(-a_along, 0.001);
  out[STOP_TIME] = smaller(1, larger(-1, v_along / braking));
  out[STOP_WAY] = smaller(4, v_along * v_along / (2 * braking) / hand);
  out[SUB_ALONG] = (sub_x * ux + sub_y * uy) / reach;
  out[SUB_ACROSS] = (sub_y * ux - sub_x * uy) / reach;
  out[V_ACROSS] = (m[4] * ux - m[3] * uy) * SOON_S / hand;
  out[A_ACROSS] = (m[6] * ux - m[5] * uy) * SOON_S * 0.1 / hand;
}
export function fill_lags(memory, at, point, frame, out) {
  const reach = frame[0];
  const ux = frame[2];
  const uy = frame[3];
  for (let i = 0, end_1 = LAGS_S.length; i < end_1; i++) {
    const values_2 = $history.past(memory, at, point, LAGS_S[i]);
    const past_x = values_2[0];
    const past_y = values_2[1];
    const lag_x = point[1] - past_x;
    const lag_y = point[2] - past_y;
    out[LAG_ALONG + i] = (lag_x * ux + lag_y * uy) / reach;
    out[LAG_ACROSS + i] = (lag_y * ux - lag_x * uy) / reach;
  }
}
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
  const started = memory[at];
  const last_t = memory[at + 1];
  const values_1 = $predictors_movement.follow(memory, m, at);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return [fault, [0, 0, 0, 0]];
  }
  if (new_ || m[0] === memory[at + 4]) {
    memory.fill(0, at + TRACK, at + HISTORY);
    $history.begin(memory, at + HISTORY);
  } else {
    rewind(memory, at, started === 1 && m[0] === last_t);
  }
  const here = at + TRACK;
  const last = [memory[here + $track.T], memory[here + $track.X], memory[here + $track.Y]];
  const t0 = memory[at + 4];
  const x0 = memory[at + 5];
  const y0 = memory[at + 6];
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
  const frame = frame_of(memory, here, point, m);
  if (frame[0] > 0) {
    fill_shape(memory, here, point, frame, out);
    fill_pace(memory, here, point, m, frame, out);
    fill_lags(memory, at + HISTORY, point, frame, out);
  }
  return [$records.FINE, frame];
}
