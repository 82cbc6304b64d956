// The scores of a whole file that was opened.

import { part, write } from "./elements.js";
import { expectScores, scoreTable, sentence, setOf } from "./scores.js";
import { score } from "./service.js";

/**
 * Lets the service score a file and shows what it found.
 * @param {string} csv the samples file @param {string[]} names of the predictors that will be scored
 * @param {() => boolean} wanted whether this file is still the one shown
 */
export async function showScores(csv, names, wanted) {
  const said = part("replay-scored"), table = part("replay-scores");
  write(said, "The service scores every predictor on this file…");
  expectScores(table, names);
  try {
    const set = setOf(await score(csv));
    if (!wanted()) return;
    scoreTable(table, set);
    write(said, sentence(set));
  } catch (error) {
    if (!wanted()) return;
    expectScores(table, names, "–");
    write(said, `Not scored: ${error.message}.`);
  }
}
