// Predictions made in the page by any predictor of a registry, through the whole pipeline.

import { isRefused } from "../prediction/row.js";

/**
 * @param {import("../prediction/assembly.js").Registry} registry @param {string} name of it
 * @returns {import("./source.js").Predictor} its modules are loaded when it is opened
 */
export const whole = (registry, name) => ({
  name,
  async open() {
    const { assemble } = await import("../prediction/assembly.js");
    const pipeline = await assemble(registry, name);
    const add = (row) => {
      const answer = pipeline.advance(row);
      return isRefused(answer) ? null : answer;
    };
    return { add, flush: () => false, close() {} };
  },
});
