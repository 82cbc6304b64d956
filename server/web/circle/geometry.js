// Geometry without a screen: circles of targets, distances along an axis.

/** The radius of a circle on which targets taken in turn are `distance` apart (an odd number of them). */
export const radiusFor = (distance, count) => distance / (2 * Math.cos(Math.PI / (2 * count)));

/**
 * Centres of the targets of ISO 9241-411 in the order they are taken: each lies across from the last.
 * @param {number} distance px between targets taken in turn
 * @param {[number, number]} centre of the circle, px
 * @param {number} count of targets, odd, so that the order across visits all
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

/** How far `point` lies from `from` along the axis to `to`. */
export function along(from, to, point) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return ((point[0] - from[0]) * (to[0] - from[0]) + (point[1] - from[1]) * (to[1] - from[1])) / length;
}

/** The place nearest to a point inside a picture, with a margin: what lies beyond is drawn at the edge. */
export function inside([x, y], width, height, margin = 9) {
  return [Math.min(width - margin, Math.max(margin, x)), Math.min(height - margin, Math.max(margin, y))];
}

/** The middle value; the mean of the two in the middle of an even number; NaN of none. */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  if (sorted.length === 0) return NaN;
  return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}
