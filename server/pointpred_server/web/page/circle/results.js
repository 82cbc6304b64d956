// The result of a circle run: its statistics, and the recording to save.

import { fillTable, part } from "../shell/elements.js";
import { number, percent } from "../shell/numbers.js";
import { recording } from "./recording.js";
import { statistics } from "./statistics.js";

let addresses = [];

function showTiles(run) {
  const tiles = [
    ["Throughput", number(run.throughput, 2, "bits/s"), run.throughput],
    ["Movement time", number(run.movementTime, 3, "s"), run.movementTime],
    ["Effective width", number(run.effectiveWidth, 1, "px"), run.effectiveWidth],
    ["Effective distance", number(run.effectiveDistance, 1, "px"), run.effectiveDistance],
    ["Errors", percent(run.errorRate, 1), run.errorRate],
    ["Movements", String(run.trials), run.trials],
  ];
  part("circle-tiles").replaceChildren(
    ...tiles.map(([name, text, value]) => {
      const tile = document.createElement("div");
      const [term, description] = [document.createElement("dt"), document.createElement("dd")];
      term.textContent = name;
      description.textContent = text;
      description.dataset.exact = String(value);
      tile.append(term, description);
      return tile;
    }),
  );
}

function showBlocks(run) {
  const heads = [
    "block",
    "movements",
    "errors",
    "time, s",
    "effective width, px",
    "effective distance, px",
    "throughput, bits/s",
  ];
  fillTable(/** @type {HTMLTableElement} */ (part("circle-blocks")), [
    heads,
    ...run.blocks.map((block) => [
      String(block.block),
      String(block.trials),
      percent(block.errorRate, 1),
      number(block.movementTime, 3),
      number(block.effectiveWidth, 1),
      number(block.effectiveDistance, 1),
      number(block.throughput, 2),
    ]),
  ]);
}

function linkFiles({ samples, trials }) {
  addresses.forEach((address) => URL.revokeObjectURL(address));
  addresses = [
    ["circle-samples", samples],
    ["circle-trials", trials],
  ].map(([id, { name, text }]) => {
    const link = /** @type {HTMLAnchorElement} */ (part(id));
    link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
    link.download = name;
    return link.href;
  });
}

/** The name of the files: the local time when the run ended. */
function nameAt(time) {
  const two = (value) => String(value).padStart(2, "0");
  const day = [time.getFullYear(), two(time.getMonth() + 1), two(time.getDate())].join("-");
  return `circle-${day}-${two(time.getHours())}${two(time.getMinutes())}${two(time.getSeconds())}`;
}

/** Shows the statistics of a run, and the recording to save. @param {import("../study/task.js").Trial[]} trials @param {string} user who moved */
export function showResult(trials, user) {
  const run = statistics(trials);
  showTiles(run);
  showBlocks(run);
  linkFiles(recording(trials, nameAt(new Date()), user));
  const result = part("circle-result");
  result.hidden = false;
  part("circle-result-title").focus({ preventScroll: true });
  result.scrollIntoView();
}
