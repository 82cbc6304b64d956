// A prediction as a row: t, x, y, sxx, sxy, syy, remaining_s, phase, tail, remaining_spread; NaN where nothing is claimed.

/** The phases of a movement, at the places that a row says. */
export const PHASES = /** @type {const} */ (["still", "ballistic", "corrective"]);
/** The place of the time left, s. */
export const REMAINING_S = 6;
/** The row where nothing is predicted. Not to be written to. */
export const UNPREDICTED = Array(10).fill(NaN);

/** Whether the answer to an event says that it was refused. @param {number[]} answer */
export const isRefused = (answer) => answer[0] !== answer[0];

/** A number of a row; null where it is not claimed. @param {number} value @returns {number|null} */
export const claimed = (value) => (value === value ? value : null);

/**
 * A row as the message that a service sends. @param {number[]} row
 * @param {string|null} [target] the id of the likeliest of all, null: none of the targets; undefined in a session without
 * @param {{id: string, p: number}[]} [targets] the likeliest
 * @returns {import("../index.d.ts").Prediction}
 */
export function messageOf(row, target, targets) {
  const [t, x, y, , , , remaining, phase, , spread] = row,
    predicted = x === x;
  return {
    type: "prediction",
    t,
    x: predicted ? x : null,
    y: predicted ? y : null,
    region: predicted ? regionIn(row) : null,
    phase: predicted ? PHASES[phase] : null,
    remaining_s: predicted ? claimed(remaining) : null,
    remaining_spread: predicted ? claimed(spread) : null,
    ...(target !== undefined && { target }),
    ...(targets && { targets }),
  };
}

/** The law of the endpoint as `regionOf` takes it, px^2; null where none is claimed. @param {number[]} row @returns {{sxx: number, sxy: number, syy: number, tail: number|null}|null} */
export const regionIn = ([, , , sxx, sxy, syy, , , tail]) =>
  sxx === sxx ? { sxx, sxy, syy, tail: claimed(tail) } : null;
