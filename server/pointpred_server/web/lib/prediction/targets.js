// The rectangles a cursor may be heading for, as the table that laws take; as `pointpred/targets/rectangles.py`.

import { LARGEST } from "../laws/records.js";
import { complete, LEAST, MOST_TARGETS } from "../laws/targets/rectangles.js";
import { keyOf } from "./blake2b.js";
import { ParameterError } from "./errors.js";
import { general, quoted } from "./words.js";

/** @import { Target } from "../index.d.ts" */

const FIELDS = ["x", "y", "width", "height", "weight"];

/** The table of targets: a row each. Throws a ParameterError for too many, and for what is not usable. @param {readonly Target[]} targets */
export function tableOf(targets) {
  if (!Array.isArray(targets)) refuse("targets must be an array", targets);
  if (targets.length > MOST_TARGETS) refuse(`at most ${MOST_TARGETS} targets`, targets.length);
  /** @type {Set<unknown>} */ const ids = new Set([null, undefined, NaN]); // what names no target
  // map would leave holes out
  const table = Array.from(targets, (target) => {
    const id = target?.id;
    if (ids.has(id)) refuse("each target must have an id of its own", id);
    ids.add(id);
    return rowOf(target);
  });
  complete(table);
  return table;
}

/** The numbers of a target, all within their bounds. */
function rowOf({ id, ...given }) {
  return Float64Array.from(FIELDS, (name, k) => {
    const value = given[name] === undefined && k > 3 ? 1 : given[name];
    if (!(typeof value === "number" && value >= LEAST[k] && value <= LARGEST))
      refuse(
        `${name} of target ${quoted(id)} must lie in [${general(LEAST[k])}, ${general(LARGEST)}]${k > 3 ? "" : " px"}`,
        value,
      );
    return value;
  });
}

function refuse(must, value) {
  throw new ParameterError(`${must}, received ${quoted(value)}`, { value });
}

/** The numbers of targets, each a row: of its id; of its kind and size, to the nearest power of two of its sides. */
export class Keys {
  #known = new Map(); // of the last targets

  /** @param {readonly Target[]} targets @returns {Float64Array[]} */
  of(targets) {
    const before = this.#known,
      now = new Map();
    this.#known = now;
    const keyed = (text) => {
      const key = now.get(text) ?? before.get(text) ?? keyOf(text);
      now.set(text, key);
      return key;
    };
    const power = (side) => Math.round(Math.log2(side));
    return targets.map(({ id, kind = "", width, height }) =>
      Float64Array.of(keyed(String(id)), keyed(`${kind} ${power(width)} ${power(height)}`)),
    );
  }
}
