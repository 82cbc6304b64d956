// Pipelines of the predictors of a registry, as `pointpred.build` makes them in Python.

import { Aim as Targets } from "../laws/targets/aim.js";
import { Aim } from "./aim.js";
import { checkTogether } from "./combinations.js";
import { unknown, valuesOf } from "./parameters.js";
import { Pipeline } from "./pipeline.js";
import { Stage } from "./stage.js";

/**
 * @typedef {{cpi?: number|null, dpi?: number, person?: string, targets?: readonly import("../index.d.ts").Target[], differentiator?: string}} BuildOptions and every parameter
 *   of the predictor and the differentiator by its name. cpi: counts per inch of the device; with it motor motion comes from
 *   the counts of events, without it from the cursor and `dpi`, px per inch (96). person: what `person` of a pipeline of this name was;
 *   targets: what `register` takes
 */

/**
 * All predictors, as `../laws/registry.js` has them, or one, as `../laws/only/` has each.
 * @typedef {{differentiator: string, preset?: Object<string, number>, load: () => Promise<import("./stage.js").Kind>,
 *   coefficients?: () => Promise<Float64Array>}} Entry of a predictor
 * @typedef {{GAINS: Object<string, number>, PREDICTORS: Object<string, Entry>,
 *   DIFFERENTIATORS: Object<string, {load: Entry["load"]}>}} Registry
 */

/**
 * A fresh pipeline for a name of a registry. Only the modules of that name are loaded.
 * Rejects with a ParameterError for an unknown name or parameter, a value out of bounds, and an unusable person.
 * @param {Registry} registry @param {string} name @param {BuildOptions & Object<string, unknown>} [options] undefined counts as not given
 * @returns {Promise<Pipeline>}
 */
export async function assemble({ DIFFERENTIATORS, GAINS, PREDICTORS }, name, options = {}) {
  const entry = entryOf(PREDICTORS, "predictor", name);
  const {
    cpi = null,
    dpi = 96,
    person = "",
    targets = [],
    differentiator: chosen = entry.differentiator,
    ...given
  } = options;
  const source = entryOf(DIFFERENTIATORS, "differentiator", chosen);
  const [predictorKind, differentiatorKind, coefficients] = await Promise.all([
    entry.load(),
    source.load(),
    entry.coefficients?.(),
  ]);
  refuseUnknown(name, given, [...predictorKind.parameters, ...differentiatorKind.parameters, ...Targets.parameters]);
  const values = { ...GAINS, ...entry.preset, ...withoutUndefined(given), cpi, dpi };
  const ofPredictor = valuesOf(predictorKind.parameters, values);
  const ofDifferentiator = valuesOf(differentiatorKind.parameters, values);
  const differentiator = Stage.of(differentiatorKind, ofDifferentiator);
  checkTogether(chosen, namedValues(differentiatorKind.parameters, ofDifferentiator), differentiator);
  differentiator.settle();
  const predictor = Stage.of(predictorKind, ofPredictor, coefficients);
  const pipeline = new Pipeline(name, differentiator, predictor);
  if (Targets.parameters.some((one) => given[one.name] !== undefined))
    pipeline.aim = new Aim(valuesOf(Targets.parameters, given));
  pipeline.restore(person);
  if (targets?.length !== 0) pipeline.register(targets);
  return pipeline;
}

const withoutUndefined = (options) =>
  Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
const namedValues = (parameters, values) => Object.fromEntries(parameters.map(({ name }, i) => [name, values[i]]));

/** What a table has under a name; throws a ParameterError for any other. */
function entryOf(table, kind, name) {
  if (typeof name !== "string" || !Object.hasOwn(table, name)) throw unknown(kind, kind, name, Object.keys(table));
  return table[name];
}

/** Throws a ParameterError for an option that neither stage has. */
function refuseUnknown(name, given, parameters) {
  const known = parameters.map((one) => one.name);
  for (const [word, value] of Object.entries(given))
    if (value !== undefined && !known.includes(word)) throw unknown(`parameter of ${name}`, word, word, known, value);
}
