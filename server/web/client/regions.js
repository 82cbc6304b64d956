// The region of a prediction: the ellipse that holds the endpoint with a given probability; `pointpred/regions.py` in JavaScript.

const NEARLY_NORMAL = 1e16; // degrees of freedom from which on no number tells a Student law from a normal one
const LARGEST_LOG = 700; // a region that grows further is infinite: exp(700) is about as large as numbers get

/** Squared Mahalanobis distance up to which the region of a level goes; tail null: a normal law. */
function reach(level, tail) {
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
  const far = reach(level, tail);
  if (!(sxx > 0 && syy > 0 && determinant > 0 && determinant < Infinity && far > 0)) return null;
  const larger = 0.5 * (sxx + syy) + Math.hypot(0.5 * (sxx - syy), sxy);
  const major = Math.sqrt(far * larger), minor = Math.sqrt(far * (determinant / larger)); // no difference: it would round
  if (!Number.isFinite(major)) return null;
  return { x, y, major, minor: Math.min(minor, major), angle: 0.5 * Math.atan2(2 * sxy, sxx - syy) };
}
