// Written by `make laws` from arrival.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
import * as $adaptation_time_left from "../predictors/adaptation/time_left.js";
export const DIFFICULTY_OF = 4;
export function terms(predicted, since, median, left_px, size_px) {
  const own = smaller(predicted / median, $adaptation_time_left.LONGEST);
  const passed = smaller(since / median, $adaptation_time_left.LONGEST);
  const difficulty = smaller(Math.log(1 + left_px / size_px) / (DIFFICULTY_OF * Math.log(2)), $adaptation_time_left.LONGEST);
  const near = size_px * size_px / (size_px * size_px + left_px * left_px);
  const both = smaller(own * difficulty, $adaptation_time_left.LONGEST);
  const with_clock = smaller(passed * difficulty, $adaptation_time_left.LONGEST);
  return [own, 1, larger(1 - passed, 0), difficulty, both, near, with_clock];
}
