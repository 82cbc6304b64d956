// The end of a circle run: statistics, scores of every predictor, and the recording to save.

import { recording } from "./recording.js";
import { statistics } from "./statistics.js";
import { fill, number, part, percent } from "../page/elements.js";
import { Results } from "../results/results.js";

const results = new Results("circle");
let addresses = [];

function tiles(found) {
  const told = [
    ["Throughput", number(found.throughput, 2, "bits/s"), found.throughput],
    ["Movement time", number(found.movementTime, 3, "s"), found.movementTime],
    ["Effective width", number(found.effectiveWidth, 1, "px"), found.effectiveWidth],
    ["Effective distance", number(found.effectiveDistance, 1, "px"), found.effectiveDistance],
    ["Errors", percent(found.errorRate, 1), found.errorRate],
    ["Movements", String(found.trials), found.trials],
  ];
  part("circle-tiles").replaceChildren(...told.map(([name, value, exact]) => {
    const tile = document.createElement("div");
    const [term, said] = [document.createElement("dt"), document.createElement("dd")];
    term.textContent = name;
    said.textContent = value;
    said.dataset.exact = String(exact);
    tile.append(term, said);
    return tile;
  }));
}

function blocks(found) {
  const heads = ["block", "movements", "errors", "time, s", "effective width, px", "effective distance, px", "throughput, bits/s"];
  fill(part("circle-blocks"), [heads, ...found.blocks.map((one) => [
    String(one.block), String(one.trials), percent(one.errorRate, 1), number(one.movementTime, 3),
    number(one.effectiveWidth, 1), number(one.effectiveDistance, 1), number(one.throughput, 2),
  ])]);
}

function offerFiles({ samples, trials }) {
  addresses.forEach((address) => URL.revokeObjectURL(address));
  addresses = [["circle-samples", samples], ["circle-trials", trials]].map(([id, { name, text }]) => {
    const link = part(id);
    link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
    link.download = name;
    return link.href;
  });
}

/** The files' name: when the run ended, by the person's own clock. */
function named(when) {
  const two = (value) => String(value).padStart(2, "0");
  const day = [when.getFullYear(), two(when.getMonth() + 1), two(when.getDate())].join("-");
  return `circle-${day}-${two(when.getHours())}${two(when.getMinutes())}${two(when.getSeconds())}`;
}

/**
 * Shows a run, then its scores once the service has them.
 * @param {import("./task.js").Trial[]} trials @param {string[]} names of the predictors that will be scored
 */
export function showResult(trials, names) {
  const found = statistics(trials);
  const files = recording(trials, named(new Date()));
  tiles(found);
  blocks(found);
  offerFiles(files);
  const result = part("circle-result");
  result.hidden = false;
  part("circle-result-title").focus({ preventScroll: true });
  result.scrollIntoView();
  part("circle-again").onclick = () => showScores(files.samples.text, names);
  showScores(files.samples.text, names);
}

async function showScores(csv, names) {
  const [result, again] = ["circle-result", "circle-again"].map(part);
  result.dataset.state = "scoring";
  again.disabled = true;
  const state = await results.score(csv, names, " You can still save the recording.");
  if (state === "late") return;
  again.disabled = state === "done";
  result.dataset.state = state;
}
