// Predictions made in the page, with the usual values of all parameters.
// `build` gives the same predictions; it also checks values of one's own, restores persons and says why an event is refused.

import { isRefused } from "../prediction/row.js";

/**
 * The law of a stage.
 * @typedef {{step: Function, settings: ArrayLike<number>, states: number, coefficients?: Float64Array}} Stage `settings`: what its memory begins
 *   with; `states`: how many numbers follow, all zero
 */

/**
 * @param {string} name @param {() => Promise<Stage[]>} loadStages the differentiator and the predictor
 * @returns {import("./source.js").InPage} it is loaded when it is opened
 */
export const inPage = (name, loadStages) => ({ name, open: () => open(loadStages) });

async function open(loadStages) {
  const [differentiator, predictor] = (await loadStages()).map(begin);
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

/** A law and a memory of its own. @param {Stage} stage */
function begin({ step, settings, states, coefficients }) {
  const memory = new Float64Array(settings.length + states);
  memory.set(settings);
  return { memory, step: (row) => step(memory, row, coefficients) };
}
