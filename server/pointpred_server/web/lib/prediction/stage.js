// A stage: a law, its flat memory, and what is forgotten when.

import { ParameterError } from "./errors.js";
import { Mixture, partRows } from "./mixture.js";
import { packed, unpacked } from "./person.js";

/**
 * @typedef {number[]} Row
 * @typedef {import("./parameters.js").Parameter} Parameter
 * @typedef {{parameters: Parameter[], step: (memory: Float64Array, row: Row, coefficients?: any) => Row,
 *   conclude?: (memory: Float64Array) => void, enter_scene?: (memory: Float64Array, scene: number[]) => void,
 *   list_places?: (memory: Float64Array, out: Float64Array[]) => number,
 *   list_parts?: (memory: Float64Array, out: Float64Array[]) => number[], fill: (values: Float64Array, memory: Float64Array) => void,
 *   settle?: (memory: Float64Array) => void,
 *   settings: number, learned: number, states: number, sizes?: (values: Float64Array) => number[],
 *   slots?: import("./person.js").Slot[], layout?: string}} Kind what a generated module exports of a class:
 *   the memory holds `settings` floats, then `learned`, then `states`; `sizes`: these three where they follow from the values
 */

/** Places that are remembered, and the numbers of each. */
const CAPACITY = 64,
  FIELDS = 7;
const MOST_PARTS = 5; // of a mixture

/** The memory of one law, and the law. */
export class Stage {
  #kind;
  #sizes;
  #coefficients;
  #memory;
  #first;
  #person;
  #kept;
  #step;

  /** Use `of`. @param {Kind} kind @param {number[]} sizes of the settings, what is learned, the states @param {Float64Array} [coefficients] */
  constructor(kind, sizes, coefficients) {
    const [settings, learned, states] = sizes;
    [this.#kind, this.#sizes, this.#coefficients, this.#step] = [kind, sizes, coefficients, kind.step];
    [this.#person, this.#first] = [settings, settings + learned];
    this.#memory = new Float64Array(this.#first + states);
    this.#kept = this.#memory.slice();
  }

  /**
   * A stage without states. `settle` of the kind still has to be called where it has one.
   * @param {Kind} kind @param {Float64Array} values of its parameters, checked @param {Float64Array} [coefficients] shared
   */
  static of(kind, values, coefficients) {
    const stage = new Stage(kind, kind.sizes?.(values) ?? [kind.settings, kind.learned, kind.states], coefficients);
    kind.fill(values, stage.#memory);
    return stage;
  }

  /** Finishes the settings: what is measured by running the law. */
  settle() {
    this.#kind.settle?.(this.#memory);
  }

  /** Takes in a row; the answer's first number is NaN where it is refused, and nothing has changed then. @param {Row} row @returns {Row} */
  advance(row) {
    return this.#step(this.#memory, row, this.#coefficients);
  }

  /** Remembers the memory as it is now, for one `recall`. */
  keep() {
    this.#kept.set(this.#memory);
  }

  /** Goes on from where `keep` was called. */
  recall() {
    this.#memory.set(this.#kept);
  }

  /** A copy of the memory; setting it goes on from there. @type {Float64Array} */
  get remembered() {
    return this.#memory.slice();
  }

  set remembered(memory) {
    this.#memory.set(memory);
  }

  /** Forgets the movement; what it taught of the person stays. */
  reset() {
    this.#kind.conclude?.(this.#memory);
    this.#memory.fill(0, this.#first);
  }

  /** The cursor is in this window from now on; without effect where no places are learned. @param {number[]} scene */
  enter(scene) {
    this.#kind.enter_scene?.(this.#memory, scene);
  }

  /** The places of the window that the cursor is in, as rows; most stages learn none. @returns {Float64Array[]} */
  get places() {
    if (this.#kind.list_places === undefined) return [];
    const rows = Array.from({ length: CAPACITY }, () => new Float64Array(FIELDS));
    return rows.slice(0, this.#kind.list_places(this.#memory, rows));
  }

  /** The law of the endpoint as places and elsewhere have it; null where none is claimed, and where no places are learned. @returns {Mixture|null} */
  get mixture() {
    const rows = partRows(MOST_PARTS),
      [count, ...offsets] = this.#kind.list_parts?.(this.#memory.slice(), rows) ?? [0];
    return count === 0 ? null : new Mixture(rows.slice(0, count), offsets);
  }

  /** A stage with the same parameters, which remembers nothing. @returns {Stage} */
  fresh() {
    const stage = new Stage(this.#kind, this.#sizes, this.#coefficients);
    stage.#memory.set(this.#memory.subarray(0, this.#person));
    return stage;
  }

  /** Whether finished movements change what is said of the next. */
  get learns() {
    return this.#first > this.#person;
  }

  /** Whether what was learned can be saved. */
  get portable() {
    return this.#kind.slots !== undefined && this.learns;
  }

  /** What was learned of the person; "" where nothing was learned or can be saved. @returns {string} */
  get person() {
    return this.portable ? packed(this.#kind, this.#memory.subarray(this.#person, this.#first)) : "";
  }

  /** Loads a person into a stage without memory; "" leaves it as it is. Throws a ParameterError; the stage is then unchanged. @param {string} person */
  restore(person) {
    if (typeof person !== "string")
      throw new ParameterError(`person must be a string made by a pipeline, received ${typeof person}`, {
        field: "person",
      });
    if (person === "") return;
    if (!this.portable) {
      const message = `person must be '' for a predictor that saves nothing of a person, received ${person.length} characters`;
      throw new ParameterError(message, { field: "person" });
    }
    this.#memory.set(unpacked(this.#kind, person), this.#person);
  }
}
