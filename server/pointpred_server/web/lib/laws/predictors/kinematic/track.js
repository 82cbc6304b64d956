// Written by `make laws` from track.py: change that and run it again.
import { hypot, larger, smaller } from "../../arithmetic.js";
import * as $submovements from "./submovements.js";
export const SLOW = 0.2;
export const SLOWER = 0.05;
export const SPAN_S = 0.05;
export function advance(s, point, hand, cursor_speed, s_at = 0) {
  const t = point[0];
  const x = point[1];
  const y = point[2];
  const path = point[3];
  const speed = hypot(hand[3], hand[4]);
  const d = hypot(x, y);
  if (x !== s[s_at + 1] || y !== s[s_at + 2]) {
    s[s_at + 28] = t;
  }
  s[s_at + 3] += speed * (t - s[s_at]);
  s[s_at] = t;
  s[s_at + 1] = x;
  s[s_at + 2] = y;
  s[s_at + 4] = larger(s[s_at + 4], d);
  s[s_at + 5] = larger(s[s_at + 5], cursor_speed);
  if (speed > s[s_at + 6]) {
    s[s_at + 6] = speed;
    s[s_at + 7] = t;
    s[s_at + 8] = d;
    s[s_at + 9] = path;
  }
  const push = d > 0 ? (hand[5] * x + hand[6] * y) / d : 0;
  if (push > s[s_at + 10]) {
    s[s_at + 10] = push;
    s[s_at + 11] = t;
  }
  s[s_at + 12] = smaller(s[s_at + 12], push);
  if (speed >= SLOW * s[s_at + 6]) {
    s[s_at + 26] = t;
  }
  if (speed >= SLOWER * s[s_at + 6]) {
    s[s_at + 27] = t;
  }
  $submovements.divide(s, point, speed, s[s_at + 6], s_at + 13);
}
