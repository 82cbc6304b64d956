// What can be pointed at, how likely each target is, and the prediction given these; as `pointpred/targets/aim.py`.

import * as law from "../laws/targets/aim.js";
import { STATES } from "../laws/targets/cursor.js";
import { rank } from "../laws/targets/decision.js";
import { begin, CURSOR, LENGTH } from "../laws/targets/heading.js";
import { FITTED } from "../laws/targets/posterior.js";
import { LOG_WEIGHT } from "../laws/targets/rectangles.js";
import { Mixture, partRows } from "./mixture.js";
import { valuesOf } from "./parameters.js";
import { packed, unpacked } from "./person.js";
import { Keys, tableOf } from "./targets.js";

/** @typedef {import("../index.d.ts").Target} Target */

/** The last stage of a pipeline. What is known of the person stays in it. */
export class Aim {
  /** What is known of the person, the cursor and the movement, as laws take it. */ memory = new Float64Array(LENGTH);
  /** Of the targets, in their order. @type {unknown[]} */ ids = [];
  /** The registered targets. @type {readonly Target[]} */ list = [];
  #values;
  #targets;
  #keys = new Keys();

  /** @param {Float64Array} [values] of its parameters, checked */
  constructor(values = valuesOf(law.Aim.parameters, {})) {
    this.#values = values;
    law.Aim.fill(values, this.memory);
    this.register([]);
  }

  /** Takes these targets in place of those before; throws a ParameterError, and then changes nothing. @param {readonly Target[]} targets */
  register(targets) {
    const table = tableOf(targets),
      keys = this.#keys.of(targets); // an id that is no text throws
    this.list = [...targets];
    this.ids = targets.map(({ id }) => id);
    this.#targets = [
      table,
      Float64Array.from(table, (row) => row[LOG_WEIGHT]),
      keys,
      new Float64Array(table.length + 1),
    ];
    begin(this.memory, this.#targets);
  }

  /** The targets as laws take them, with their weights before the movement. @type {Float64Array[]} */
  get table() {
    return this.#targets[0];
  }

  /** The numbers of the targets. @type {Float64Array[]} */
  get keys() {
    return this.#targets[2];
  }

  /** How likely each target is, in their order; the last: none of them. @type {Float64Array} */
  get shares() {
    return this.#targets[3];
  }

  /** The likeliest targets and their shares, best first. @param {number} [most] @returns {{id: unknown, p: number}[]} */
  likeliest(most = 5) {
    const { ids, shares } = this,
      order = new Float64Array(Math.min(most, ids.length));
    rank(shares, ids.length, order);
    return Array.from(order, (place) => ({ id: ids[place], p: shares[place] }));
  }

  /** The target that is likeliest of all, none of them included; null where none of them is. @returns {unknown} */
  get target() {
    const [best] = this.likeliest(1);
    return best !== undefined && best.p >= /** @type {number} */ (this.shares.at(-1)) ? best.id : null;
  }

  /** The cursor's way, as laws take it. @type {Float64Array} */
  get cursor() {
    return this.memory.subarray(CURSOR, CURSOR + STATES);
  }

  /** One event, and the prediction made at it, through the law. @param {number[]} row @param {number[]} answer @returns {number[]} */
  given(row, answer) {
    return law.step(this.memory, row, answer, this.#targets, FITTED);
  }

  /** The law of the endpoint by the targets; elsewhere it is the predictor's own. Null where no endpoint was stated. @param {Mixture|null} own */
  mixture(own) {
    const rows = partRows(this.ids.length + 1),
      [count, ...offsets] = law.lay_parts(this.memory, this.#targets, rows);
    return count === 0 ? null : new Mixture(rows.slice(0, count), offsets).among(own);
  }

  /** Whether finished movements teach it something. */
  get learns() {
    return this.#values[law.Aim.parameters.findIndex(({ name }) => name === "learn")] === 1;
  }

  /** What finished movements taught of the person; "" where nothing was learned. @returns {string} */
  get person() {
    return packed(law.Aim, this.#known);
  }

  /** Loads a person into an aim without memory. Throws a ParameterError; it is then unchanged. @param {string} person */
  restore(person) {
    this.#known.set(unpacked(law.Aim, person));
  }

  get #known() {
    const { settings, learned } = law.Aim;
    return this.memory.subarray(settings, settings + learned);
  }

  /** A copy of the memory and of what is known of each target before the movement; setting it goes on from there. */
  get remembered() {
    const [table, , , shares] = this.#targets;
    return [this.memory.slice(), table.map((row) => row[LOG_WEIGHT]), shares.slice()];
  }

  set remembered([memory, weights, shares]) {
    this.memory.set(memory);
    this.table.forEach((row, i) => {
      row[LOG_WEIGHT] = weights[i];
    });
    this.shares.set(shares);
  }

  /** Forgets every event, after learning from the movement that ends; the targets stay. */
  reset() {
    law.conclude(this.memory, this.#targets, FITTED);
    this.memory.fill(0, law.Aim.settings + law.Aim.learned);
    begin(this.memory, this.#targets);
  }

  /** The same targets, which remembers no event and knows nobody. @returns {Aim} */
  fresh() {
    const twin = new Aim(this.#values);
    twin.register(this.list);
    return twin;
  }
}
