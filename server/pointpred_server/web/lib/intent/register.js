// Registers elements with the tracker of their predictor; what may be said of an element: defaults, bounds, errors.

import { needDocument } from "../client/document.js";
import { THRESHOLD } from "../laws/targets/prefetch.js";
import { checked, checkNumber } from "./options.js";
import { Registration } from "./registration.js";
import { Source } from "./source.js";
import { Tracker } from "./tracker.js";

/** @type {Object<string, (string|number)[]>} */
const KNOWN = {
  policy: ["prefetch", "highlight"],
  touch: ["start", "viewport", "none"],
  scroll: ["pointer", "view", "none"],
  saveData: ["respect", "ignore"],
  enabled: ["a boolean", "a function"],
  attributes: ["a boolean"],
  onError: ["a function"],
  priority: [0, 1e6],
  threshold: [1e-6, 1],
  again_s: [0, Infinity],
  keyboard: [0, 20],
  dwell_s: [0, 60],
};
/** @type {Omit<import("../index.d.ts").IntentOptions, "predictor"|"service">} */
const DEFAULTS = {
  policy: "prefetch",
  name: "",
  hitSlop: 0,
  priority: 1,
  threshold: THRESHOLD,
  enabled: true,
  once: undefined,
  again_s: Infinity,
  dwell_s: 0,
  keyboard: 2,
  touch: "start",
  scroll: "pointer",
  saveData: "respect",
  attributes: false,
  onError: undefined,
};

/** The trackers in use, by their predictor and service. @type {Map<string, Tracker>} */
export const trackers = new Map();

/**
 * @typedef {import("./registration.js").Options} Options
 */

/**
 * The predictors that an entry of the package offers.
 * @typedef {{defaults?: Partial<Options>, choices?: Object<string, string[]>, of: (options: Options) => import("./source.js").Predictor}} Offer
 *   `defaults`, `choices`: the options that choose among them; `of`: the one that is chosen
 */

/**
 * `onIntent` with these predictors. It calls `callback` when the user is heading for an element. Throws a TypeError or a RangeError
 * for elements and options that cannot be used; then none is registered.
 * @param {Offer} offer
 * @returns {(elements: Element|Iterable<Element>, callback: import("../index.d.ts").IntentCallback, options?: import("../index.d.ts").IntentOptions,
 *   subjectOf?: (element: Element) => object) => () => void} what it returns stops it; the last one to stop leaves no listener on the page.
 *   `subjectOf`: what the callback for an element loads; a click on one is a hit of all elements with the same
 */
export const onIntentWith = (offer) =>
  function onIntent(elements, callback, options, subjectOf) {
    needDocument("onIntent");
    if (typeof callback !== "function") throw new TypeError(`a function is needed, received ${callback}`);
    if (!canFollow()) return () => {};
    const handles = begin(offer, listOf(elements), callback, options, subjectOf);
    return () => handles.forEach(({ stop }) => stop());
  };

/**
 * `register` with these predictors. It registers an element without a callback, so that its neighbours are predicted by mistake less often.
 * @param {Offer} offer
 * @returns {(element: Element, options?: import("../index.d.ts").IntentOptions) => import("../index.d.ts").Handle}
 */
export const registerWith = (offer) =>
  function register(element, options) {
    needDocument("register");
    if (!canFollow()) return { element, share: 0, ready: Promise.resolve(), stop() {} };
    return begin(offer, [element], null, options)[0];
  };

/** The elements of a list, such as a NodeList, or the one that is given. */
export const listOf = (given) =>
  given?.[Symbol.iterator] && !given.nodeType && given !== String(given) ? [...given] : [given];

/** What an error calls an element. */
export const named = (one) => (one?.localName ? `<${one.localName}${one.id ? ` id="${one.id}"` : ""}>` : String(one));

/** Whether elements can be followed here: not in documents of jsdom, which tests of components run in. */
export const canFollow = () => "IntersectionObserver" in window && "reportError" in window;

/** Registers elements, all or none. */
function begin(offer, elements, callback, given, subjectOf) {
  const options = optionsOf(offer, given);
  elements.forEach(check);
  if (elements.length === 0) return [];
  const tracker = trackerOf(offer.of(options));
  return elements.map((element) => {
    const registration = new Registration(element, callback, options, subjectOf && (() => subjectOf(element)));
    tracker.add(registration);
    return {
      element,
      ready: tracker.ready,
      stop: () => tracker.remove(registration),
      get share() {
        return tracker.share(element);
      },
    };
  });
}

function check(element) {
  const view = element?.ownerDocument?.defaultView;
  if (view && view !== window) throw new TypeError(`${named(element)} is in a frame: load pointpred there`);
  if (!(element instanceof Element)) throw new TypeError(`an element is needed, received ${named(element)}`);
}

/** The tracker of a predictor; the first registration begins it. @param {import("./source.js").Predictor} predictor */
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
  return /** @type {Tracker} */ (trackers.get(key));
}

/** The options with their defaults, checked. @param {Offer} offer @param {import("../index.d.ts").IntentOptions|undefined} given @returns {Options} */
function optionsOf({ defaults, choices }, given) {
  const options = checked(given, { ...DEFAULTS, ...defaults }, { ...KNOWN, ...choices });
  options.once ??= options.policy === "prefetch";
  options.hitSlop = sidesOf(options.hitSlop);
  return /** @type {Options} */ (options);
}

/** Of each side, how far the element counts beyond it, px. */
function sidesOf(slop) {
  const sides = { top: 0, right: 0, bottom: 0, left: 0 };
  const given = Object(slop) === slop ? slop : { top: slop, right: slop, bottom: slop, left: slop };
  for (const [side, px] of Object.entries(given)) {
    if (!(side in sides)) throw new TypeError(`unknown side ${side} of hitSlop`);
    sides[side] = px ?? 0;
    checkNumber(`hitSlop ${side}`, sides[side], [0, 10000]);
  }
  return sides;
}
