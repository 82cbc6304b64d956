// Written by `make laws` from region_widening.py: change that and run it again.
import { larger, smaller, square, view } from "../../arithmetic.js";
import * as $levels from "./levels.js";
import * as $mixed_region from "./mixed_region.js";
import * as $moments from "./moments.js";
import * as $mixture from "../mixture.js";
import * as $stage from "../../stage.js";
export const JUDGED = 9;
export const LIGHTEST = 0.02;
export const HEAVIEST = 4;
export const HALVINGS = 12;
export const MOVEMENTS_MOST = 1000000;
export const MOST = 48;
export function widen(s, share, tail, s_at = 0) {
  let heavy;
  if (s[s_at] === 0) {
    return [1, tail];
  }
  const heavy_now = $mixture.heaviness(tail);
  const first = $levels.offset(s, share, 0, s_at + 1);
  const second = $levels.offset(s, share, 1, s_at + 1);
  const near = Math.log($mixture.corrected_radius($mixture.LEVELS[0], heavy_now, first) * 2 / heavy_now);
  const far = Math.log($mixture.corrected_radius($mixture.LEVELS[1], heavy_now, second) * 2 / heavy_now);
  const ratio = Math.exp(far - near);
  let low = LIGHTEST;
  let high = HEAVIEST;
  for (let _ = 0; _ < HALVINGS; _++) {
    heavy = 0.5 * (low + high);
    if ($mixture.squared_radius_over_tail($mixture.LEVELS[1], heavy) < ratio * $mixture.squared_radius_over_tail($mixture.LEVELS[0], heavy)) {
      low = heavy;
    } else {
      high = heavy;
    }
  }
  heavy = 0.5 * (low + high);
  const half = $mixture.squared_radius_over_tail($mixture.LEVELS[0], heavy);
  const most = $mixture.squared_radius_over_tail($mixture.LEVELS[1], heavy);
  const both = half * most * square(2 / heavy);
  return [Math.exp(0.5 * (near + far - Math.log(both))), 2 / heavy];
}
export function record(stated, cursor, region, stated_at = 0) {
  const last_at = stated_at + larger(Math.trunc(stated[stated_at]) - 1, 0) * 45 + 4;
  const values_1 = $moments.next_moment(stated, stated[last_at], cursor, MOST, stated_at);
  const number = values_1[0];
  const full = values_1[1];
  if (number < 0) {
    return -1;
  }
  if (full) {
    for (let k = 1; k < number; k++) {
      $stage.copy_values(view(stated, stated_at + 2 * k * 45 + 4, stated_at + 2 * k * 45 + 49), view(stated, stated_at + k * 45 + 4, stated_at + k * 45 + 49));
    }
  }
  const m_at = stated_at + number * 45 + 4;
  stated[m_at] = cursor[0];
  stated[m_at + 1] = region[0];
  stated[m_at + 2] = region[1];
  stated[m_at + 3] = region[2];
  stated[m_at + 4] = region[3];
  stated[m_at + 5] = region[4];
  stated[m_at + 6] = region[5];
  return number;
}
export function probability_within(region, x, y) {
  const centre_x = region[0];
  const centre_y = region[1];
  const sxx = region[2];
  const sxy = region[3];
  const syy = region[4];
  const tail = region[5];
  const dx = x - centre_x;
  const dy = y - centre_y;
  const determinant = sxx * syy - sxy * sxy;
  if (!(determinant > 0)) {
    return 1;
  }
  const far = (syy * dx * dx - 2 * sxy * dx * dy + sxx * dy * dy) / determinant;
  return 1 - Math.exp(-0.5 * tail * Math.log(1 + larger(far, 0) / tail));
}
export function learn(s, stated, place_of_end, span, s_at = 0, stated_at = 0) {
  if (stated[stated_at] === 0) {
    return;
  }
  const x = place_of_end[0];
  const y = place_of_end[1];
  s[s_at] = smaller(s[s_at] + 1, MOVEMENTS_MOST);
  const step = $levels.step_after(s[s_at]);
  let k = 0;
  for (let judged = 1, end_1 = JUDGED + 1; judged < end_1; judged++) {
    const share = judged / (JUDGED + 1);
    while (k + 1 < stated[stated_at] && $moments.has_come(stated, stated[stated_at + (k + 1) * 45 + 4], span, share, stated_at)) {
      k += 1;
    }
    const m_at = stated_at + k * 45 + 4;
    const within = probability_within([stated[m_at + 1], stated[m_at + 2], stated[m_at + 3], stated[m_at + 4], stated[m_at + 5], stated[m_at + 6]], x, y);
    for (let which = 0, end_2 = $mixture.LEVELS.length; which < end_2; which++) {
      $levels.learn(s, share, which, within <= $mixture.LEVELS[which], step, s_at + 1);
    }
    $mixed_region.judge(s, stated, place_of_end, share, step, s_at + 11, m_at + 7);
  }
}
