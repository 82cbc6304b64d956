// Numbers and names in the sentences of errors, as Python writes them.

const DIGITS = 6;

/** A number with at most six digits, as `%g`: 1e+09, 0.3, 1000. @param {number} value @returns {string} */
export function general(value) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf").replace("NaN", "nan");
  const [digits, exponent] = value.toExponential(DIGITS - 1).split("e");
  if (Number(exponent) >= -4 && Number(exponent) < DIGITS) return String(Number(value.toPrecision(DIGITS)));
  const size = String(Math.abs(Number(exponent))).padStart(2, "0");
  return `${Number(digits)}e${exponent[0] === "-" ? "-" : "+"}${size}`;
}

/** A received value as a sentence quotes it. @param {unknown} value @returns {string} */
export function quoted(value) {
  if (typeof value === "string") return `'${value}'`;
  if (typeof value === "number" || value === null || value === undefined) return String(value);
  return JSON.stringify(value)?.slice(0, 80) ?? String(value);
}

/** The name that is most like a word; null where none is. @param {string} word @param {string[]} names @returns {string|null} */
export function nearest(word, names) {
  let /** @type {string|null} */ best = null,
    most = 0.6;
  for (const name of names) {
    const likeness = (2 * common(word, name)) / (word.length + name.length);
    if (likeness >= most) [best, most] = [name, likeness];
  }
  return best;
}

/** How many characters two words have in common, in the same order. */
function common(one, other) {
  let before = new Array(other.length + 1).fill(0);
  for (const letter of one) {
    const now = [0];
    for (let j = 0; j < other.length; j++)
      now.push(letter === other[j] ? before[j] + 1 : Math.max(before[j + 1], now[j]));
    before = now;
  }
  return before[other.length];
}
