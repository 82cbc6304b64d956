// Where replayed movements come from: the embedded sample, or a recording that the person has opened.

import { count } from "../page/numbers.js";
import { read, recording } from "../service/http.js";
import { isOwnFormat, readFiles } from "./csv.js";
import { predictionsAlong } from "./predictions.js";

/**
 * @typedef {{title: string, description: string, csv: string|Blob|null, columns?: object,
 *   movement: (index: number, predictors: string[]) => Promise<object>, names: string[]}} Source
 */

/** The columns of a region's numbers as one region, or null, for each event. */
const regionsOf = (events, region) => Array.from({ length: events }, (_, i) => {
  if (region === null || region.sxx[i] === null) return null;
  return { sxx: region.sxx[i], sxy: region.sxy[i], syy: region.syy[i], tail: region.tail[i] };
});

/** The embedded sample: the service computes the predictions from its own copy. @returns {Promise<Source>} */
export async function sampleSource() {
  const { samples } = await read("/v1/samples");
  return {
    title: "the embedded sample",
    description: "The people in this sample are simulated: no recording of a person is included. Each prediction uses only the events before it.",
    csv: null,
    names: samples.map(({ name, events }) => `${name} (${events} events)`),
    async movement(index, predictors) {
      const query = encodeURIComponent(predictors.join(","));
      const answer = await read(`/v1/samples/${encodeURIComponent(samples[index].name)}?predictors=${query}`);
      const columns = Object.entries(answer.predictions).map(([name, { x, y, region }]) => [name, { x, y, regions: regionsOf(x.length, region) }]);
      return { ...answer, person: `simulated person ${answer.user}`, predictions: Object.fromEntries(columns) };
    },
  };
}

/**
 * A recording opened in the page; the events of a movement are sent to the service when it is shown. Pointpred's own CSV is
 * read by the page, other formats by the service.
 * @param {File[]} files @param {object} columns parameters of the request @returns {Promise<Source>}
 */
export async function fileSource(files, columns = {}) {
  const foreign = files.length === 1 && !(await isOwnFormat(files[0]));
  const { name, csv, skipped, reason, movements, simulated, notes = [], ...resolution } = await (foreign ? uploadFile(files[0], columns) : readFiles(files));
  return {
    title: name,
    description: [`${name}: ${count(movements.length, "movement")}${skipped ? `, ${skipped} more cannot be shown (${reason})` : ""}. It is sent to this service only.`, ...notes].join(" \u00b7 "),
    csv,
    columns,
    names: movements.map(({ user, name: trial, rows }) => `${user} ${trial} (${rows.length} events)`),
    async movement(index, predictors) {
      const { user, name: trial, target, rows } = movements[index];
      const predictions = await Promise.all(predictors.map((one) => predictionsAlong(rows, one, resolution)));
      return {
        name: trial, user, target, person: `${simulated ? "simulated person" : "person"} ${user}`,
        t: rows.map(([t]) => t - rows[0][0]), x: rows.map(([, x]) => x), y: rows.map(([, , y]) => y),
        predictions: Object.fromEntries(predictors.map((one, i) => [one, predictions[i]])),
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
