// The statistics of ISO 9241-411 for blocks of trials.

import { mean } from "../shell/numbers.js";

/** Width of the middle 96.12 % of a normal distribution, in standard deviations: one in 26 selections misses a target of this width. */
const WIDTH_IN_SDS = 4.133;

/** A spread below this share of the distance is rounding. */
const LEAST_SPREAD = 1e-6;

/** Standard deviation of a sample, with n - 1. */
function deviation(values) {
  const middle = mean(values);
  return Math.sqrt(values.reduce((sum, value) => sum + (value - middle) ** 2, 0) / (values.length - 1));
}

/** The distance of `point` from `from` along the axis to `to`. */
function along(from, to, point) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return ((point[0] - from[0]) * (to[0] - from[0]) + (point[1] - from[1]) * (to[1] - from[1])) / length;
}

/** @param {import("../study/task.js").Row} row */
const place = ([, x, y]) => [x, y];

/**
 * The statistics of one block; null where they are undefined (fewer than two trials, or no spread).
 * Distances lie along the axis from the centre of the last target to that of the next.
 * effective width = 4.133 SD(positions of the selections); effective distance = mean distance from selection to selection;
 * throughput = log2(effective distance / effective width + 1) / mean movement time.
 * @param {import("../study/task.js").Trial[]} trials
 */
export function blockStatistics(trials) {
  const misses = trials.filter(({ hit }) => !hit).length;
  const undefinedValues = { movementTime: null, effectiveWidth: null, effectiveDistance: null, throughput: null };
  if (trials.length === 0) return { trials: 0, misses, errorRate: null, ...undefinedValues };
  const counted = { trials: trials.length, misses, errorRate: misses / trials.length };
  const ends = trials.map(({ from, target, end }) => along(from, target, place(end)));
  const starts = trials.map(({ from, target, start }) => along(from, target, place(start)));
  const offsets = trials.map(({ from, target }, i) => ends[i] - Math.hypot(target[0] - from[0], target[1] - from[1]));
  const movementTime = mean(trials.map(({ start, end }) => end[0] - start[0]));
  const effectiveDistance = mean(ends.map((end, i) => end - starts[i]));
  const effectiveWidth = trials.length > 1 ? WIDTH_IN_SDS * deviation(offsets) : null;
  const isSpread = effectiveWidth !== null && effectiveWidth > LEAST_SPREAD * effectiveDistance;
  const sound = effectiveDistance > 0 && isSpread && movementTime > 0;
  const throughput = sound ? Math.log2(effectiveDistance / effectiveWidth + 1) / movementTime : null;
  return { ...counted, movementTime, effectiveWidth, effectiveDistance, throughput };
}

/** The statistics of each block, and their means: throughput is the mean of the blocks' throughputs. */
export function statistics(trials) {
  const numbers = [...new Set(trials.map(({ sequence }) => sequence.block))];
  const blocks = numbers.map((block) => ({
    block,
    ...blockStatistics(trials.filter(({ sequence }) => sequence.block === block)),
  }));
  const meanOf = (name) => {
    const values = blocks.map((block) => block[name]).filter((value) => value !== null);
    return values.length ? mean(values) : null;
  };
  const misses = trials.filter(({ hit }) => !hit).length;
  return {
    blocks,
    trials: trials.length,
    misses,
    errorRate: trials.length ? misses / trials.length : null,
    movementTime: trials.length ? mean(trials.map(({ start, end }) => end[0] - start[0])) : null,
    effectiveWidth: meanOf("effectiveWidth"),
    effectiveDistance: meanOf("effectiveDistance"),
    throughput: meanOf("throughput"),
  };
}
