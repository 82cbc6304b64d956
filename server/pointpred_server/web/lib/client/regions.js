// The region of a prediction: the ellipse that holds the endpoint with a given probability.

import { ellipse } from "../laws/regions.js";

/**
 * The ellipse that holds the endpoint with probability `level`: centre and half axes in px, angle in radians from x to
 * the major axis (y down, as a canvas has it). Null where nothing is predicted, no region is claimed, or the ellipse is
 * too large for a finite number.
 * @param {Pick<import("../index.d.ts").Prediction, "x"|"y"|"region">|null|undefined} prediction @param {number} level in (0, 1); a RangeError otherwise
 * @returns {import("../index.d.ts").Ellipse|null}
 */
export function regionOf(prediction, level) {
  if (!(level > 0 && level < 1)) throw new RangeError(`level must be a probability in (0, 1), received ${level}`);
  if (!prediction?.region || prediction.x === null) return null;
  const {
    x,
    y,
    region: { sxx, sxy, syy, tail },
  } = prediction;
  const [major, minor, angle] = ellipse(level, sxx, sxy, syy, tail ?? NaN);
  return Number.isNaN(major) ? null : { x, y: /** @type {number} */ (y), major, minor, angle };
}
