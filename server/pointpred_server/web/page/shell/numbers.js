// Numbers: as they are written in the page, and their averages.

export { median } from "../../lib/prediction/leads.js";

const NONE = "–";

/** A number with a number of decimals and a unit; a dash if there is no number. */
export function number(value, decimals = 0, unit = "") {
  if (value === null || value === undefined || !Number.isFinite(value)) return NONE;
  return value.toFixed(decimals) + (unit && ` ${unit}`);
}

/** A count with its noun, in the plural unless it is one. */
export const count = (value, noun) => `${value} ${noun}${value === 1 ? "" : "s"}`;

/** A share in per cent. */
export const percent = (share, decimals = 0) => number(share === null ? null : 100 * share, decimals, "%");

/** The arithmetic mean; NaN of no values. */
export const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** The smallest and the largest value; spreading a long array as arguments would fail. */
export function bounds(values) {
  return values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
}
