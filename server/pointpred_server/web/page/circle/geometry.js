// Geometry of the circle task: where its targets are, and distances along an axis.

/** The radius of a circle on which an odd number of targets taken in turn are `distance` apart. */
export const radiusFor = (distance, count) => distance / (2 * Math.cos(Math.PI / (2 * count)));

/**
 * Centres of the targets of ISO 9241-411 in the order they are taken: each lies across from the one before.
 * @param {number} distance px between targets taken in turn
 * @param {[number, number]} centre of the circle, px
 * @param {number} count of targets, odd, so that the order across the circle visits all
 * @returns {[number, number][]}
 */
export function circle(distance, centre, count = 13) {
  if (!Number.isInteger(count) || count < 3 || count % 2 === 0) {
    throw new RangeError(`the number of targets must be odd and at least 3, received ${count}`);
  }
  const radius = radiusFor(distance, count);
  return Array.from({ length: count }, (_, k) => {
    const angle = (2 * Math.PI * ((k * (Math.floor(count / 2) + 1)) % count)) / count;
    return [centre[0] + radius * Math.sin(angle), centre[1] - radius * Math.cos(angle)];
  });
}

/** The distance of `point` from `from` along the axis to `to`. */
export function along(from, to, point) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return ((point[0] - from[0]) * (to[0] - from[0]) + (point[1] - from[1]) * (to[1] - from[1])) / length;
}
