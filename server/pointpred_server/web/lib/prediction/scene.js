// The window or page that the cursor moves in, as laws know it; as `pointpred/scene.py`.

import { LARGEST } from "../laws/records.js";
import { numberOf } from "./blake2b.js";
import { ParameterError } from "./errors.js";
import { general, quoted } from "./words.js";

/** Where nobody named a window. */
export const SCREEN = Object.freeze([0, 0, 0]);

/**
 * The window of a name with its origin at (x, y) px; "" is the screen. Throws a ParameterError for a name that is no text of
 * whole characters and an origin that is no number or lies beyond the bounds of positions.
 * @param {string} key @param {number} x @param {number} y @returns {[number, number, number]}
 */
export function sceneOf(key, x, y) {
  if (typeof key !== "string")
    throw new ParameterError(`key must be a string, received ${quoted(key)}`, { field: "key", value: key });
  if (/\p{Surrogate}/u.test(key))
    throw new ParameterError(`key must hold whole Unicode characters, received ${quoted(key)}`, {
      field: "key",
      value: key,
    });
  for (const [field, value] of /** @type {[string, number][]} */ ([
    ["x", x],
    ["y", y],
  ]))
    if (typeof value !== "number" || !(Math.abs(value) <= LARGEST)) {
      const message = `${field} of the origin must be a number in [${general(-LARGEST)}, ${general(LARGEST)}] px, received ${quoted(value)}`;
      throw new ParameterError(message, { field, value });
    }
  return [key === "" ? 0 : numberOf(key), x, y];
}
