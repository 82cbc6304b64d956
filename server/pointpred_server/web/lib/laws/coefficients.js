// The coefficients of the learned predictor, out of the text that they are packed in.

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
const LOWER = 8; // the last digit has the three lowest bits
const MANTISSAS = LOWER * DIGITS.length;

/**
 * Numbers of nine bits behind the leading one. A text has three digits for each: sign and exponent, the upper bits of
 * the mantissa, the lower ones; first this digit of all numbers, then the next, because the text is smaller so when it is compressed.
 * @param {string} text @param {number} lowest exponent @returns {Float64Array}
 */
export function unpack(text, lowest) {
  const count = text.length / 3;
  const digit = (place) => DIGITS.indexOf(text[place]);
  return Float64Array.from({ length: count }, (_, i) => {
    const first = digit(i);
    const mantissa = LOWER * digit(count + i) + digit(2 * count + i);
    const size = (1 + mantissa / MANTISSAS) * 2 ** (lowest + (first >> 1));
    return first & 1 ? -size : size;
  });
}
