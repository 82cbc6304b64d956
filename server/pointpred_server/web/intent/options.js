// What may be said of an element that is registered: its defaults, and the errors that name the bounds.

import { PREDICTORS, RECOMMENDED } from "../laws/registry.js";
import { THRESHOLD } from "../laws/targets/prefetch.js";

const CHOICES = { predictor: Object.keys(PREDICTORS), policy: ["prefetch", "highlight"], touch: ["start", "viewport", "none"],
  scroll: ["pointer", "view", "none"],
  saveData: ["respect", "ignore"] };
const NUMBERS = { priority: [0, 1e6], threshold: [0, 1], again_s: [0, Infinity], keyboard: [0, 20] };
const DEFAULTS = { policy: "prefetch", predictor: RECOMMENDED, service: undefined, name: "", hitSlop: 0, priority: 1, threshold: THRESHOLD,
  once: undefined, again_s: Infinity, keyboard: 2, touch: "start", scroll: "pointer", saveData: "respect" };
const SIDES = ["top", "right", "bottom", "left"];

/**
 * The options with their defaults. Throws a TypeError for one that is unknown or of another type, a RangeError for a number
 * out of bounds.
 * @param {import("../index.d.ts").IntentOptions} given
 * @returns {Required<import("../index.d.ts").IntentOptions> & {hitSlop: {top: number, right: number, bottom: number, left: number}}}
 */
export function optionsOf(given = {}) {
  const options = { ...DEFAULTS };
  for (const [name, value] of Object.entries(given)) {
    if (!(name in DEFAULTS)) throw new TypeError(`unknown option ${name}; known: ${Object.keys(DEFAULTS).join(", ")}`);
    if (value !== undefined) options[name] = value;
  }
  for (const [name, known] of Object.entries(CHOICES))
    if (!known.includes(options[name])) throw new TypeError(`${name} must be one of ${known.join(", ")}, received ${options[name]}`);
  for (const [name, [low, high]] of Object.entries(NUMBERS)) checkNumber(name, options[name], low, high);
  options.once ??= options.policy === "prefetch";
  options.hitSlop = sidesOf(options.hitSlop);
  return options;
}

function checkNumber(name, value, low, high) {
  if (!(typeof value === "number" && value >= low && value <= high))
    throw new RangeError(`${name} must be a number in [${low}, ${high}], received ${value}`);
}

/** Of each side, how far the element counts beyond it, px. */
function sidesOf(slop) {
  const sides = Object.fromEntries(SIDES.map((side) => [side, typeof slop === "number" ? slop : (slop[side] ?? 0)]));
  for (const side of SIDES) checkNumber(`hitSlop ${side}`, sides[side], 0, 10000);
  return sides;
}
