// Where replayed movements come from: the embedded sample, or a recording that the person has opened.

import { count } from "../page/numbers.js";
import { recording } from "../service/http.js";
import { hasService, inPage } from "../service/place.js";
import { sample, samples } from "../service/samples.js";
import { FileError, isOwnFormat, readFiles } from "./csv.js";
import { predictionsAlong } from "./predictions.js";

/**
 * @typedef {{title: string, description: string, csv: string|Blob|null, columns?: object,
 *   movement: (index: number, predictors: string[]) => Promise<object>, names: string[]}} Source
 */

/** Where a recording that the person opens is sent. */
const WHERE = hasService ? "It is sent to this service only." : "It stays in this page.";

/** The columns of a region's numbers as one region, or null, for each event. */
const regionsOf = (events, region) => Array.from({ length: events }, (_, i) => {
  if (region === null || region.sxx[i] === null) return null;
  return { sxx: region.sxx[i], sxy: region.sxy[i], syy: region.syy[i], tail: region.tail[i] };
});

/** The predictions of several predictors along the events of a movement, by their names. */
async function predictionsOf(rows, predictors, resolution) {
  const columns = await Promise.all(predictors.map((one) => predictionsAlong(rows, one, resolution)));
  return Object.fromEntries(predictors.map((one, i) => [one, columns[i]]));
}

/** The embedded sample: a service predicts from its own copy. @returns {Promise<Source>} */
export async function sampleSource() {
  const listed = await samples();
  return {
    title: "the embedded sample",
    description: "The people in this sample are simulated: no recording of a person is included. Each prediction uses only the events before it.",
    csv: null,
    names: listed.map(({ name, events }) => `${name} (${events} events)`),
    async movement(index, predictors) {
      const page = inPage(), answer = await sample(listed[index].name, page ? [] : predictors);
      const { user, t, x, y, dx, dy, buttons, dpi, cpi } = answer;
      const columns = Object.entries(answer.predictions).map(([name, one]) => [name, { x: one.x, y: one.y, regions: regionsOf(one.x.length, one.region) }]);
      const rows = t.map((time, i) => [time, x[i], y[i], dx[i], dy[i], buttons[i]]);
      const predictions = page ? await predictionsOf(rows, predictors, { dpi, cpi }) : Object.fromEntries(columns);
      return { ...answer, person: `simulated person ${user}`, predictions };
    },
  };
}

/**
 * A recording opened in the page; a movement is predicted when it is shown. Pointpred's own CSV is read by the page, other
 * formats by the service.
 * @param {File[]} files @param {object} columns parameters of the request @returns {Promise<Source>}
 */
export async function fileSource(files, columns = {}) {
  const foreign = files.length === 1 && !(await isOwnFormat(files[0]));
  if (foreign && !hasService) throw new FileError("needs_service", `${files[0].name}: without the service this page reads only pointpred's own CSV, which pointpred convert writes`);
  const { name, csv, skipped, reason, movements, simulated, notes = [], ...resolution } = await (foreign ? uploadFile(files[0], columns) : readFiles(files));
  return {
    title: name,
    description: [`${name}: ${count(movements.length, "movement")}${skipped ? `, ${skipped} more cannot be shown (${reason})` : ""}. ${WHERE}`, ...notes].join(" \u00b7 "),
    csv,
    columns,
    names: movements.map(({ user, name: trial, rows }) => `${user} ${trial} (${rows.length} events)`),
    async movement(index, predictors) {
      const { user, name: trial, target, rows } = movements[index];
      return {
        name: trial, user, target, person: `${simulated ? "simulated person" : "person"} ${user}`,
        t: rows.map(([t]) => t - rows[0][0]), x: rows.map(([, x]) => x), y: rows.map(([, , y]) => y),
        predictions: await predictionsOf(rows, predictors, resolution),
      };
    },
  };
}

/** A file of any format as the service reads it. */
async function uploadFile(file, columns) {
  const { dpi, cpi, simulated, movements, skipped, notes } = await recording(file, columns);
  if (movements.length === 0) throw new Error(`${file.name}: no movement can be used; ${skipped[0]?.reason ?? "it has none"}`);
  return { name: file.name, csv: file, skipped: skipped.length, reason: skipped[0]?.reason ?? "", movements, simulated, notes, dpi, cpi };
}
