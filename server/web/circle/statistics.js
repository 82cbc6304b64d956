// What ISO 9241-411 makes of a block of trials.

import { along } from "./geometry.js";

/** Width of a normal distribution's middle 96.12 %: one in 26 selections misses a target so wide. */
export const WIDTH_IN_SDS = 4.133;

/** Less of the way is rounding, not a hand's spread. */
const LEAST_SPREAD = 1e-6;

const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Standard deviation of a sample, with n - 1. */
function deviation(values) {
  const middle = mean(values);
  return Math.sqrt(values.reduce((sum, value) => sum + (value - middle) ** 2, 0) / (values.length - 1));
}

const place = ([, x, y]) => [x, y];

/**
 * Statistics of one block; null where they mean nothing (fewer than two trials, or no spread at all).
 * Distances lie along the axis from the centre of the last target to that of the next.
 * effective width = 4.133 SD(where the selections lie); effective distance = mean way from selection to selection;
 * throughput = log2(effective distance / effective width + 1) / mean movement time.
 * @param {import("./task.js").Trial[]} trials
 */
export function blockStatistics(trials) {
  const misses = trials.filter(({ hit }) => !hit).length;
  const nothing = { movementTime: null, effectiveWidth: null, effectiveDistance: null, throughput: null };
  if (trials.length === 0) return { trials: 0, misses, errorRate: null, ...nothing };
  const counted = { trials: trials.length, misses, errorRate: misses / trials.length };
  const ends = trials.map(({ from, target, end }) => along(from, target, place(end)));
  const starts = trials.map(({ from, target, start }) => along(from, target, place(start)));
  const beside = trials.map(({ from, target }, i) => ends[i] - Math.hypot(target[0] - from[0], target[1] - from[1]));
  const movementTime = mean(trials.map(({ start, end }) => end[0] - start[0]));
  const effectiveDistance = mean(ends.map((end, i) => end - starts[i]));
  const effectiveWidth = trials.length > 1 ? WIDTH_IN_SDS * deviation(beside) : null;
  const sound = effectiveDistance > 0 && effectiveWidth > LEAST_SPREAD * effectiveDistance && movementTime > 0;
  const throughput = sound ? Math.log2(effectiveDistance / effectiveWidth + 1) / movementTime : null;
  return { ...counted, movementTime, effectiveWidth, effectiveDistance, throughput };
}

/** The statistics of each block, and their means: throughput is the mean of the blocks' throughputs. */
export function statistics(trials) {
  const numbers = [...new Set(trials.map(({ block }) => block))];
  const blocks = numbers.map((block) => ({ block, ...blockStatistics(trials.filter((one) => one.block === block)) }));
  const over = (name) => {
    const known = blocks.map((block) => block[name]).filter((value) => value !== null);
    return known.length ? mean(known) : null;
  };
  const misses = trials.filter(({ hit }) => !hit).length;
  return {
    blocks,
    trials: trials.length,
    misses,
    errorRate: trials.length ? misses / trials.length : null,
    movementTime: trials.length ? mean(trials.map(({ start, end }) => end[0] - start[0])) : null,
    effectiveWidth: over("effectiveWidth"),
    effectiveDistance: over("effectiveDistance"),
    throughput: over("throughput"),
  };
}
