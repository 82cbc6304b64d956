// Written by `make laws` from arrival.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
import * as $adaptation_time_left from "../predictors/adaptation/time_left.js";
export const DIFFICULTY_OF = 4;
export const KEEP = 0.98;
export const LONGER = 3;
export function mean(s, s_at = 0) {
  return Number(s[s_at + 1] > 0 ? s[s_at] / s[s_at + 1] : 0);
}
export function remember(s, duration, s_at = 0) {
  const most = s[s_at + 1] > 0 ? LONGER * mean(s, s_at) : duration;
  s[s_at] = KEEP * s[s_at] + smaller(duration, most);
  s[s_at + 1] = KEEP * s[s_at + 1] + 1;
}
export function terms(predicted, since, usual, left_px, size_px) {
  const own = smaller(predicted / usual, $adaptation_time_left.LONGEST);
  const passed = smaller(since / usual, $adaptation_time_left.LONGEST);
  const difficulty = smaller(Math.log(1 + left_px / size_px) / (DIFFICULTY_OF * Math.log(2)), $adaptation_time_left.LONGEST);
  const near = size_px * size_px / (size_px * size_px + left_px * left_px);
  const both = smaller(own * difficulty, $adaptation_time_left.LONGEST);
  const with_clock = smaller(passed * difficulty, $adaptation_time_left.LONGEST);
  return [own, 1, larger(1 - passed, 0), difficulty, both, near, with_clock];
}
