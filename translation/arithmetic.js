// What laws in Python compute otherwise than JavaScript's own operators and functions do.

const LEAST_SQUARED = 1e-140,
  MOST_SQUARED = 1e150; // roots of sums of squares between these lost nothing on the way
const LN_ROOT_2PI = 0.5 * Math.log(2 * Math.PI);
const STIRLING_FROM = 10; // from here on the series below is exact in floats
const SERIES_TO = 3; // up to here erf is summed as a series, beyond as a continued fraction

/** The remainder of Python: it has the sign of the divisor. */
export function remainder(a, b) {
  const rest = a % b;
  return rest !== 0 && rest < 0 !== b < 0 ? rest + b : rest;
}

/** The second number if it is larger, else the first; with NaN in either, the first. */
export function larger(a, b) {
  return b > a ? b : a;
}

/** The second number if it is smaller, else the first; with NaN in either, the first. */
export function smaller(a, b) {
  return b < a ? b : a;
}

export function square(a) {
  return a * a;
}

/** The length of (a, b). `Math.hypot` takes ten times as long. */
export function hypot(a, b) {
  const length = Math.sqrt(a * a + b * b);
  return length > LEAST_SQUARED && length < MOST_SQUARED ? length : Math.hypot(a, b);
}

/** A part of an array that shares its numbers; of a table, the rows themselves. */
export function view(array, first, end) {
  return array instanceof Float64Array ? array.subarray(first, end) : array.slice(first, end);
}

/** The numbers of an array as a table, which shares their memory. */
export function table(array, rows, columns) {
  const made = [];
  for (let i = 0; i < rows; i++) made.push(array.subarray(i * columns, (i + 1) * columns));
  return made;
}

/** A table of zeros: an array of rows. */
export function matrix(rows, columns) {
  return Array.from({ length: rows }, () => new Float64Array(columns));
}

export function copysign(size, sign) {
  return Math.abs(size) * (sign < 0 || Object.is(sign, -0) ? -1 : 1);
}

/** The error function. */
export function erf(x) {
  const size = Math.abs(x);
  if (!(size > 0)) return x;
  if (size >= 6) return Math.sign(x);
  const density = (2 / Math.sqrt(Math.PI)) * Math.exp(-size * size);
  if (size < SERIES_TO) {
    let term = size,
      sum = 0;
    for (let n = 1; sum + term !== sum; n++) {
      sum += term;
      term *= (2 * size * size) / (2 * n + 1);
    }
    return Math.sign(x) * density * sum;
  }
  let rest = 0;
  for (let n = 60; n > 0; n--) rest = (0.5 * n) / (size + rest);
  return Math.sign(x) * (1 - (0.5 * density) / (size + rest));
}

/** The logarithm of the gamma function of a positive number. */
export function lgamma(x) {
  let product = 1,
    at = x;
  for (; at < STIRLING_FROM; at++) product *= at;
  const r = 1 / at,
    r2 = r * r;
  const series =
    r * (1 / 12 - r2 * (1 / 360 - r2 * (1 / 1260 - r2 * (1 / 1680 - r2 * (1 / 1188 - (r2 * 691) / 360360)))));
  return (at - 0.5) * Math.log(at) - at + LN_ROOT_2PI + series - Math.log(product);
}
