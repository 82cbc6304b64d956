// What a stage has learned of its person, as a short string and back: the same strings as `pointpred/person.py`.

import { digest } from "./blake2b.js";
import { ParameterError } from "./errors.js";
import { general } from "./words.js";

const LARGEST = 16384; // characters of a person, at most
const VERSION = "1."; // of the string; what the numbers mean is the layout's
const DIGEST = 8; // bytes of the layout's name, and of the digest of all before it

/**
 * @typedef {{name: string, count: number, low: number, high: number, whole?: boolean}} Slot a run of numbers that a stage
 *   knows of its person, with the closed bounds of each
 * @typedef {{slots: Slot[], layout: string, fault?: (known: Float64Array) => number[]}} Learner slots in the order of
 *   the numbers; layout: 16 hexadecimal digits that name them; fault: a law that says what is wrong with numbers within
 *   their bounds, 0 for nothing, and one of the wrong numbers
 */

const refusal = (message) => new ParameterError(message, { field: "person" });

/** Learned numbers as a string; "" if nothing was learned. @param {Learner} learner @param {Float64Array} known @returns {string} */
export function packed({ layout }, known) {
  if (!known.some((value) => value !== 0)) return "";
  const bytes = new Uint8Array(8 * known.length + 2 * DIGEST),
    view = new DataView(bytes.buffer);
  bytes.set(/** @type {string[]} */ (layout.match(/../g)).map((pair) => Number.parseInt(pair, 16)));
  known.forEach((value, i) => view.setFloat64(DIGEST + 8 * i, value, true));
  bytes.set(digest(bytes.subarray(0, -DIGEST)), bytes.length - DIGEST);
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return VERSION + btoa(binary).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

/**
 * The learned numbers of a string that is not empty, as many as the slots say.
 * Throws a ParameterError for an invalid or damaged string, one of another layout, or one with an impossible number.
 * @param {Learner} learner @param {string} person @returns {Float64Array}
 */
export function unpacked(learner, person) {
  const known = numbers(learner, person);
  const wrong = outside(learner.slots, known) || faulty(learner, known);
  if (wrong) throw refusal(`person contains an impossible value: ${wrong}`);
  return known;
}

function numbers(learner, person) {
  if (person.length > LARGEST) throw refusal(`person may have ${LARGEST} characters, received ${person.length}`);
  if (!person.startsWith(VERSION)) throw refusal(`person must begin with '${VERSION}', as pipelines write it`);
  const bytes = decoded(person.slice(VERSION.length)),
    count = learner.slots.reduce((sum, slot) => sum + slot.count, 0);
  const layout = Array.from(bytes.subarray(0, DIGEST), (byte) => byte.toString(16).padStart(2, "0")).join("");
  if (bytes.length >= 2 * DIGEST && layout !== learner.layout)
    throw refusal("person was saved by another predictor or by another version of this one");
  const whole = bytes.length === 8 * count + 2 * DIGEST,
    view = new DataView(bytes.buffer);
  const known = Float64Array.from({ length: whole ? count : 0 }, (_, i) => view.getFloat64(DIGEST + 8 * i, true));
  if (packed(learner, known) !== person || person === "")
    throw refusal("person is damaged: it must be the whole string, as a pipeline wrote it"); // the digest is compared with all else
  return known;
}

/** The bytes of base64url. @returns {Uint8Array} */
function decoded(written) {
  try {
    if (/[^\w=-]/.test(written)) throw new RangeError(written);
    return Uint8Array.from(atob(written.replace(/=/g, "").replace(/-/g, "+").replace(/_/g, "/")), (letter) =>
      letter.charCodeAt(0),
    );
  } catch {
    throw refusal("person must be base64url after its version, as pipelines write it");
  }
}

/** The first number that is not within the bounds of its slot, in words; "" where there is none. */
function outside(slots, known) {
  let at = 0;
  for (const { name, count, low, high, whole } of slots) {
    const values = known.subarray(at, at + count),
      wrong = values.find((value) => !(value >= low && value <= high));
    if (wrong !== undefined) return `${name} must lie in [${general(low)}, ${general(high)}], is ${general(wrong)}`;
    if (whole && !values.every(Number.isInteger)) return `${name} must be whole, is ${general(values[0])}`;
    at += count;
  }
  return "";
}

/** What the law of a learner finds wrong, in words; "" for nothing. @param {Learner} learner @param {Float64Array} known */
function faulty({ fault }, known) {
  const [wrong, value] = fault?.(known) ?? [0, 0];
  return wrong === 0 ? "" : `its numbers contradict each other (fault ${wrong}, ${general(value)})`;
}
