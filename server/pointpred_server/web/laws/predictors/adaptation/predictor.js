// Written by `make laws` from predictor.py: change that and run it again.
import { hypot, larger } from "../../arithmetic.js";
import * as $correction from "./correction.js";
import * as $destination from "./destination.js";
import * as $places from "./places.js";
import * as $kinematic_predictor from "../kinematic/predictor.js";
import * as $stage from "../../stage.js";
export const ADAPT = 0;
export const DISTANCES = 1;
export const SHORTEST_PX = 2;
export const PLACES = 3;
export const SEQUENCE = 4;
export const KEY = 5;
export const ORIGIN_X = 6;
export const ORIGIN_Y = 7;
export const NEXT = 8;
export const PERSON = 11;
export const OBSERVATION = 639;
export const MOVEMENT = 912;
export const LENGTH = 3949;
export const X = 0;
export const Y = 1;
export const P = 2;
export const BEFORE = 3;
export const VISITS = 4;
export const NUMBER = 5;
export const SPREAD = 6;
export function sizes(values) {
  const learned = values[ADAPT] === 1 ? $correction.LEARNED : 0;
  return [PERSON, learned, LENGTH - PERSON - learned];
}
export function parts_of(memory) {
  return [memory[DISTANCES], memory[PLACES], memory[SEQUENCE]];
}
export function scene_of(memory) {
  return [memory[KEY], memory[ORIGIN_X], memory[ORIGIN_Y]];
}
export function conclude(memory) {
  if (memory[ADAPT] === 1) {
    const parts = parts_of(memory);
    const scene = scene_of(memory);
    $correction.conclude(memory, PERSON, MOVEMENT, memory[SHORTEST_PX], parts, scene);
    const value_1 = memory[NEXT];
    const value_2 = memory[NEXT + 1];
    const value_3 = memory[NEXT + 2];
    memory[KEY] = value_1;
    memory[ORIGIN_X] = value_2;
    memory[ORIGIN_Y] = value_3;
  }
}
export function adapt(memory, answer, pace) {
  return $correction.adapt(memory, PERSON, MOVEMENT, parts_of(memory), scene_of(memory), answer, pace);
}
export function pace_of(own, m, own_at = 0) {
  const of_peak = own[own_at + 15] > 0 ? hypot(m[3], m[4]) / own[own_at + 15] : 0;
  return [of_peak, m[0] - own[own_at + 4] - own[own_at + 35]];
}
export function step(memory, motion, coefficients, coefficients_at = 0) {
  const m = motion;
  const own_at = OBSERVATION;
  const answer = $kinematic_predictor.step(memory, motion, coefficients, own_at, coefficients_at);
  if (memory[ADAPT] === 0 || answer[0] !== answer[0]) {
    return answer;
  }
  if (m[8] === 1) {
    conclude(memory);
  }
  const start = [memory[own_at + 4], memory[own_at + 5], memory[own_at + 6]];
  $correction.follow(memory, MOVEMENT, [m[0], m[1], m[2]], start);
  return adapt(memory, answer, pace_of(memory, m, own_at));
}
export function enter_scene(memory, scene) {
  memory[NEXT] = scene[0];
  memory[NEXT + 1] = scene[1];
  memory[NEXT + 2] = scene[2];
  if (memory[ADAPT] === 0 || memory[MOVEMENT + $correction.STARTED] === 0) {
    memory[KEY] = scene[0];
    memory[ORIGIN_X] = scene[1];
    memory[ORIGIN_Y] = scene[2];
  }
}
export function last_end(memory, known, key) {
  for (let age = 0; age < $places.MOVEMENTS; age++) {
    const number = $places.visited(memory, known, age);
    const place = known + $places.PLACES + $places.WIDTH * larger(number, 0);
    if (number >= 0 && memory[place + $places.KEY] === key) {
      return [memory[place + $places.X], memory[place + $places.Y]];
    }
  }
  return [0, 0];
}
export function list_places(memory, out) {
  if (memory[ADAPT] === 0 || memory[PLACES] === 0) {
    return 0;
  }
  const parts = parts_of(memory);
  const scene = scene_of(memory);
  const known = PERSON + $correction.KNOWN;
  const going = MOVEMENT + $correction.DESTINATION;
  const waits = memory[going + $destination.READY] === 0;
  let start = [memory[MOVEMENT + $correction.X0] - scene[1], memory[MOVEMENT + $correction.Y0] - scene[2]];
  if (waits) {
    if (memory[MOVEMENT + $correction.STARTED] === 0) {
      start = last_end(memory, known, scene[0]);
    }
    $correction.prepare(memory, PERSON, going, parts, scene, start);
  }
  let count = 0;
  const returns = memory[going + $destination.RETURNS];
  for (let i = 0, end_1 = Math.trunc(memory[known + $places.COUNT]); i < end_1; i++) {
    const place = known + $places.PLACES + $places.WIDTH * i;
    if (memory[place + $places.KEY] === scene[0]) {
      const x = memory[place + $places.X];
      const y = memory[place + $places.Y];
      const before = returns * memory[going + $destination.BEFORE + i];
      out[count][X] = x + scene[1];
      out[count][Y] = y + scene[2];
      out[count][P] = waits ? before : memory[going + $destination.NOW + i];
      out[count][BEFORE] = before;
      out[count][VISITS] = memory[place + $places.WEIGHT];
      out[count][NUMBER] = i;
      out[count][SPREAD] = $destination.spread_of(memory, going, start, x, y);
      count += 1;
    }
  }
  if (waits) {
    memory.fill(0, going, going + $destination.STATES);
  }
  return count;
}
export const AdaptiveKinematicPredictor = {
  step: step,
  conclude: conclude,
  fill: $stage.copy_values,
  sizes: sizes,
  fault: $correction.fault,
  enter_scene: enter_scene,
  list_places: list_places,
  settings: 11, learned: 628, states: 3310,
  layout: "4302f8b2f3d9b851",
  slots: [
    ...Array.from({ length: 5 }, () => [{ name: "normal equations, diagonal", count: 1, low: 0, high: 1e+30 }, { name: "normal equations, side", count: 1, low: -1e+30, high: 1e+30 }, { name: "normal equations, diagonal", count: 1, low: 0, high: 1e+30 }, { name: "right side", count: 2, low: -1e+30, high: 1e+30 }, { name: "bias", count: 2, low: -1000, high: 1000 }, { name: "bias paid", count: 1, low: -533.8666666666661, high: 533.8666666666661 }, { name: "bias size", count: 1, low: 0, high: 533.8666666666661 }, { name: "movements", count: 1, low: 0, high: 33.36666666666663 }, { name: "squares of the widths", count: 2, low: 0, high: 1e+30 }, { name: "tempo", count: 1, low: -13.346666666666653, high: 13.346666666666653 }, { name: "movements timed", count: 1, low: 0, high: 33.36666666666663 }, { name: "tempo paid", count: 1, low: -660.413498600821, high: 660.413498600821 }, { name: "tempo size", count: 1, low: 0, high: 660.413498600821 }]).flat(),
    { name: "distances held", count: 1, low: 0, high: 12, whole: true },
    { name: "distances", count: 12, low: 0, high: 4000000000 },
    { name: "belief", count: 7, low: 0, high: 1 },
    { name: "weights", count: 36, low: 0, high: 1 },
    { name: "durations held", count: 1, low: 0, high: 12, whole: true },
    { name: "durations", count: 12, low: 0, high: 400000000000 },
    { name: "median", count: 1, low: 0, high: 400000000000 },
    { name: "errors", count: 5, low: 0, high: 1e+30 },
    { name: "movements", count: 1, low: 0, high: 33.36666666666663 },
    { name: "clock's share", count: 1, low: 0, high: 1 },
    { name: "movements judged", count: 1, low: 0, high: 1000000, whole: true },
    ...Array.from({ length: 2 }, () => [{ name: "radii of the levels", count: 10, low: -6, high: 6 }]).flat(),
    { name: "sums of products", count: 28, low: -16015.999999999984, high: 16015.999999999984 },
    { name: "sums of residuals", count: 7, low: -1000000000, high: 1000000000 },
    { name: "movements with intervals", count: 1, low: 0, high: 1000000, whole: true },
    { name: "spreads", count: 3, low: -3, high: 3 },
    { name: "places held", count: 1, low: 0, high: 64, whole: true },
    { name: "movements ended", count: 1, low: 0, high: 131071, whole: true },
    ...Array.from({ length: 64 }, () => [{ name: "key of a place", count: 1, low: 0, high: 9007199254740992, whole: true }, { name: "position of a place", count: 2, low: -4000000000, high: 4000000000 }, { name: "visits of a place", count: 1, low: 0, high: 33.36666666666663 }]).flat(),
    { name: "history", count: 128, low: -1, high: 63, whole: true },
    { name: "visits to known and to new places", count: 2, low: 0, high: 20.01999999999998 },
    { name: "visits as each rule has them", count: 4, low: 0, high: 20.01999999999998 },
    { name: "visits as each width has them", count: 3, low: 0, high: 20.01999999999998 },
    { name: "returns", count: 16, low: 0, high: 20.01999999999998 },
  ],
  parameters: [
    { name: "adapt", low: 0, high: 1, default: 1, whole: true },
    { name: "distances", low: 0, high: 1, default: 1, whole: true },
    { name: "shortest_px", unit: "px", low: 0, high: 1000000, default: 10 },
    { name: "places", low: 0, high: 1, default: 1, whole: true },
    { name: "sequence", low: 0, high: 1, default: 1, whole: true },
  ],
};
