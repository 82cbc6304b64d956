// Written by `make laws` from ktm.py: change that and run it again.
import { hypot, larger, remainder, smaller } from "../arithmetic.js";
import * as $predictors_movement from "./movement.js";
import * as $records from "../records.js";
export const RATE_HZ = 20;
export const STEP_S = 0.05;
export const STAMP_S = 1e-06;
export const TAPS = 22;
export const KERNEL = [1, 0.9898478033787338, 0.9600054412854777, 0.9122540768285452, 0.8493658165683124, 0.7748374288832494, 0.6925693242051978, 0.6065306597126334, 0.5204501210207021, 0.43756473770026916, 0.360447788597821, 0.2909238070461482, 0.23006629899380912, 0.17826397958504792, 0.1353352832366127, 0.10066889977289781, 0.0733696513683829, 0.0523931410698256, 0.036658041953378, 0.025130488985274403, 0.01687988414878991, 0.011108996538242306];
export const POINTS_LEAST = 4;
export const TEMPLATES_OF = 0;
export const LONGEST_OF = 1;
export const SHORTEST_OF = 2;
export function samples_of(longest_s) {
  return Math.trunc((longest_s + STAMP_S) / STEP_S) + 1;
}
export function fill(values, settings, settings_at = 0) {
  settings[settings_at] = values[TEMPLATES_OF];
  settings[settings_at + 1] = 0;
  settings[settings_at + 2] = samples_of(values[LONGEST_OF]);
  settings[settings_at + 3] = values[SHORTEST_OF];
  for (let k = 0; k < TAPS; k++) {
    settings[settings_at + k + 4] = KERNEL[k];
  }
}
export function sizes(values) {
  const templates = Math.trunc(values[TEMPLATES_OF]);
  const longest = samples_of(values[LONGEST_OF]);
  const states = 35 + longest + templates * 25;
  if (templates === 0) {
    return [26, 0, states + 2];
  }
  return [26, templates * (2 + longest) + 2, states];
}
export function place_of_template(settings, k, settings_at = 0) {
  return k * (2 + Math.trunc(settings[settings_at + 2]));
}
export function place_of_learned(settings, settings_at = 0) {
  return place_of_template(settings, Math.trunc(settings[settings_at + 1]) + Math.trunc(settings[settings_at]), settings_at);
}
export function template_count(memory, memory_at = 0) {
  const learned_at = memory_at + place_of_learned(memory, memory_at) + 26;
  return Math.trunc(memory[memory_at + 1]) + Math.trunc(memory[learned_at]);
}
export function score(settings, n, speed, own, template, match, settings_at = 0, template_at = 0, match_at = 0) {
  const length = Math.trunc(template[template_at]);
  const difference = n < length ? speed - template[template_at + n + 2] : speed;
  match[match_at + 1] += Math.abs(match[match_at + 3]);
  let total = match[match_at + 1];
  const oldest = larger(0, TAPS - 1 - n);
  for (let k = oldest, end_1 = TAPS - 1; k < end_1; k++) {
    match[match_at + k + 3] = match[match_at + k + 4] + settings[settings_at + (TAPS - 1 - k) + 4] * difference;
    total += Math.abs(match[match_at + k + 3]);
  }
  let newest = own;
  if (n < length) {
    for (let k = oldest; k < TAPS; k++) {
      newest -= settings[settings_at + (TAPS - 1 - k) + 4] * template[template_at + (n - (TAPS - 1)) + k + 2];
    }
  }
  match[match_at + (TAPS - 1) + 3] = newest;
  match[match_at + 2] = (total + Math.abs(newest)) / (n + 1);
}
export function sample(memory, s, speed, memory_at = 0, s_at = 0) {
  const settings_at = memory_at;
  const samples_at = s_at + 9;
  const n = Math.trunc(s[samples_at + 1]);
  const longest = Math.trunc(memory[settings_at + 2]);
  for (let k = 0, end_1 = TAPS - 1; k < end_1; k++) {
    s[samples_at + k + 4] = s[samples_at + k + 5];
  }
  s[samples_at + (TAPS - 1) + 4] = speed;
  if (n < longest) {
    s[s_at + n + 35] = speed;
  }
  let own = 0;
  for (let k = 0; k < TAPS; k++) {
    own += memory[settings_at + (TAPS - 1 - k) + 4] * s[samples_at + k + 4];
  }
  for (let j = 0, end_2 = template_count(memory, memory_at); j < end_2; j++) {
    const template_at = memory_at + place_of_template(memory, j, settings_at) + 26;
    score(memory, n, speed, own, memory, s, settings_at, template_at, s_at + longest + j * 25 + 35);
  }
  s[samples_at + 1] = n + 1;
}
export function winner(memory, s, times, memory_at = 0, s_at = 0) {
  let best = -1;
  let lowest = 0;
  for (let j = 0, end_1 = template_count(memory, memory_at); j < end_1; j++) {
    const match_at = s_at + Math.trunc(memory[memory_at + 2]) + j * 25 + 35;
    s[match_at] += times * s[match_at + 2];
    if (best < 0 || s[match_at] < lowest) {
      best = j;
      lowest = s[match_at];
    }
  }
  return best;
}
export function keep(memory, s, distance, memory_at = 0, s_at = 0) {
  const settings_at = memory_at;
  const most = Math.trunc(memory[settings_at]);
  const samples = Math.trunc(s[s_at + 10]);
  if (most === 0 || s[s_at + 9] < POINTS_LEAST || !(2 <= samples && samples <= memory[settings_at + 2])) {
    return;
  }
  if (!(distance >= memory[settings_at + 3])) {
    return;
  }
  const learned_at = memory_at + place_of_learned(memory, settings_at) + 26;
  const template_at = memory_at + place_of_template(memory, Math.trunc(memory[settings_at + 1]) + Math.trunc(memory[learned_at + 1]), settings_at) + 26;
  memory[template_at] = samples;
  memory[template_at + 1] = distance;
  for (let k = 0, end_1 = Math.trunc(memory[settings_at + 2]); k < end_1; k++) {
    memory[template_at + k + 2] = s[s_at + k + 35];
  }
  memory[learned_at + 1] = remainder(memory[learned_at + 1] + 1, most);
  memory[learned_at] = smaller(memory[learned_at] + 1, most);
}
export function forget(settings, s, settings_at = 0, s_at = 0) {
  s.fill(0, s_at + 9, s_at + 35);
  const matches = Math.trunc(settings[settings_at + 1]) + Math.trunc(settings[settings_at]);
  s.fill(0, s_at + 35, s_at + Math.trunc(settings[settings_at + 2]) + matches * 25 + 35);
}
export function distance(s, s_at = 0) {
  return hypot(s[s_at + 2] - s[s_at + 5], s[s_at + 3] - s[s_at + 6]);
}
export function conclude(memory, memory_at = 0) {
  const s_at = memory_at + place_of_learned(memory, memory_at) + 28;
  keep(memory, memory, distance(memory, s_at), memory_at, s_at);
}
export function resample(memory, s, since, x_before, y_before, memory_at = 0, s_at = 0) {
  const samples_at = s_at + 9;
  const most = memory[memory_at + 2] + TAPS;
  const now = s[s_at + 1] - s[s_at + 4];
  const x = s[s_at + 2];
  const y = s[s_at + 3];
  let due = s[samples_at + 1] * STEP_S;
  while (due <= now + STAMP_S && s[samples_at + 1] < most) {
    const back = smaller(larger((now - due) / since, 0), 1);
    const grid_x = x + back * (x_before - x);
    const grid_y = y + back * (y_before - y);
    const way = hypot(grid_x - s[samples_at + 2], grid_y - s[samples_at + 3]);
    s[samples_at + 2] = grid_x;
    s[samples_at + 3] = grid_y;
    sample(memory, s, way * RATE_HZ, memory_at, s_at);
    due = s[samples_at + 1] * STEP_S;
  }
}
export function step(memory, motion, memory_at = 0) {
  const m = motion;
  const s_at = memory_at + place_of_learned(memory, memory_at) + 28;
  const last_distance = distance(memory, s_at);
  const x_before = memory[s_at + 2];
  const y_before = memory[s_at + 3];
  const values_1 = $predictors_movement.follow(memory, m, s_at);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, s_at);
  }
  const phase = $predictors_movement.phase(memory, m, s_at);
  if (new_) {
    keep(memory, memory, last_distance, memory_at, s_at);
    forget(memory, memory, memory_at, s_at);
    memory[s_at + 9] = 1;
    sample(memory, memory, 0, memory_at, s_at);
  }
  if (new_ || m[0] === memory[s_at + 4]) {
    memory[s_at + 11] = m[1];
    memory[s_at + 12] = m[2];
  }
  if (dt > 0) {
    memory[s_at + 9] += 1;
    resample(memory, memory, dt, x_before, y_before, memory_at, s_at);
  }
  const away = distance(memory, s_at);
  let best = -1;
  if (memory[s_at + 9] >= POINTS_LEAST) {
    best = winner(memory, memory, dt > 0 ? 1 : 0, memory_at, s_at);
  }
  if (best < 0 || !(away > 0)) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const template_at = memory_at + place_of_template(memory, best, memory_at) + 26;
  const ahead = memory[template_at + 1] / away - 1;
  const x0 = memory[s_at + 5];
  const y0 = memory[s_at + 6];
  return $records.endpoint(m[0], m[1] + ahead * (m[1] - x0), m[2] + ahead * (m[2] - y0), phase);
}
export const TemplatePredictor = {
  step: step,
  conclude: conclude,
  fill: fill,
  sizes: sizes,
  settings: 26, learned: 4034, states: 1696,
  parameters: [
    { name: "templates", low: 0, high: 1000, default: 64, whole: true },
    { name: "longest_s", unit: "s", low: 0.2, high: 30, default: 3 },
    { name: "shortest_px", unit: "px", low: 0, high: 1000000, default: 10 },
  ],
};
