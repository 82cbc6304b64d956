// The region of a prediction: the ellipse that holds the endpoint with a given probability; `pointpred/regions.py` in JavaScript.

const NEARLY_NORMAL = 1e16; // degrees of freedom beyond which a Student and a normal law are the same in floats
const LARGEST_LOG = 700; // beyond it the region is infinite: exp(709) is the largest float

/** The squared Mahalanobis distance of the region's edge; tail null: a normal law. */
function squaredDistance(level, tail) {
  const normal = -2 * Math.log1p(-level);
  if (tail === null || tail === undefined || !(tail < NEARLY_NORMAL)) return normal;
  if (!(tail > 0)) return NaN;
  return normal / tail > LARGEST_LOG ? Infinity : tail * Math.expm1(normal / tail);
}

/**
 * The ellipse that holds the endpoint with probability `level`: centre and half axes in px, angle in radians from x to
 * the major axis (y down, as a canvas has it). Null where nothing is predicted, no region is claimed, or the ellipse is
 * too large for a finite number.
 * @param {import("../pointpred.js").Prediction|null|undefined} prediction @param {number} level in (0, 1); a RangeError otherwise
 * @returns {import("../pointpred.js").Ellipse|null}
 */
export function regionOf(prediction, level) {
  if (!(level > 0 && level < 1)) throw new RangeError(`level must be a probability in (0, 1), received ${level}`);
  if (!prediction?.region || prediction.x === null) return null;
  const { x, y, region: { sxx, sxy, syy, tail } } = prediction;
  const determinant = sxx * syy - sxy * sxy;
  const distance = squaredDistance(level, tail);
  if (!(sxx > 0 && syy > 0 && determinant > 0 && determinant < Infinity && distance > 0)) return null;
  const larger = 0.5 * (sxx + syy) + Math.hypot(0.5 * (sxx - syy), sxy);
  const major = Math.sqrt(distance * larger), minor = Math.sqrt(distance * (determinant / larger)); // a difference of the two would lose digits
  if (!Number.isFinite(major)) return null;
  return { x, y, major, minor: Math.min(minor, major), angle: 0.5 * Math.atan2(2 * sxy, sxx - syy) };
}
