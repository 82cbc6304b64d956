// The stages of any predictor, with the values that its registry has for them.

/**
 * @param {import("../prediction/assembly.js").Registry} registry @param {string} name of it
 * @returns {Promise<import("./page-source.js").Stage[]>} the differentiator and the predictor
 */
export async function usualStages({ DIFFERENTIATORS, GAINS, PREDICTORS }, name) {
  const { differentiator: law, preset, load, coefficients: loadCoefficients } = PREDICTORS[name];
  const [differentiator, predictor, coefficients] = await Promise.all([
    DIFFERENTIATORS[law].load(),
    load(),
    loadCoefficients?.(),
  ]);
  const given = { ...GAINS, ...preset };
  return [stageOf(differentiator, given), { ...stageOf(predictor, given), coefficients }];
}

/** @param {import("../prediction/stage.js").Kind} kind @param {Object<string, number>} given */
function stageOf({ parameters, step, fill, settle, ...kind }, given) {
  const values = Float64Array.from(parameters, ({ name, default: usual, absent }) => given[name] ?? usual ?? absent);
  const [first, learned, states] = kind.sizes?.(values) ?? [kind.settings, kind.learned, kind.states];
  const settings = new Float64Array(first + learned + states);
  fill(values, settings);
  settle?.(settings);
  return { step, settings, states: 0 };
}
