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
  const valuesOf = ({ parameters }) =>
    parameters.map(({ name: word, default: usual, absent }) => given[word] ?? usual ?? absent);
  return [
    { ...differentiator, values: valuesOf(differentiator) },
    { ...predictor, values: valuesOf(predictor), coefficients },
  ];
}
