// Written by `make laws` from plan.py: change that and run it again.
import { hypot, larger, smaller } from "../arithmetic.js";
export const PATIENCE_S = 5;
export const SMALLEST_PIECE_S = 0.16;
export const LATER_PIECE = 0.65;
export const MOST_AIM_OFF = 0.33;
export const FURTHER_PIECE = 0.55;
export function varied(spread, normal) {
  return Math.exp(spread * smaller(larger(normal, -2.5), 2.5));
}
export function plan_piece(settings, traits, draws, number, first_s, settings_at = 0, traits_at = 0, draws_at = 0) {
  const piece_at = settings_at + number * 6 + 31;
  const d_at = draws_at + number * 7 + 8;
  const last = number === Math.trunc(draws[draws_at + 7]) - 1;
  const share = last ? traits[traits_at + 4] + traits[traits_at + 5] * draws[d_at] : 0.6 + (0.88 - 0.6) * draws[d_at];
  let duration = first_s * (number === 0 ? 1 : LATER_PIECE) * varied(0.1, draws[d_at + 1]);
  duration = larger(duration, SMALLEST_PIECE_S);
  let until = 0.78 + (0.94 - 0.78) * draws[d_at + 5];
  if (!last) {
    until = 0.9 + (1 - 0.9) * draws[d_at + 5] + traits[traits_at + 10] * draws[d_at + 6] / duration;
  }
  settings[piece_at] = larger(share, 0.3);
  settings[piece_at + 1] = duration;
  settings[piece_at + 2] = smaller(larger(traits[traits_at + 8] + 0.08 * draws[d_at + 2], -0.2), 0.6);
  settings[piece_at + 3] = traits[traits_at + 6] * draws[d_at + 3];
  settings[piece_at + 4] = traits[traits_at + 7] + 0.4 * traits[traits_at + 6] * draws[d_at + 4];
  settings[piece_at + 5] = smaller(until, 1.6);
}
export function plan(settings, traits, draws, x, y, width, settings_at = 0, traits_at = 0, draws_at = 0) {
  settings[settings_at + 14] = traits[traits_at + 13] * varied(0.05, draws[draws_at]);
  settings[settings_at + 16] = traits[traits_at + 14] * varied(0.08, draws[draws_at + 1]);
  settings[settings_at + 17] = traits[traits_at + 16];
  settings[settings_at + 18] = traits[traits_at + 15];
  settings[settings_at + 19] = traits[traits_at + 17];
  settings[settings_at + 20] = traits[traits_at + 18];
  settings[settings_at + 21] = x;
  settings[settings_at + 22] = y;
  settings[settings_at + 23] = 0.5 * width;
  const off_x = draws[draws_at + 2] * traits[traits_at + 19] * width;
  const off_y = draws[draws_at + 3] * traits[traits_at + 19] * width;
  const shrink = smaller(1, MOST_AIM_OFF * width / larger(hypot(off_x, off_y), 1e-09));
  settings[settings_at + 24] = x + shrink * off_x;
  settings[settings_at + 25] = y + shrink * off_y;
  settings[settings_at + 26] = traits[traits_at + 9] * varied(0.18, draws[draws_at + 4]);
  settings[settings_at + 27] = traits[traits_at + 11] * varied(0.25, draws[draws_at + 5]);
  settings[settings_at + 28] = traits[traits_at + 12] * varied(0.15, draws[draws_at + 6]);
  settings[settings_at + 29] = PATIENCE_S;
  settings[settings_at + 30] = draws[draws_at + 7];
  const first_s = traits[traits_at + 1] + traits[traits_at + 2] * Math.log2(hypot(x, y) / width + 1);
  for (let number = 0, end_1 = Math.trunc(draws[draws_at + 7]); number < end_1; number++) {
    plan_piece(settings, traits, draws, number, first_s, settings_at, traits_at, draws_at);
  }
}
