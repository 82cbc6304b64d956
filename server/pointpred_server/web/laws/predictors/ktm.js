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
export const LEARNED_MOST = 0;
export const LIBRARY = 1;
export const LONGEST = 2;
export const SHORTEST_PX = 3;
export const HALF = 4;
export const STORE = 26;
export const LENGTH = 0;
export const DISTANCE = 1;
export const SPEEDS = 2;
export const COUNT = 0;
export const NEXT = 1;
export const LEARNED = 2;
export const POINTS = 9;
export const SAMPLES = 10;
export const GRID_X = 11;
export const GRID_Y = 12;
export const RECENT = 13;
export const PROFILE = 35;
export const SUM = 0;
export const FINAL = 1;
export const SCORE = 2;
export const SMOOTH = 3;
export const MATCH = 25;
export const TEMPLATES_OF = 0;
export const LONGEST_OF = 1;
export const SHORTEST_OF = 2;
export function samples_of(longest_s) {
  return Math.trunc((longest_s + STAMP_S) / STEP_S) + 1;
}
export function fill(values, memory) {
  memory[LEARNED_MOST] = values[TEMPLATES_OF];
  memory[LIBRARY] = 0;
  memory[LONGEST] = samples_of(values[LONGEST_OF]);
  memory[SHORTEST_PX] = values[SHORTEST_OF];
  for (let k = 0; k < TAPS; k++) {
    memory[HALF + k] = KERNEL[k];
  }
}
export function sizes(values) {
  const templates = Math.trunc(values[TEMPLATES_OF]);
  const longest = samples_of(values[LONGEST_OF]);
  const states = PROFILE + longest + templates * MATCH;
  if (templates === 0) {
    return [STORE, 0, states + LEARNED];
  }
  return [STORE, templates * (SPEEDS + longest) + LEARNED, states];
}
export function template(memory, k) {
  return STORE + k * (SPEEDS + Math.trunc(memory[LONGEST]));
}
export function counts(memory) {
  return template(memory, Math.trunc(memory[LIBRARY]) + Math.trunc(memory[LEARNED_MOST]));
}
export function template_count(memory) {
  return Math.trunc(memory[LIBRARY]) + Math.trunc(memory[counts(memory) + COUNT]);
}
export function score(memory, n, speed, own, place, match) {
  const length = Math.trunc(memory[place + LENGTH]);
  const smooth = match + SMOOTH;
  const difference = n < length ? speed - memory[place + SPEEDS + n] : speed;
  memory[match + FINAL] += Math.abs(memory[smooth]);
  let total = memory[match + FINAL];
  const oldest = larger(0, TAPS - 1 - n);
  for (let k = oldest, end_1 = TAPS - 1; k < end_1; k++) {
    memory[smooth + k] = memory[smooth + k + 1] + memory[HALF + TAPS - 1 - k] * difference;
    total += Math.abs(memory[smooth + k]);
  }
  let newest = own;
  if (n < length) {
    for (let k = oldest; k < TAPS; k++) {
      newest -= memory[HALF + TAPS - 1 - k] * memory[place + SPEEDS + n - (TAPS - 1) + k];
    }
  }
  memory[smooth + TAPS - 1] = newest;
  memory[match + SCORE] = (total + Math.abs(newest)) / (n + 1);
}
export function sample(memory, at, speed) {
  const n = Math.trunc(memory[at + SAMPLES]);
  const longest = Math.trunc(memory[LONGEST]);
  const recent = at + RECENT;
  for (let k = 0, end_1 = TAPS - 1; k < end_1; k++) {
    memory[recent + k] = memory[recent + k + 1];
  }
  memory[recent + TAPS - 1] = speed;
  if (n < longest) {
    memory[at + PROFILE + n] = speed;
  }
  let own = 0;
  for (let k = 0; k < TAPS; k++) {
    own += memory[HALF + TAPS - 1 - k] * memory[recent + k];
  }
  for (let j = 0, end_2 = template_count(memory); j < end_2; j++) {
    const place = template(memory, j);
    const match = at + PROFILE + longest + j * MATCH;
    score(memory, n, speed, own, place, match);
  }
  memory[at + SAMPLES] = n + 1;
}
export function winner(memory, at, times) {
  const first = at + PROFILE + Math.trunc(memory[LONGEST]);
  let best = -1;
  for (let j = 0, end_1 = template_count(memory); j < end_1; j++) {
    const match = first + j * MATCH;
    memory[match + SUM] += times * memory[match + SCORE];
    if (best < 0 || memory[match + SUM] < memory[first + best * MATCH + SUM]) {
      best = j;
    }
  }
  return best;
}
export function keep(memory, at, distance) {
  const most = Math.trunc(memory[LEARNED_MOST]);
  const samples = Math.trunc(memory[at + SAMPLES]);
  if (most === 0 || memory[at + POINTS] < POINTS_LEAST || !(2 <= samples && samples <= memory[LONGEST])) {
    return;
  }
  if (!(distance >= memory[SHORTEST_PX])) {
    return;
  }
  const place_of_counts = counts(memory);
  const place = template(memory, Math.trunc(memory[LIBRARY]) + Math.trunc(memory[place_of_counts + NEXT]));
  memory[place + LENGTH] = samples;
  memory[place + DISTANCE] = distance;
  for (let k = 0, end_1 = Math.trunc(memory[LONGEST]); k < end_1; k++) {
    memory[place + SPEEDS + k] = memory[at + PROFILE + k];
  }
  memory[place_of_counts + NEXT] = remainder(memory[place_of_counts + NEXT] + 1, most);
  memory[place_of_counts + COUNT] = smaller(memory[place_of_counts + COUNT] + 1, most);
}
export function distance(memory, at) {
  const away_x = memory[at + 2] - memory[at + 5];
  return hypot(away_x, memory[at + 3] - memory[at + 6]);
}
export function conclude(memory) {
  const at = counts(memory) + LEARNED;
  keep(memory, at, distance(memory, at));
}
export function resample(memory, at, since, x_before, y_before) {
  const most = memory[LONGEST] + TAPS;
  const now = memory[at + 1] - memory[at + 4];
  const x = memory[at + 2];
  const y = memory[at + 3];
  let due = memory[at + SAMPLES] * STEP_S;
  while (due <= now + STAMP_S && memory[at + SAMPLES] < most) {
    const back = smaller(larger((now - due) / since, 0), 1);
    const grid_x = x + back * (x_before - x);
    const grid_y = y + back * (y_before - y);
    const way = hypot(grid_x - memory[at + GRID_X], grid_y - memory[at + GRID_Y]);
    memory[at + GRID_X] = grid_x;
    memory[at + GRID_Y] = grid_y;
    sample(memory, at, way * RATE_HZ);
    due = memory[at + SAMPLES] * STEP_S;
  }
}
export function step(memory, motion) {
  const m = motion;
  const at = counts(memory) + LEARNED;
  const last_distance = distance(memory, at);
  const x_before = memory[at + 2];
  const y_before = memory[at + 3];
  const values_1 = $predictors_movement.follow(memory, m, at);
  const fault = values_1[0];
  const new_ = values_1[1];
  const dt = values_1[2];
  if (fault !== $records.FINE) {
    return $predictors_movement.refuse(memory, m, fault, at);
  }
  const phase = $predictors_movement.phase(memory, m, at);
  if (new_) {
    keep(memory, at, last_distance);
    memory.fill(0, at + 9);
    memory[at + POINTS] = 1;
    sample(memory, at, 0);
  }
  if (new_ || m[0] === memory[at + 4]) {
    memory[at + GRID_X] = m[1];
    memory[at + GRID_Y] = m[2];
  }
  if (dt > 0) {
    memory[at + POINTS] += 1;
    resample(memory, at, dt, x_before, y_before);
  }
  const away = distance(memory, at);
  let best = -1;
  if (memory[at + POINTS] >= POINTS_LEAST) {
    best = winner(memory, at, dt > 0 ? 1 : 0);
  }
  if (best < 0 || !(away > 0)) {
    return $records.endpoint(m[0], NaN, NaN, phase);
  }
  const ahead = memory[template(memory, best) + DISTANCE] / away - 1;
  const x0 = memory[at + 5];
  const y0 = memory[at + 6];
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
