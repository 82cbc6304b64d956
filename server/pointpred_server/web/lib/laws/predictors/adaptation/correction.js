// Written by `make laws` from correction.py: change that and run it again.
import { hypot, larger, remainder, smaller } from "../../arithmetic.js";
import * as $destination from "./destination.js";
import * as $distances from "./distances.js";
import * as $durations from "./durations.js";
import * as $habits from "./habits.js";
import * as $mixed_region from "./mixed_region.js";
import * as $moments from "./moments.js";
import * as $places from "./places.js";
import * as $region_widening from "./region_widening.js";
import * as $stages from "./stages.js";
import * as $adaptation_time_left from "./time_left.js";
import * as $time_left_prior from "./time_left_prior.js";
export const TRACE_PLACES = 96;
export const APART_S = 0.005;
export const BIAS_FADE = 0.2;
export const FADE = 0.5;
export const PLACES_FADE = 0.7;
export const EARLY = 0.1;
export const UNEQUAL = 21;
export function fault(learned, learned_at = 0) {
  if (learned[learned_at + 80] !== learned[learned_at + 136]) {
    return [UNEQUAL, learned[learned_at + 80]];
  }
  const values_1 = $distances.fault(learned, learned_at + 80);
  let wrong = values_1[0];
  let value = values_1[1];
  if (wrong !== $distances.FINE) {
    return [wrong, value];
  }
  const values_2 = $durations.fault(learned, learned_at + 136);
  wrong = values_2[0];
  value = values_2[1];
  if (wrong !== $durations.FINE) {
    return [wrong, value];
  }
  const values_3 = $adaptation_time_left.fault(learned, $time_left_prior.PRIOR, learned_at + 178);
  wrong = values_3[0];
  value = values_3[1];
  if (wrong !== $adaptation_time_left.FINE) {
    return [wrong, value];
  }
  return $places.fault(learned, learned_at + 217);
}
export function arrival(movement, near, movement_at = 0) {
  const traced = Math.trunc(movement[movement_at + 7]);
  let when = movement[movement_at + 4];
  for (let back = 0, end_1 = smaller(traced, TRACE_PLACES); back < end_1; back++) {
    const place_at = movement_at + remainder(traced - 1 - back, TRACE_PLACES) * 3 + 9;
    if (hypot(movement[place_at + 1] - movement[movement_at + 5], movement[place_at + 2] - movement[movement_at + 6]) > near) {
      return when;
    }
    when = movement[place_at];
  }
  return when;
}
export function learn_place(settings, person, movement, settings_at = 0, person_at = 0, movement_at = 0) {
  const scene_at = settings_at + 4;
  const x0 = movement[movement_at + 2] - settings[scene_at + 1];
  const y0 = movement[movement_at + 3] - settings[scene_at + 2];
  const x = movement[movement_at + 5] - settings[scene_at + 1];
  const y = movement[movement_at + 6] - settings[scene_at + 2];
  const distance = hypot(x - x0, y - y0);
  let usual = 1;
  if (settings[settings_at] === 1) {
    usual = $distances.likelihood(person, distance, person_at + 80);
  }
  const near = $places.NEAR_SHARE * distance;
  const where = [settings[scene_at], settings[settings_at + 3], near];
  $habits.learn(person, person, where, [x0, y0, x, y], usual, person_at + 603, person_at + 217);
  $places.visit(person, settings[scene_at], [x, y], near, person_at + 217);
}
export function learn(person, movement, distance, end, person_at = 0, movement_at = 0) {
  const x = movement[movement_at + 5];
  const y = movement[movement_at + 6];
  const start = movement[movement_at + 1];
  const duration = end - start;
  const clock_at = person_at + 136;
  const not_first = person[clock_at] > 0;
  if (not_first) {
    $durations.forget(person, clock_at);
  }
  for (let number = 0; number < $stages.STAGES; number++) {
    const m_at = movement_at + number * 13 + 297;
    const stage_at = person_at + number * 16;
    if (movement[m_at] === 1) {
      if (not_first && movement[m_at + 1] < end) {
        const left = movement[m_at + 11] * $stages.tempo_factor(person, stage_at);
        $durations.judge(person, movement[m_at + 1] - start, left, end - movement[m_at + 1], duration, clock_at);
      }
      $stages.learn(person, movement, x, y, end, stage_at, m_at);
    }
  }
  if (not_first) {
    const span = [start, end];
    $adaptation_time_left.learn(person, person, movement, span, person[clock_at + 13], $time_left_prior.PRIOR, person_at + 178, person_at + 213, movement_at + 2526);
  }
  $distances.remember(person, distance, person_at + 80);
  $durations.remember(person, duration, clock_at);
  $region_widening.learn(person, movement, [x, y], [start, end], person_at + 157, movement_at + 362);
}
export function conclude(settings, person, movement, settings_at = 0, person_at = 0, movement_at = 0) {
  const distance = hypot(movement[movement_at + 5] - movement[movement_at + 2], movement[movement_at + 6] - movement[movement_at + 3]);
  const end = arrival(movement, larger($moments.NEAR_PX, $moments.NEAR_SHARE * distance), movement_at);
  const whole = movement[movement_at] === 1 && movement[movement_at + 8] >= $moments.SAMPLES_LEAST;
  const shortest = larger(settings[settings_at + 1], $moments.SHORTEST_PX);
  if (whole && end - movement[movement_at + 1] >= $moments.LEAST_S && distance >= shortest) {
    if (settings[settings_at + 2] === 1) {
      learn_place(settings, person, movement, settings_at, person_at, movement_at);
    }
    learn(person, movement, distance, end, person_at, movement_at);
  }
  movement.fill(0, movement_at, movement_at + 3037);
}
export function follow(movement, now, start, movement_at = 0) {
  const t = now[0];
  const x = now[1];
  const y = now[2];
  const traced = Math.trunc(movement[movement_at + 7]);
  const last_at = movement_at + remainder(traced - 1, TRACE_PLACES) * 3 + 9;
  if (movement[movement_at] === 0 || t > movement[movement_at + 4]) {
    movement[movement_at + 8] += 1;
  }
  const moved = x !== movement[last_at + 1] || y !== movement[last_at + 2];
  if (traced > 0 && t === movement[last_at]) {
    movement[last_at + 1] = x;
    movement[last_at + 2] = y;
  } else if (traced === 0 || moved && t - movement[last_at] >= APART_S) {
    const place_at = movement_at + remainder(traced, TRACE_PLACES) * 3 + 9;
    movement[place_at] = t;
    movement[place_at + 1] = x;
    movement[place_at + 2] = y;
    movement[movement_at + 7] = traced + 1;
  }
  movement[movement_at] = 1;
  movement[movement_at + 1] = start[0];
  movement[movement_at + 2] = start[1];
  movement[movement_at + 3] = start[2];
  movement[movement_at + 4] = t;
  movement[movement_at + 5] = x;
  movement[movement_at + 6] = y;
}
export function stage_begun(movement, share, movement_at = 0) {
  const stage = Math.floor(share * $stages.STAGES - 0.5 + EARLY);
  if (stage < 0 || stage >= $stages.STAGES) {
    return -1;
  }
  const again = movement[movement_at + stage * 13 + 297] === 1 && movement[movement_at + stage * 13 + 298] === movement[movement_at + 4];
  for (let later = stage; later < $stages.STAGES; later++) {
    if (movement[movement_at + later * 13 + 297] === 1 && !again) {
      return -1;
    }
  }
  return stage;
}
export function fading(share, since) {
  return smaller((1 - share) / (1 - since), 1);
}
export function heading_of(movement, answer, movement_at = 0) {
  const px = answer[1];
  const py = answer[2];
  const sxx = answer[3];
  const sxy = answer[4];
  const syy = answer[5];
  const left = answer[6];
  const tail = answer[8];
  const away_x = movement[movement_at + 5] - movement[movement_at + 2];
  const away_y = movement[movement_at + 6] - movement[movement_at + 3];
  const reached = hypot(away_x, away_y);
  if (!(reached > 0 && left > 0 && tail > 0 && sxx + syy > 0)) {
    return [px, py, 0, 0, 0, 0, tail];
  }
  const ux = away_x / reached;
  const uy = away_y / reached;
  const wide2 = sxx * ux * ux + 2 * sxy * ux * uy + syy * uy * uy;
  const broad2 = sxx * uy * uy - 2 * sxy * ux * uy + syy * ux * ux;
  if (!(wide2 > 0 && broad2 > 0)) {
    return [px, py, 0, 0, 0, 0, tail];
  }
  return [px, py, ux, uy, Math.sqrt(wide2), Math.sqrt(broad2), tail];
}
export function ahead_of(movement, heading, movement_at = 0) {
  const dx = heading[0] - movement[movement_at + 5];
  const dy = heading[1] - movement[movement_at + 6];
  return [dx * heading[2] + dy * heading[3], dy * heading[2] - dx * heading[3]];
}
export function with_centre_ahead(movement, heading, along, wide, movement_at = 0) {
  const values_1 = ahead_of(movement, heading, movement_at);
  const across = values_1[1];
  let x = heading[0];
  let y = heading[1];
  const ux = heading[2];
  const uy = heading[3];
  const broad = heading[5];
  const tail = heading[6];
  x = movement[movement_at + 5] + along * ux - across * uy;
  y = movement[movement_at + 6] + along * uy + across * ux;
  return [x, y, ux, uy, wide, broad, tail];
}
export function by_distances(person, movement, own, share, person_at = 0, movement_at = 0) {
  const reached = hypot(movement[movement_at + 5] - movement[movement_at + 2], movement[movement_at + 6] - movement[movement_at + 3]);
  const values_1 = ahead_of(movement, own, movement_at);
  let along = values_1[0];
  const ahead = [along, own[4], own[5], own[6]];
  const values_2 = $distances.combine(person, reached, ahead, person_at + 80);
  const usual_along = values_2[0];
  const usual_wide = values_2[1];
  const usual = values_2[2];
  const weight = fading(share, FADE);
  along += weight * (usual_along - along);
  return [with_centre_ahead(movement, own, along, own[4] * Math.pow(usual_wide / own[4], weight), movement_at), usual];
}
export function prepare(settings, person, going, start, settings_at = 0, person_at = 0, going_at = 0) {
  const near = $places.NEAR_SHARE * person[person_at + 81];
  const where = [settings[settings_at + 4], settings[settings_at + 3], near];
  $destination.prepare(going, person, person, where, start, going_at, person_at + 217, person_at + 603);
}
export function by_places(settings, person, movement, laws, weights, settings_at = 0, person_at = 0, movement_at = 0) {
  const own = laws[0];
  const elsewhere = laws[1];
  const scene_at = settings_at + 4;
  const going_at = movement_at + 2858;
  const held_at = person_at + 217;
  const start = [movement[movement_at + 2] - settings[scene_at + 1], movement[movement_at + 3] - settings[scene_at + 2]];
  if (movement[going_at] === 0) {
    prepare(settings, person, movement, start, settings_at, person_at, going_at);
  }
  if (movement[going_at + 1] === 0) {
    return elsewhere;
  }
  $destination.weigh(movement, person, start, $destination.shift_law(own, -settings[scene_at + 1], -settings[scene_at + 2]), weights, going_at, held_at);
  const combined = $destination.combine(movement, person, start, $destination.shift_law(elsewhere, -settings[scene_at + 1], -settings[scene_at + 2]), going_at, held_at);
  return $destination.shift_law(combined, settings[scene_at + 1], settings[scene_at + 2]);
}
export function adapted_end(settings, person, movement, own, share, settings_at = 0, person_at = 0, movement_at = 0) {
  let elsewhere = own;
  let usual = 1;
  if (settings[settings_at] === 1) {
    const values_1 = by_distances(person, movement, own, share, person_at, movement_at);
    elsewhere = values_1[0];
    usual = values_1[1];
  }
  if (settings[settings_at + 2] === 0) {
    return [elsewhere, elsewhere];
  }
  const weights = [usual, fading(share, PLACES_FADE)];
  return [by_places(settings, person, movement, [own, elsewhere], weights, settings_at, person_at, movement_at), elsewhere];
}
export function write_mixture(settings, person, movement, to, settings_at = 0, person_at = 0, movement_at = 0, to_at = 0) {
  const scene_at = settings_at + 4;
  const start = [movement[movement_at + 2] - settings[scene_at + 1], movement[movement_at + 3] - settings[scene_at + 2]];
  $mixed_region.write(person, person, movement, movement, to, [settings[scene_at + 1], settings[scene_at + 2]], start, person_at + 168, person_at + 217, movement_at + 2858, movement_at + 2991, to_at);
}
export function state(settings, person, movement, share, laws, settings_at = 0, person_at = 0, movement_at = 0) {
  const region = laws[0];
  const elsewhere = laws[1];
  $mixed_region.claim(movement, share, elsewhere, movement_at + 2991);
  const cursor = [movement[movement_at + 4], movement[movement_at + 5], movement[movement_at + 6]];
  const number = $region_widening.record(movement, cursor, region, movement_at + 362);
  if (number >= 0) {
    write_mixture(settings, person, movement, movement, settings_at, person_at, movement_at, movement_at + number * 45 + 373);
  }
}
export function adapt(settings, person, movement, answer, pace, settings_at = 0, person_at = 0, movement_at = 0) {
  const t = answer[0];
  let px = answer[1];
  let py = answer[2];
  let sxx = answer[3];
  let sxy = answer[4];
  let syy = answer[5];
  const predicted = answer[6];
  const phase = answer[7];
  let tail = answer[8];
  const heading = heading_of(movement, answer, movement_at);
  const ux = heading[2];
  const uy = heading[3];
  const wide = heading[4];
  const broad = heading[5];
  movement[movement_at + 2991] = 0;
  if (wide === 0) {
    return answer;
  }
  const now = movement[movement_at + 4];
  const x = movement[movement_at + 5];
  const y = movement[movement_at + 6];
  const reached = hypot(x - movement[movement_at + 2], y - movement[movement_at + 3]);
  const since = now - movement[movement_at + 1];
  const values_1 = ahead_of(movement, heading, movement_at);
  const along = values_1[0];
  const across = values_1[1];
  let share = since / (since + predicted);
  const stage = stage_begun(movement, share, movement_at);
  if (stage >= 0) {
    const m_at = movement_at + stage * 13 + 297;
    movement[m_at] = 1;
    movement[m_at + 1] = now;
    movement[m_at + 2] = x;
    movement[m_at + 3] = y;
    movement[m_at + 12] = reached;
    movement[m_at + 4] = ux;
    movement[m_at + 5] = uy;
    movement[m_at + 6] = along;
    movement[m_at + 7] = across;
    movement[m_at + 8] = wide;
    movement[m_at + 9] = broad;
    movement[m_at + 10] = tail;
    movement[m_at + 11] = predicted;
  }
  if (person[person_at + 80] === 0) {
    const first = [px, py, sxx, sxy, syy, tail];
    state(settings, person, movement, share, [first, first], settings_at, person_at, movement_at);
    return answer;
  }
  const total = hypot(reached + along, across);
  const values_2 = $stages.correct(person, share, total, along, person_at);
  const shift = values_2[0];
  const widen = values_2[1];
  const broaden = values_2[2];
  const slow = values_2[3];
  let left = $durations.mix(person, since, predicted * slow, person_at + 136);
  share = since / (since + left);
  const shape = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) / (wide * broad);
  let own = with_centre_ahead(movement, heading, along + shift * fading(share, BIAS_FADE), wide * widen, movement_at);
  own = [own[0], own[1], ux, uy, own[4], broad * broaden, tail];
  const values_3 = adapted_end(settings, person, movement, own, share, settings_at, person_at, movement_at);
  const end = values_3[0];
  const elsewhere = values_3[1];
  const values_4 = $region_widening.widen(person, share, tail, person_at + 157);
  const factor = values_4[0];
  tail = values_4[1];
  const region = $destination.scaled(end, shape, factor, tail);
  state(settings, person, movement, share, [region, $destination.scaled(elsewhere, shape, factor, tail)], settings_at, person_at, movement_at);
  px = region[0];
  py = region[1];
  sxx = region[2];
  sxy = region[3];
  syy = region[4];
  const values_5 = $adaptation_time_left.stated(person, person, movement, [now, x, y], since, person[person_at + 149], [left, predicted], [reached, hypot(px - x, py - y)], pace, person_at + 178, person_at + 213, movement_at + 2526);
  left = values_5[0];
  const spread = values_5[1];
  return [t, px, py, sxx, sxy, syy, left, phase, tail, spread];
}
