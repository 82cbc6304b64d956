// The rectangles a cursor may be heading for, as the table that laws take; as `pointpred/targets/rectangles.py`.

import { LARGEST } from "../laws/records.js";
import { complete, LEAST, MOST_TARGETS } from "../laws/targets/rectangles.js";
import { keyOf } from "./blake2b.js";
import { ParameterError } from "./errors.js";
import { general, quoted } from "./words.js";

/**
 * @typedef {{id: unknown, x: number, y: number, width: number, height: number, weight?: number, kind?: string}} Target its upper
 *   left corner and size, px; weight: how likely it is before the cursor moves, relative to the others; kind: what it is to the
 *   user, such as "button"
 */

const FIELDS = ["x", "y", "width", "height", "weight"];

/** The table of targets: a row each. Throws a ParameterError for too many, and for what is not usable. @param {readonly Target[]} targets */
export function tableOf(targets) {
  if (targets.length > MOST_TARGETS)
    throw new ParameterError(`at most ${MOST_TARGETS} targets, received ${targets.length}`);
  const ids = new Set();
  for (const { id } of targets) {
    if (ids.has(id))
      throw new ParameterError(`the id of a target must occur once, received ${quoted(id)} twice`, { value: id });
    ids.add(id);
  }
  const table = targets.map(rowOf);
  complete(table);
  return table;
}

/** The numbers of a target, all within their bounds. */
function rowOf({ weight = 1, ...place }) {
  const given = { ...place, weight },
    row = Float64Array.from(FIELDS, (name) => given[name]);
  const wrong = row.findIndex((value, k) => !(value >= LEAST[k] && value <= LARGEST));
  if (wrong < 0) return row;
  const name = FIELDS[wrong],
    bounds = `[${general(LEAST[wrong])}, ${general(LARGEST)}]${name === "weight" ? "" : " px"}`;
  throw new ParameterError(`${name} of target ${quoted(place.id)} must lie in ${bounds}, received ${given[name]}`, {
    value: row[wrong],
  });
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
