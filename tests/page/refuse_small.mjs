// The source of a page with stages that count their rows: the predictor refuses rows whose second number is 1, the differentiator 2.
// Gives for each row what both have counted, null where it is refused.

import { inPage } from "../../server/pointpred_server/web/lib/intent/page-source.js";
import { answer, given } from "./given.mjs";

const counting = (wrong) => ({
  settings: [],
  states: 1,
  step(memory, row) {
    if (row[1] === wrong) return [NaN];
    memory[0] += 1;
    return [...row, memory[0]];
  },
});
const { rows } = await given(),
  source = await inPage("counting", async () => [counting(2), counting(1)]).open();
answer(rows.map((row) => source.add(row)?.slice(2) ?? null));
