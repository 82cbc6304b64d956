// Where replayed movements come from: the embedded sample, or a recording that the person has opened.

import { hasService, sample, samples } from "../service/service.js";
import { count } from "../shell/numbers.js";
import { readFiles } from "./csv.js";
import { predictionsAlong } from "./predictions.js";

/**
 * @typedef {{title: string, description: string, isSample: boolean, names: string[],
 *   movement: (index: number, predictors: string[]) => Promise<import("./picture.js").Movement>}} Source
 */

/** Where a recording that the person opens goes. */
const WHERE = hasService
  ? "It stays in this page unless you choose to predict by the service."
  : "It stays in this page.";

/** The predictions of several predictors along the events of a movement, by their names. */
async function predictionsOf(rows, predictors, resolution) {
  const columns = await Promise.all(predictors.map((one) => predictionsAlong(rows, one, resolution)));
  return Object.fromEntries(predictors.map((one, i) => [one, columns[i]]));
}

/** The embedded sample. @returns {Promise<Source>} */
export async function sampleSource() {
  const listed = await samples();
  return {
    title: "the embedded sample",
    description:
      "The people in this sample are simulated: no recording of a person is included. Each prediction uses only the events before it.",
    isSample: true,
    names: listed.map(({ name, events }) => `${name} (${events} events)`),
    async movement(index, predictors) {
      const { user, target, t, x, y, dx, dy, buttons, ...resolution } = await sample(listed[index].name);
      const rows = t.map((time, i) => [time, x[i], y[i], dx[i], dy[i], buttons[i]]);
      return {
        target,
        person: `simulated person ${user}`,
        t,
        x,
        y,
        predictions: await predictionsOf(rows, predictors, resolution),
      };
    },
  };
}

/** A recording in pointpred's own CSV; a movement is predicted when it is shown. @param {File[]} files @returns {Promise<Source>} */
export async function fileSource(files) {
  const { name, skipped, reason, movements, simulated, ...resolution } = await readFiles(files);
  return {
    title: name,
    description: `${name}: ${count(movements.length, "movement")}${skipped ? `, ${skipped} more cannot be shown (${reason})` : ""}. ${WHERE}`,
    isSample: false,
    names: movements.map(({ user, name: trial, rows }) => `${user} ${trial} (${rows.length} events)`),
    async movement(index, predictors) {
      const { user, target, rows } = movements[index];
      return {
        target,
        person: `${simulated ? "simulated person" : "person"} ${user}`,
        t: rows.map(([t]) => t - rows[0][0]),
        x: rows.map(([, x]) => x),
        y: rows.map(([, , y]) => y),
        predictions: await predictionsOf(rows, predictors, resolution),
      };
    },
  };
}
