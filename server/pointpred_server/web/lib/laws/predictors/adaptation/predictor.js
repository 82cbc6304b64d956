// Written by `make laws` from predictor.py: change that and run it again.
import { hypot, larger } from "../../arithmetic.js";
import * as $correction from "./correction.js";
import * as $destination from "./destination.js";
import * as $places from "./places.js";
import * as $kinematic_predictor from "../kinematic/predictor.js";
import * as $stage from "../../stage.js";
export const X = 0;
export const Y = 1;
export const P = 2;
export const BEFORE = 3;
export const VISITS = 4;
export const NUMBER = 5;
export const SPREAD = 6;
export const ADAPT_OF = 0;
export function sizes(values) {
  const learned = values[ADAPT_OF] === 1 ? 628 : 0;
  return [11, learned, 3949 - 11 - learned];
}
export function conclude(memory, memory_at = 0) {
  const settings_at = memory_at;
  if (memory[settings_at] === 1) {
    $correction.conclude(memory, memory, memory, settings_at + 1, memory_at + 11, memory_at + 912);
    const scene_at = settings_at + 5;
    const after_at = settings_at + 8;
    const value_1 = memory[after_at];
    const value_2 = memory[after_at + 1];
    const value_3 = memory[after_at + 2];
    memory[scene_at] = value_1;
    memory[scene_at + 1] = value_2;
    memory[scene_at + 2] = value_3;
  }
}
export function pace_of(own, m, own_at = 0) {
  const of_peak = own[own_at + 15] > 0 ? hypot(m[3], m[4]) / own[own_at + 15] : 0;
  return [of_peak, m[0] - own[own_at + 4] - own[own_at + 35]];
}
export function step(memory, motion, coefficients, memory_at = 0, coefficients_at = 0) {
  const m = motion;
  const own_at = memory_at + 639;
  const answer = $kinematic_predictor.step(memory, motion, coefficients, own_at, coefficients_at);
  if (memory[memory_at] === 0 || answer[0] !== answer[0]) {
    return answer;
  }
  if (m[8] === 1) {
    conclude(memory, memory_at);
  }
  const start = [memory[own_at + 4], memory[own_at + 5], memory[own_at + 6]];
  $correction.follow(memory, [m[0], m[1], m[2]], start, memory_at + 912);
  const settings_at = memory_at + 1;
  const pace = pace_of(memory, m, own_at);
  return $correction.adapt(memory, memory, memory, answer, pace, settings_at, memory_at + 11, memory_at + 912);
}
export function enter_scene(memory, scene, memory_at = 0) {
  const now_at = memory_at + 5;
  const after_at = memory_at + 8;
  memory[after_at] = scene[0];
  memory[after_at + 1] = scene[1];
  memory[after_at + 2] = scene[2];
  if (memory[memory_at] === 0 || memory[memory_at + 912] === 0) {
    memory[now_at] = scene[0];
    memory[now_at + 1] = scene[1];
    memory[now_at + 2] = scene[2];
  }
}
export function last_end(held, key, held_at = 0) {
  for (let age = 0; age < $places.MOVEMENTS; age++) {
    const number = $places.visited(held, age, held_at);
    const place_at = held_at + larger(number, 0) * 4 + 2;
    if (number >= 0 && held[place_at] === key) {
      return [held[place_at + 1], held[place_at + 2]];
    }
  }
  return [0, 0];
}
export function list_places(memory, out, memory_at = 0) {
  const settings_at = memory_at + 1;
  const person_at = memory_at + 11;
  const going_at = memory_at + 3770;
  if (memory[memory_at] === 0 || memory[settings_at + 2] === 0) {
    return 0;
  }
  const scene_at = settings_at + 4;
  const held_at = person_at + 217;
  const waits = memory[going_at] === 0;
  let start = [memory[memory_at + 914] - memory[scene_at + 1], memory[memory_at + 915] - memory[scene_at + 2]];
  if (waits) {
    if (memory[memory_at + 912] === 0) {
      start = last_end(memory, memory[scene_at], held_at);
    }
    $correction.prepare(memory, memory, memory, start, settings_at, person_at, going_at);
  }
  let count = 0;
  for (let i = 0, end_1 = Math.trunc(memory[held_at]); i < end_1; i++) {
    const place_at = held_at + i * 4 + 2;
    if (memory[place_at] === memory[scene_at]) {
      const before = memory[going_at + 1] * memory[going_at + i + 4];
      out[count][X] = memory[place_at + 1] + memory[scene_at + 1];
      out[count][Y] = memory[place_at + 2] + memory[scene_at + 2];
      out[count][P] = waits ? before : memory[going_at + i + 68];
      out[count][BEFORE] = before;
      out[count][VISITS] = memory[place_at + 3];
      out[count][NUMBER] = i;
      out[count][SPREAD] = $destination.spread_of(memory, start, memory[place_at + 1], memory[place_at + 2], going_at);
      count += 1;
    }
  }
  if (waits) {
    memory.fill(0, going_at, going_at + 133);
  }
  return count;
}
export function write_mixture(memory, memory_at = 0) {
  const settings_at = memory_at;
  const now_at = memory_at + 3903;
  if (memory[settings_at] === 0 || memory[settings_at + 3] === 0 || memory[now_at] === 0) {
    return false;
  }
  $correction.write_mixture(memory, memory, memory, memory, settings_at + 1, memory_at + 11, memory_at + 912, now_at + 8);
  return true;
}
export function list_parts(memory, out, memory_at = 0) {
  if (!write_mixture(memory, memory_at)) {
    return [0, 0, 0];
  }
  const asked_at = memory_at + 3911;
  for (let k = 0, end_1 = Math.trunc(memory[asked_at]); k < end_1; k++) {
    for (let i = 0; i < 7; i++) {
      out[k][i] = memory[asked_at + k * 7 + i + 1];
    }
  }
  return [Math.trunc(memory[asked_at]), memory[asked_at + 36], memory[asked_at + 37]];
}
export const AdaptiveKinematicPredictor = {
  step: step,
  conclude: conclude,
  fill: $stage.copy_values,
  sizes: sizes,
  fault: $correction.fault,
  enter_scene: enter_scene,
  list_places: list_places,
  list_parts: list_parts,
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
