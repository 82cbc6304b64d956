// Predictions made in the page by a predictor of a registry, with the values that the registry has for it.
// `build` gives the same predictions; it also checks values of one's own, restores persons and says why an event is refused.

import { isRefused } from "../prediction/row.js";

/**
 * @param {import("../prediction/assembly.js").Registry} registry @param {string} name of it
 * @returns {import("./source.js").Predictor} what it still needs is loaded when it is opened
 */
export const inPage = (registry, name) => ({ name, open: () => open(registry, name) });

async function open({ DIFFERENTIATORS, GAINS, PREDICTORS }, name) {
  const { differentiator: law, preset, load, coefficients: loadCoefficients } = PREDICTORS[name];
  const [ofMotion, ofEndpoint, coefficients] = await Promise.all([
    DIFFERENTIATORS[law].load(),
    load(),
    loadCoefficients?.(),
  ]);
  const values = { ...GAINS, ...preset, cpi: null, dpi: 96 };
  const differentiator = stageOf(ofMotion, values);
  const predictor = stageOf(ofEndpoint, values, coefficients);
  const before = differentiator.memory.slice();
  return {
    add(row) {
      before.set(differentiator.memory);
      const motion = differentiator.step(row),
        answer = isRefused(motion) ? motion : predictor.step(motion);
      if (!isRefused(answer)) return answer;
      differentiator.memory.set(before); // it has moved on where the predictor refuses its motion
      return null;
    },
    flush: () => false,
    close() {},
  };
}

/** A law and a memory of its own. */
function stageOf({ parameters, step, fill, settle, ...kind }, values, coefficients) {
  const settings = Float64Array.from(parameters, ({ name, default: usual, absent }) => values[name] ?? usual ?? absent);
  const [first, learned, states] = kind.sizes?.(settings) ?? [kind.settings, kind.learned, kind.states];
  const memory = new Float64Array(first + learned + states);
  fill(settings, memory);
  settle?.(memory);
  return { memory, step: (row) => step(memory, row, coefficients) };
}
