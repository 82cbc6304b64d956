// Written by `make laws` from features.py: change that and run it again.
import { hypot, larger, smaller } from "../../arithmetic.js";
import * as $history from "./history.js";
import * as $track from "./track.js";
import * as $minimum_jerk from "../minimum_jerk.js";
import * as $predictors_movement from "../movement.js";
import * as $records from "../../records.js";
export const LAGS_S = [0.01, 0.02, 0.03, 0.045, 0.065, 0.09, 0.12, 0.16, 0.21, 0.28, 0.37, 0.5];
export const ODD = 50;
export const REACH_S = 0.06;
export const SOON_S = 0.1;
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
export function frame_of(s, point, m, s_at = 0) {
  const values_1 = direction(point[1], point[2], m[3], m[4]);
  const ux = values_1[0];
  const uy = values_1[1];
  if (!(point[3] > 0)) {
    return [0, 0, ux, uy];
  }
  const reach = point[3] + REACH_S * s[s_at + 5];
  return [reach, s[s_at + 3] + REACH_S * s[s_at + 6] + 0.0001, ux, uy];
}
export function fill_shape(s, point, frame, out, s_at = 0, out_at = 0) {
  const t = point[0];
  const x = point[1];
  const y = point[2];
  const path = point[3];
  const reach = frame[0];
  const hand = frame[1];
  const sub_at = s_at + 13;
  const d = hypot(x, y);
  const peak = s[s_at + 6] + 1e-09;
  out[out_at] = Math.log(hand);
  out[out_at + 1] = Math.log(t + 0.02);
  out[out_at + 2] = t;
  out[out_at + 3] = d / reach;
  out[out_at + 4] = d / path;
  out[out_at + 5] = d / larger(s[s_at + 4], 1e-09);
  out[out_at + 6] = s[s_at + 5] * SOON_S / reach;
  out[out_at + 7] = Math.log(s[s_at + 6] + 0.0003);
  out[out_at + 13] = t - s[s_at + 7];
  out[out_at + 14] = s[s_at + 7] / (t + 0.001);
  out[out_at + 15] = s[s_at + 7];
  out[out_at + 16] = s[s_at + 8] / reach;
  out[out_at + 17] = s[s_at + 9] / path;
  out[out_at + 18] = s[s_at + 3] / (t + 0.001) / peak;
  out[out_at + 19] = s[s_at + 10] * SOON_S * 0.1 / hand;
  out[out_at + 20] = s[s_at + 12] * SOON_S * 0.1 / hand;
  out[out_at + 21] = t - s[s_at + 11];
  out[out_at + 22] = smaller(s[sub_at], 6);
  out[out_at + 23] = t - s[sub_at + 1];
  out[out_at + 24] = s[sub_at + 5] / peak;
  out[out_at + 26] = t - s[sub_at + 6];
  out[out_at + 27] = s[sub_at + 7];
  out[out_at + 29] = (path - s[sub_at + 4]) / reach;
  out[out_at + 32] = t - s[s_at + 26];
  out[out_at + 33] = t - s[s_at + 27];
  out[out_at + 34] = t - s[s_at + 28];
  out[out_at + 35] = Math.log(s[s_at + 3] / (t + 0.01) + 0.0003);
}
export function fill_pace(s, point, m, frame, out, s_at = 0, out_at = 0) {
  const reach = frame[0];
  const hand = frame[1];
  const ux = frame[2];
  const uy = frame[3];
  const sub_at = s_at + 13;
  const sub_x = point[1] - s[sub_at + 2];
  const sub_y = point[2] - s[sub_at + 3];
  const peak = s[s_at + 6] + 1e-09;
  const sub_peak = s[sub_at + 5] + 1e-09;
  const v = hypot(m[3], m[4]);
  const v_along = m[3] * ux + m[4] * uy;
  const a_along = m[5] * ux + m[6] * uy;
  out[out_at + 8] = Math.log(v + 0.003);
  out[out_at + 9] = v_along * SOON_S / hand;
  out[out_at + 10] = a_along * SOON_S * 0.1 / hand;
  out[out_at + 11] = v / peak;
  out[out_at + 12] = v_along / (v + 1e-06);
  out[out_at + 25] = v / sub_peak;
  const of_peak = point[0] > s[s_at + 7] ? v / peak : 1;
  const of_sub = point[0] > s[sub_at + 6] ? v / sub_peak : 1;
  out[out_at + 30] = ahead(of_peak) * hypot(point[1], point[2]) / reach;
  out[out_at + 31] = ahead(of_sub) * hypot(sub_x, sub_y) / reach;
  const braking = larger(-a_along, 0.001);
  out[out_at + 36] = smaller(1, larger(-1, v_along / braking));
  out[out_at + 37] = smaller(4, v_along * v_along / (2 * braking) / hand);
  out[out_at + 28] = (sub_x * ux + sub_y * uy) / reach;
  out[out_at + 52] = (sub_y * ux - sub_x * uy) / reach;
  out[out_at + 50] = (m[4] * ux - m[3] * uy) * SOON_S / hand;
  out[out_at + 51] = (m[6] * ux - m[5] * uy) * SOON_S * 0.1 / hand;
}
export function fill_lags(s, point, frame, out, s_at = 0, out_at = 0) {
  const reach = frame[0];
  const ux = frame[2];
  const uy = frame[3];
  for (let i = 0, end_1 = LAGS_S.length; i < end_1; i++) {
    const values_2 = $history.past(s, point, LAGS_S[i], s_at);
    const past_x = values_2[0];
    const past_y = values_2[1];
    const lag_x = point[1] - past_x;
    const lag_y = point[2] - past_y;
    out[out_at + i + 38] = (lag_x * ux + lag_y * uy) / reach;
    out[out_at + i + 53] = (lag_y * ux - lag_x * uy) / reach;
  }
}
export function rewind(s, again, s_at = 0) {
  const now_at = s_at + 9;
  const before_at = s_at + 38;
  for (let i = 0; i < 29; i++) {
    if (again) {
      s[now_at + i] = s[before_at + i];
    } else {
      s[before_at + i] = s[now_at + i];
    }
  }
  const head_at = s_at + 71;
  const head_before_at = s_at + 67;
  for (let i = 0; i < 4; i++) {
    if (again) {
      s[head_at + i] = s[head_before_at + i];
    } else {
      s[head_before_at + i] = s[head_at + i];
    }
  }
}
export function follow(s, m, s_at = 0) {
  const started = s[s_at];
  const last_t = s[s_at + 1];
  const values_1 = $predictors_movement.follow(s, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  if (fault !== $records.FINE) {
    return [fault, [0, 0, 0, 0]];
  }
  if (new_ || m[0] === s[s_at + 4]) {
    s.fill(0, s_at + 9, s_at + 38);
    s.fill(0, s_at + 38, s_at + 71);
    $history.begin(s, s_at + 71);
  } else {
    rewind(s, started === 1 && m[0] === last_t, s_at);
  }
  const last = [s[s_at + 9], s[s_at + 10], s[s_at + 11]];
  const now = [m[0] - s[s_at + 4], m[1] - s[s_at + 5], m[2] - s[s_at + 6]];
  const point = $history.extend(s, last, now, s_at + 71);
  const values_2 = $history.past(s, point, $track.SPAN_S, s_at + 71);
  const path_before = values_2[2];
  $track.advance(s, point, m, (point[3] - path_before) / $track.SPAN_S, s_at + 9);
  return [$records.FINE, point];
}
export function observe(s, m, out, s_at = 0, out_at = 0) {
  const values_1 = follow(s, m, s_at);
  const fault = values_1[0];
  const point = values_1[1];
  if (fault !== $records.FINE) {
    return [fault, [0, 0, 0, 0]];
  }
  const frame = frame_of(s, point, m, s_at + 9);
  if (frame[0] > 0) {
    fill_shape(s, point, frame, out, s_at + 9, out_at);
    fill_pace(s, point, m, frame, out, s_at + 9, out_at);
    fill_lags(s, point, frame, out, s_at + 71, out_at);
  }
  return [$records.FINE, frame];
}
