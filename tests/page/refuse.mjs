// A pipeline of stages that count their rows, and refuse what a test says: each step is a row, or a list of rows.

import { Pipeline } from "../../server/pointpred_server/web/lib/prediction/pipeline.js";
import { Stage } from "../../server/pointpred_server/web/lib/prediction/stage.js";
import { answer, given } from "./given.mjs";

/** Counts rows; refuses those whose second number is `wrong`, or fails there. @returns {import("../../server/pointpred_server/web/lib/prediction/stage.js").Kind} */
const counting = (wrong) => ({
  parameters: [],
  settings: 0,
  learned: 0,
  states: 20,
  fill() {},
  step(memory, row) {
    if (row[1] === wrong && fails) throw new Error("the law fails");
    if (row[1] === wrong) return [NaN];
    memory[0] += 1;
    return row;
  },
});
const { steps, fails } = await given();
const stages = [counting(2), counting(1)].map((kind) => Stage.of(kind, new Float64Array(0)));
const pipeline = new Pipeline("counting", ...stages);
answer(
  steps.map((step) => {
    try {
      pipeline.advanceAll(step);
    } catch (error) {
      if (!fails) throw error;
    }
    return pipeline.remembered.map((memory) => memory[0]);
  }),
);
