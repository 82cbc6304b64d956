// Predictions made in the page by a predictor that needs no coefficients, with the values of the registry.
// `build` gives the same predictions; it also checks values of one's own, restores persons and says why an event is refused.

import { DIFFERENTIATORS, GAINS, PREDICTORS } from "../laws/registry.js";

/** @param {string} predictor a name of the registry @returns {Promise<object>} as `Source` uses it */
export async function open(predictor) {
  const { differentiator, preset, load } = PREDICTORS[predictor], values = { ...GAINS, ...preset, cpi: null, dpi: 96 };
  const kinds = await Promise.all([DIFFERENTIATORS[differentiator].load(), load()]);
  const [differentiate, predict] = kinds.map((kind) => lawOf(kind, values));
  return {
    add(row) {
      const motion = differentiate(row), answer = motion[0] === motion[0] ? predict(motion) : motion; // a refused row is not a number
      return answer[0] === answer[0] ? answer : null;
    },
    flush: () => false,
    close() {},
  };
}

/** The law of a stage with a memory of its own. */
function lawOf(kind, values) {
  const { parameters, step } = kind;
  const settings = Float64Array.from(parameters, ({ name, default: usual, absent }) => values[name] ?? usual ?? absent);
  const [first, learned, states] = kind.sizes?.(settings) ?? [kind.settings, kind.learned, kind.states];
  const memory = new Float64Array(first + learned + states);
  kind.fill(settings, memory);
  kind.settle?.(memory);
  return (row) => step(memory, row);
}
