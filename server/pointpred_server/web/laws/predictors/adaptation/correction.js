// Written by `make laws` from correction.py: change that and run it again.
import { hypot, larger, remainder, smaller, view } from "../../arithmetic.js";
import * as $destination from "./destination.js";
import * as $distances from "./distances.js";
import * as $durations from "./durations.js";
import * as $habits from "./habits.js";
import * as $mixed_region from "./mixed_region.js";
import * as $places from "./places.js";
import * as $region_widening from "./region_widening.js";
import * as $stages from "./stages.js";
import * as $adaptation_time_left from "./time_left.js";
import * as $time_left_prior from "./time_left_prior.js";
export const DISTANCES = 80;
export const DURATIONS = 136;
export const REGIONS = 157;
export const TIME_LEFT = 178;
export const INTERVALS = 213;
export const KNOWN = 217;
export const HABITS = 603;
export const LEARNED = 628;
export const TRACE_PLACES = 96;
export const APART_S = 0.005;
export const STARTED = 0;
export const T0 = 1;
export const X0 = 2;
export const Y0 = 3;
export const T = 4;
export const X = 5;
export const Y = 6;
export const PLACES = 7;
export const SAMPLES = 8;
export const TRACE = 9;
export const MOMENTS = 297;
export const STATED = 362;
export const TIMED = 2526;
export const DESTINATION = 2858;
export const NOW = 2991;
export const STATES = 3037;
export const NEAR_PX = 8;
export const NEAR_SHARE = 0.03;
export const SAMPLES_LEAST = 6;
export const LEAST_S = 0.08;
export const BIAS_FADE = 0.2;
export const FADE = 0.5;
export const PLACES_FADE = 0.7;
export const EARLY = 0.1;
export const UNEQUAL = 21;
export function fault(learned) {
  const held = learned[DISTANCES + $distances.COUNT];
  if (held !== learned[DURATIONS + $durations.COUNT]) {
    return [UNEQUAL, held];
  }
  const values_1 = $distances.fault(view(learned, DISTANCES, DURATIONS));
  let wrong = values_1[0];
  let value = values_1[1];
  if (wrong !== $distances.FINE) {
    return [wrong, value];
  }
  const values_2 = $durations.fault(view(learned, DURATIONS, REGIONS));
  wrong = values_2[0];
  value = values_2[1];
  if (wrong !== $durations.FINE) {
    return [wrong, value];
  }
  const values_3 = $adaptation_time_left.fault(view(learned, TIME_LEFT, INTERVALS));
  wrong = values_3[0];
  value = values_3[1];
  if (wrong !== $adaptation_time_left.FINE) {
    return [wrong, value];
  }
  return $places.fault(view(learned, KNOWN, HABITS));
}
export function arrival(memory, at, near) {
  const places = Math.trunc(memory[at + PLACES]);
  let when = memory[at + T];
  for (let back = 0, end_1 = smaller(places, TRACE_PLACES); back < end_1; back++) {
    const place = at + TRACE + 3 * remainder(places - 1 - back, TRACE_PLACES);
    if (hypot(memory[place + 1] - memory[at + X], memory[place + 2] - memory[at + Y]) > near) {
      return when;
    }
    when = memory[place];
  }
  return when;
}
export function learn_place(memory, person, at, parts, scene) {
  const x0 = memory[at + X0] - scene[1];
  const y0 = memory[at + Y0] - scene[2];
  const x = memory[at + X] - scene[1];
  const y = memory[at + Y] - scene[2];
  const distance = hypot(x - x0, y - y0);
  let usual = 1;
  if (parts[0] === 1) {
    usual = $distances.likelihood(memory, person + DISTANCES, distance);
  }
  const where = person + KNOWN;
  const habit = person + HABITS;
  const near = $places.NEAR_SHARE * distance;
  $habits.learn(memory, where, habit, [scene[0], parts[2], near], [x0, y0, x, y], usual);
  $places.visit(memory, where, scene[0], [x, y], near);
}
export function learn(memory, person, at, distance, end) {
  const x = memory[at + X];
  const y = memory[at + Y];
  const start = memory[at + T0];
  const duration = end - start;
  const clock = person + DURATIONS;
  const not_first = memory[clock + $durations.COUNT] > 0;
  if (not_first) {
    $durations.forget(memory, clock);
  }
  for (let number = 0; number < $stages.STAGES; number++) {
    const place = at + MOMENTS + number * $stages.MOMENT;
    const stage = person + number * $stages.WIDTH;
    if (memory[place + $stages.PRESENT] === 1) {
      const m = $stages.moment_at(memory, place);
      if (not_first && m[0] < end) {
        const left = m[10] * $stages.tempo_factor(memory, stage);
        $durations.judge(memory, clock, m[0] - start, left, end - m[0], duration);
      }
      $stages.learn(memory, stage, m, x, y, end);
    }
  }
  if (not_first) {
    const timed = [person + TIME_LEFT, person + INTERVALS, at + TIMED];
    const median = memory[clock + $durations.MEDIAN];
    $adaptation_time_left.learn(memory, timed, [start, end], median, $time_left_prior.PRIOR);
  }
  $distances.remember(memory, person + DISTANCES, distance);
  $durations.remember(memory, clock, duration);
  $region_widening.learn(memory, person + REGIONS, at + STATED, [x, y], [start, end]);
}
export function conclude(memory, person, at, shortest, parts, scene) {
  const distance = hypot(memory[at + X] - memory[at + X0], memory[at + Y] - memory[at + Y0]);
  const end = arrival(memory, at, larger(NEAR_PX, NEAR_SHARE * distance));
  const whole = memory[at + STARTED] === 1 && memory[at + SAMPLES] >= SAMPLES_LEAST;
  if (whole && end - memory[at + T0] >= LEAST_S && distance >= larger(shortest, $distances.SHORTEST_PX)) {
    if (parts[1] === 1) {
      learn_place(memory, person, at, parts, scene);
    }
    learn(memory, person, at, distance, end);
  }
  memory.fill(0, at, at + STATES);
}
export function follow(memory, at, now, start) {
  const t = now[0];
  const x = now[1];
  const y = now[2];
  const places = Math.trunc(memory[at + PLACES]);
  const last = at + TRACE + 3 * remainder(places - 1, TRACE_PLACES);
  if (memory[at + STARTED] === 0 || t > memory[at + T]) {
    memory[at + SAMPLES] += 1;
  }
  const moved = x !== memory[last + 1] || y !== memory[last + 2];
  if (places > 0 && t === memory[last]) {
    memory[last + 1] = x;
    memory[last + 2] = y;
  } else if (places === 0 || moved && t - memory[last] >= APART_S) {
    const place = at + TRACE + 3 * remainder(places, TRACE_PLACES);
    memory[place] = t;
    memory[place + 1] = x;
    memory[place + 2] = y;
    memory[at + PLACES] = places + 1;
  }
  memory[at + STARTED] = 1;
  memory[at + T0] = start[0];
  memory[at + X0] = start[1];
  memory[at + Y0] = start[2];
  memory[at + T] = t;
  memory[at + X] = x;
  memory[at + Y] = y;
}
export function record(memory, at, share, moment) {
  const stage = Math.floor(share * $stages.STAGES - 0.5 + EARLY);
  if (stage < 0 || stage >= $stages.STAGES) {
    return;
  }
  const place = at + MOMENTS + stage * $stages.MOMENT;
  const again = memory[place + $stages.PRESENT] === 1 && memory[place + $stages.T] === moment[0];
  for (let later = stage; later < $stages.STAGES; later++) {
    if (memory[at + MOMENTS + later * $stages.MOMENT + $stages.PRESENT] === 1 && !again) {
      return;
    }
  }
  $stages.record(memory, place, moment);
}
export function fading(share, since) {
  return smaller((1 - share) / (1 - since), 1);
}
export function heading_of(memory, at, answer) {
  const px = answer[1];
  const py = answer[2];
  const sxx = answer[3];
  const sxy = answer[4];
  const syy = answer[5];
  const left = answer[6];
  const tail = answer[8];
  const away_x = memory[at + X] - memory[at + X0];
  const away_y = memory[at + Y] - memory[at + Y0];
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
export function ahead_of(memory, at, heading) {
  const dx = heading[0] - memory[at + X];
  const dy = heading[1] - memory[at + Y];
  return [dx * heading[2] + dy * heading[3], dy * heading[2] - dx * heading[3]];
}
export function with_centre_ahead(memory, at, heading, along, wide) {
  const values_1 = ahead_of(memory, at, heading);
  const across = values_1[1];
  let x = heading[0];
  let y = heading[1];
  const ux = heading[2];
  const uy = heading[3];
  const broad = heading[5];
  const tail = heading[6];
  x = memory[at + X] + along * ux - across * uy;
  y = memory[at + Y] + along * uy + across * ux;
  return [x, y, ux, uy, wide, broad, tail];
}
export function by_distances(memory, person, at, own, share) {
  const reached = hypot(memory[at + X] - memory[at + X0], memory[at + Y] - memory[at + Y0]);
  const values_1 = ahead_of(memory, at, own);
  let along = values_1[0];
  const ahead = [along, own[4], own[5], own[6]];
  const values_2 = $distances.combine(memory, person + DISTANCES, reached, ahead);
  const usual_along = values_2[0];
  const usual_wide = values_2[1];
  const usual = values_2[2];
  const weight = fading(share, FADE);
  along += weight * (usual_along - along);
  return [with_centre_ahead(memory, at, own, along, own[4] * Math.pow(usual_wide / own[4], weight)), usual];
}
export function prepare(memory, person, going, parts, scene, start) {
  const near = $places.NEAR_SHARE * memory[person + DISTANCES + $distances.DISTANCES];
  const known = [person + KNOWN, person + HABITS];
  $destination.prepare(memory, known, going, [scene[0], parts[2], near], start);
}
export function by_places(memory, person, at, parts, scene, laws, weights) {
  const own = laws[0];
  const elsewhere = laws[1];
  const start = [memory[at + X0] - scene[1], memory[at + Y0] - scene[2]];
  const where = person + KNOWN;
  const going = at + DESTINATION;
  if (memory[going + $destination.READY] === 0) {
    prepare(memory, person, going, parts, scene, start);
  }
  if (memory[going + $destination.RETURNS] === 0) {
    return elsewhere;
  }
  $destination.weigh(memory, where, going, start, $destination.shift_law(own, -scene[1], -scene[2]), weights);
  const combined = $destination.combine(memory, where, going, start, $destination.shift_law(elsewhere, -scene[1], -scene[2]));
  return $destination.shift_law(combined, scene[1], scene[2]);
}
export function adapted_end(memory, person, at, parts, scene, own, share) {
  let elsewhere = own;
  let usual = 1;
  if (parts[0] === 1) {
    const values_1 = by_distances(memory, person, at, own, share);
    elsewhere = values_1[0];
    usual = values_1[1];
  }
  if (parts[1] === 0) {
    return [elsewhere, elsewhere];
  }
  const weights = [usual, fading(share, PLACES_FADE)];
  return [by_places(memory, person, at, parts, scene, [own, elsewhere], weights), elsewhere];
}
export function write_mixture(memory, person, at, scene, to) {
  const known = [person + REGIONS + $region_widening.MIXED, person + KNOWN, at + DESTINATION];
  const start = [memory[at + X0] - scene[1], memory[at + Y0] - scene[2]];
  $mixed_region.write(memory, known, at + NOW, to, [scene[1], scene[2]], start);
}
export function state(memory, person, at, scene, share, laws) {
  const region = laws[0];
  const elsewhere = laws[1];
  $mixed_region.claim(memory, at + NOW, share, elsewhere);
  const now = memory[at + T];
  const x = memory[at + X];
  const y = memory[at + Y];
  const to = $region_widening.record(memory, at + STATED, now, x, y, region);
  if (to >= 0) {
    write_mixture(memory, person, at, scene, to);
  }
}
export function adapt(memory, person, at, parts, scene, answer, pace) {
  const t = answer[0];
  let px = answer[1];
  let py = answer[2];
  let sxx = answer[3];
  let sxy = answer[4];
  let syy = answer[5];
  const predicted = answer[6];
  const phase = answer[7];
  let tail = answer[8];
  const heading = heading_of(memory, at, answer);
  const ux = heading[2];
  const uy = heading[3];
  const wide = heading[4];
  const broad = heading[5];
  memory[at + NOW + $mixed_region.CLAIMED] = 0;
  if (wide === 0) {
    return answer;
  }
  const now = memory[at + T];
  const x = memory[at + X];
  const y = memory[at + Y];
  const reached = hypot(x - memory[at + X0], y - memory[at + Y0]);
  const since = now - memory[at + T0];
  const values_1 = ahead_of(memory, at, heading);
  const along = values_1[0];
  const across = values_1[1];
  let share = since / (since + predicted);
  const m = [now, x, y, ux, uy, along, across, wide, broad, tail, predicted, reached];
  record(memory, at, share, m);
  if (memory[person + DISTANCES + $distances.COUNT] === 0) {
    const first = [px, py, sxx, sxy, syy, tail];
    state(memory, person, at, scene, share, [first, first]);
    return answer;
  }
  const values_2 = $stages.correct(memory, person, share, hypot(reached + along, across), along);
  const shift = values_2[0];
  const widen = values_2[1];
  const broaden = values_2[2];
  const slow = values_2[3];
  let left = $durations.mix(memory, person + DURATIONS, since, predicted * slow);
  share = since / (since + left);
  const shape = (sxy * (ux * ux - uy * uy) + (syy - sxx) * ux * uy) / (wide * broad);
  let own = with_centre_ahead(memory, at, heading, along + shift * fading(share, BIAS_FADE), wide * widen);
  own = [own[0], own[1], ux, uy, own[4], broad * broaden, tail];
  const values_3 = adapted_end(memory, person, at, parts, scene, own, share);
  const end = values_3[0];
  const elsewhere = values_3[1];
  const values_4 = $region_widening.widen(memory, person + REGIONS, share, tail);
  const factor = values_4[0];
  tail = values_4[1];
  const region = $destination.scaled(end, shape, factor, tail);
  state(memory, person, at, scene, share, [region, $destination.scaled(elsewhere, shape, factor, tail)]);
  px = region[0];
  py = region[1];
  sxx = region[2];
  sxy = region[3];
  syy = region[4];
  const values_5 = $adaptation_time_left.stated(memory, [person + TIME_LEFT, person + INTERVALS, at + TIMED], [now, x, y], since, memory[person + DURATIONS + $durations.MEDIAN], [left, predicted], [reached, hypot(px - x, py - y)], pace);
  left = values_5[0];
  const spread = values_5[1];
  return [t, px, py, sxx, sxy, syy, left, phase, tail, spread];
}
