// Registers elements with the tracker of their predictor; what may be said of an element: defaults, bounds, errors.

import { needDocument } from "../client/document.js";
import { THRESHOLD } from "../laws/targets/prefetch.js";
import { Registration } from "./registration.js";
import { Source } from "./source.js";
import { Tracker } from "./tracker.js";

const CHOICES = {
  policy: ["prefetch", "highlight"],
  touch: ["start", "viewport", "none"],
  scroll: ["pointer", "view", "none"],
  saveData: ["respect", "ignore"],
};
const NUMBERS = { priority: [0, 1e6], threshold: [0, 1], again_s: [0, Infinity], keyboard: [0, 20] };
const DEFAULTS = {
  policy: "prefetch",
  name: "",
  hitSlop: 0,
  priority: 1,
  threshold: THRESHOLD,
  once: undefined,
  again_s: Infinity,
  keyboard: 2,
  touch: "start",
  scroll: "pointer",
  saveData: "respect",
};
const SIDES = ["top", "right", "bottom", "left"];

/** The trackers in use, by their predictor and service. @type {Map<string, Tracker>} */
export const trackers = new Map();

/**
 * The predictors that an entry of the package offers.
 * @typedef {{defaults?: object, choices?: Object<string, string[]>, of: (options: object) => import("./source.js").Predictor}} Offer
 *   `defaults`, `choices`: the options that choose among them; `of`: the one that is chosen
 */

/**
 * `onIntent` with these predictors. It calls `callback` when the user is heading for an element. Throws a TypeError or a RangeError
 * for options that cannot be used.
 * @param {Offer} offer
 * @returns {(element: Element, callback: import("../index.d.ts").IntentCallback, options?: import("../index.d.ts").IntentOptions) => () => void}
 *   what it returns stops it; the last one to stop leaves no listener on the page
 */
export const onIntentWith = (offer) =>
  function onIntent(element, callback, options) {
    needDocument("onIntent");
    if (typeof callback !== "function") throw new TypeError(`onIntent needs a function to call, received ${callback}`);
    return begin(offer, element, callback, options).stop;
  };

/**
 * `register` with these predictors. It registers an element without a callback, so that its neighbours are predicted by mistake less often.
 * @param {Offer} offer
 * @returns {(element: Element, options?: import("../index.d.ts").IntentOptions) => import("../index.d.ts").Handle}
 */
export const registerWith = (offer) =>
  function register(element, options) {
    needDocument("register");
    return begin(offer, element, null, options);
  };

function begin(offer, element, callback, given) {
  if (!(element instanceof Element)) throw new TypeError(`an element of the page is needed, received ${element}`);
  const options = optionsOf(offer, given);
  const registration = new Registration(element, callback, options);
  const tracker = trackerOf(offer.of(options));
  tracker.add(registration);
  return {
    element,
    ready: tracker.ready,
    stop: () => tracker.remove(registration),
    get share() {
      return tracker.share(element);
    },
  };
}

/** The tracker of a predictor; the first registration begins it. */
function trackerOf(predictor) {
  const key = JSON.stringify([predictor.name, predictor.service]);
  if (!trackers.has(key))
    trackers.set(
      key,
      new Tracker(
        (onAnswer) => new Source(predictor, onAnswer),
        () => trackers.delete(key),
      ),
    );
  return trackers.get(key);
}

/**
 * The options with their defaults. Throws a TypeError for one that is unknown or of another type, a RangeError for a number
 * out of bounds.
 * @param {Offer} offer @param {import("../index.d.ts").IntentOptions} given
 * @returns {Required<import("../index.d.ts").IntentOptions> & {hitSlop: {top: number, right: number, bottom: number, left: number}}}
 */
function optionsOf({ defaults, choices }, given = {}) {
  const options = { ...DEFAULTS, ...defaults };
  for (const [name, value] of Object.entries(given)) {
    if (!(name in options)) throw new TypeError(`unknown option ${name}; known: ${Object.keys(options).join(", ")}`);
    if (value !== undefined) options[name] = value;
  }
  for (const [name, known] of Object.entries({ ...CHOICES, ...choices }))
    if (!known.includes(options[name]))
      throw new TypeError(`${name} must be one of ${known.join(", ")}, received ${options[name]}`);
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
