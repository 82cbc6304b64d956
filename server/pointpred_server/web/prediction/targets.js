// The rectangles that a pointer may be heading for, as the table that laws walk over.

import { LARGEST } from "../laws/records.js";
import * as rectangles from "../laws/targets/rectangles.js";
import { ParameterError } from "./errors.js";
import { general, quoted } from "./words.js";

const { FIELDS, MOST_TARGETS, SMALLEST_PX } = rectangles;
const BOUNDS = [["x", -LARGEST], ["y", -LARGEST], ["width", SMALLEST_PX], ["height", SMALLEST_PX], ["weight", 0]];
const WHOLE = 1 + 1e-9; // the largest share of a place: sums of shares are rounded
const BOUNDS_OF_PLACES = [["x", -LARGEST, LARGEST], ["y", -LARGEST, LARGEST], ["p", 0, WHOLE], ["before", 0, WHOLE], ["spread", 0, LARGEST]];

/**
 * The table of targets: a row each. Throws a ParameterError for more than 1000, an id that occurs twice, and a place, size
 * or weight that is no number or out of bounds.
 * @param {{id: unknown, x: number, y: number, width: number, height: number, weight?: number}[]} targets px @returns {Float64Array[]}
 */
export function tableOf(targets) {
  if (targets.length > MOST_TARGETS) throw new ParameterError(`at most ${MOST_TARGETS} targets, received ${targets.length}`);
  const ids = new Set();
  const table = targets.map(({ id, x, y, width, height, weight = 1 }) => {
    if (ids.has(id)) throw new ParameterError(`the id of a target must occur once, received ${quoted(id)} twice`);
    ids.add(id);
    const row = Float64Array.of(x, y, width, height, weight);
    for (let k = 0; k < FIELDS; k++) if (!(row[k] >= BOUNDS[k][1] && row[k] <= LARGEST)) throw outOfBounds(id, k, row[k]);
    return row;
  });
  rectangles.complete(table);
  return table;
}

/**
 * Throws a ParameterError for places of which two have one id, and for a number that is out of bounds.
 * @param {import("./pipeline.js").Place[]} places
 */
export function checkPlaces(places) {
  const ids = new Set();
  for (const place of places) {
    const { id } = place;
    if (ids.has(id)) throw new ParameterError(`the id of a place must occur once, received ${quoted(id)} twice`, { field: "id", value: id });
    ids.add(id);
  }
  for (const place of places)
    for (const [name, low, high] of BOUNDS_OF_PLACES) {
      const value = place[name];
      if (value >= low && value <= high) continue;
      const message = `${name} of place ${quoted(place.id)} must lie in [${general(low)}, ${general(high)}], received ${value}`;
      throw new ParameterError(message, { field: name, value });
    }
}

function outOfBounds(id, k, value) {
  const [name, low] = BOUNDS[k], unit = name === "weight" ? "" : " px";
  const message = `${name} of target ${quoted(id)} must lie in [${general(low)}, ${general(LARGEST)}]${unit}, received ${value}`;
  return new ParameterError(message, { value });
}
