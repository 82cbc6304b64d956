// Where replayed movements come from: the embedded sample, or a recording that was opened.

import { count } from "../page/elements.js";
import { isOwn, readFiles } from "./file.js";
import { predictionsAlong } from "./stream.js";
import { read, recording } from "../service/http.js";

/**
 * @typedef {{title: string, said: string, csv: string|Blob|null, told?: object,
 *   movement: (at: number, predictors: string[]) => Promise<object>, names: string[]}} Source
 */

/** Columns of a region's numbers as one region, or null, for each event. */
const regionsAlong = (count, region) => Array.from({ length: count }, (_, i) => {
  if (region === null || region.sxx[i] === null) return null;
  return { sxx: region.sxx[i], sxy: region.sxy[i], syy: region.syy[i], tail: region.tail[i] };
});

/** The embedded sample: the service computes the predictions from its own copy. @returns {Promise<Source>} */
export async function embedded() {
  const { samples } = await read("/v1/samples");
  return {
    title: "the embedded sample",
    said: "The people in this sample are simulated: no recording of a person is shipped. Each prediction uses only the events before it.",
    csv: null,
    names: samples.map(({ name, events }) => `${name} (${events} events)`),
    async movement(at, predictors) {
      const asked = encodeURIComponent(predictors.join(","));
      const found = await read(`/v1/samples/${encodeURIComponent(samples[at].name)}?predictors=${asked}`);
      const columns = Object.entries(found.predictions).map(([name, { x, y, region }]) => [name, { x, y, regions: regionsAlong(x.length, region) }]);
      return { ...found, who: `simulated person ${found.user}`, predictions: Object.fromEntries(columns) };
    },
  };
}

/**
 * A recording opened in this page; each movement's events go to the service when it is shown. Files that are not pointpred's own
 * CSV are read by the service.
 * @param {File[]} files @param {object} told what is said of the columns @returns {Promise<Source>}
 */
export async function opened(files, told = {}) {
  const foreign = files.length === 1 && !(await isOwn(files[0]));
  const { name, csv, left, reason, movements, simulated, notes = [], ...resolution } = await (foreign ? served(files[0], told) : readFiles(files));
  return {
    title: name,
    said: [`${name}: ${count(movements.length, "movement")}${left ? `, ${left} more cannot be shown (${reason})` : ""}. It is sent to this service only.`, ...notes].join(" \u00b7 "),
    csv,
    told,
    names: movements.map(({ user, name: trial, rows }) => `${user} ${trial} (${rows.length} events)`),
    async movement(at, predictors) {
      const { user, name: trial, target, rows } = movements[at];
      const columns = await Promise.all(predictors.map((one) => predictionsAlong(rows, one, resolution)));
      return {
        name: trial, user, target, who: `${simulated ? "simulated person" : "person"} ${user}`,
        t: rows.map(([t]) => t - rows[0][0]), x: rows.map(([, x]) => x), y: rows.map(([, , y]) => y),
        predictions: Object.fromEntries(predictors.map((one, i) => [one, columns[i]])),
      };
    },
  };
}

/** A file of any format as the service reads it. */
async function served(file, told) {
  const { dpi, cpi, simulated, movements, skipped, notes } = await recording(file, told).catch((error) => {
    error.message = error.message.replace("the recording", file.name); // the service does not know its name
    throw error;
  });
  if (movements.length === 0) throw new Error(`${file.name}: no movement can be used; ${skipped[0]?.reason ?? "it holds none"}`);
  return { name: file.name, csv: file, left: skipped.length, reason: skipped[0]?.reason ?? "", movements, simulated, notes, dpi, cpi };
}
