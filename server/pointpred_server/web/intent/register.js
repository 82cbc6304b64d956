// Registers elements with the tracker of their predictor.

import { optionsOf } from "./options.js";
import { Registration } from "./registration.js";
import { Source } from "./source.js";
import { Tracker } from "./tracker.js";

/** The trackers in use, by their predictor and service. @type {Map<string, Tracker>} */
export const trackers = new Map();

/**
 * Calls `callback` when the user is heading for an element. Throws a TypeError or a RangeError for options that cannot be used.
 * @param {Element} element @param {import("../index.d.ts").IntentCallback} callback @param {import("../index.d.ts").IntentOptions} [options]
 * @returns {() => void} stops it; the last one to stop leaves no listener on the page
 */
export function onIntent(element, callback, options) {
  if (typeof callback !== "function") throw new TypeError(`onIntent needs a function to call, received ${callback}`);
  return begin(element, callback, options).stop;
}

/**
 * Registers an element without a callback, so that its neighbours are predicted by mistake less often.
 * @param {Element} element @param {import("../index.d.ts").IntentOptions} [options]
 * @returns {import("../index.d.ts").Handle}
 */
export function register(element, options) {
  return begin(element, null, options);
}

function begin(element, callback, given) {
  if (!(element instanceof Element)) throw new TypeError(`an element of the page is needed, received ${element}`);
  const options = optionsOf(given);
  const registration = new Registration(element, callback, options);
  const tracker = trackerOf(options);
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
function trackerOf({ predictor, service }) {
  const key = JSON.stringify([predictor, service]);
  if (!trackers.has(key)) trackers.set(key, new Tracker((onAnswer) => new Source(predictor, service, onAnswer), () => trackers.delete(key)));
  return trackers.get(key);
}
