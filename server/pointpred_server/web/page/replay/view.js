// The replay view: a recorded movement with a slider over its time, and what was predicted along it.

import { clearCanvas, onRepaint } from "../drawing/canvas.js";
import { drawLegends } from "../drawing/legend.js";
import { predictors } from "../service/listing.js";
import { hasService, inPage } from "../service/service.js";
import { fillSelect, part, sentence, write } from "../shell/elements.js";
import { number } from "../shell/numbers.js";
import { acceptFiles } from "./drop.js";
import { drawErrors } from "./errors.js";
import { drawMovement, errorAt } from "./picture.js";
import { Player } from "./player.js";
import { fileSource, sampleSource } from "./source.js";

/**
 * @typedef {import("./picture.js").Movement} Movement
 * @typedef {import("./picture.js").Column} Column
 * @typedef {import("./source.js").Source} Source
 */

const [scene, errors] = /** @type {HTMLCanvasElement[]} */ (["scene", "errors"].map((id) => part(`replay-${id}`)));
const [previousButton, nextButton, sampleButton, retryButton, playButton] = /** @type {HTMLButtonElement[]} */ (
  ["previous", "next", "sample", "retry", "play"].map((id) => part(`replay-${id}`))
);
const [readout, status] = ["readout", "source"].map((id) => part(`replay-${id}`));
const [fileInput, slider] = /** @type {HTMLInputElement[]} */ (["file", "time"].map((id) => part(`replay-${id}`)));
const [list, ...selects] = /** @type {HTMLSelectElement[]} */ (
  ["trials", "predictor-0", "predictor-1"].map((id) => part(`replay-${id}`))
);
const player = new Player(playButton, slider, draw);

/** @type {Source|null} */ let source = null;
/** @type {Movement|null} */ let movement = null;
let index = 0;
/** @type {boolean|null} */ let predictedInPage = null; // whether the movement was predicted in the page
let movementRequest = 0; // the newest one: answers to older requests are ignored
let sourceRequest = 0;

/** @param {Movement} shown @returns {(Column|null)[]} */
const columnsOf = (shown) => selects.map(({ value }) => shown.predictions[value] ?? null);

const chosenPredictors = () => [...new Set(selects.map(({ value }) => value).filter(Boolean))];

/** Writes the line about the source. @param {"reading"|"open"|"failed"} state */
function showStatus(text, state) {
  write(status, text);
  status.dataset.state = state;
}

/** Shows a movement at a time in ms; by default when half of the distance is done. @param {number} which @param {number|null} [ms] */
async function show(which, ms = null) {
  const from = /** @type {Source} */ (source),
    request = ++movementRequest;
  player.stop();
  retryButton.hidden = true;
  index = (which + from.names.length) % from.names.length;
  list.selectedIndex = index;
  write(readout, "Computing the predictions…");
  const result = await load(from, index);
  if (request === movementRequest) showResult(result, ms);
}

/** A movement of a source with its predictions, or the error instead. @param {Source} from @param {number} which */
const load = (from, which) => from.movement(which, chosenPredictors()).catch((error) => error);

/** @param {Movement|Error} result @param {number|null} [ms] */
function showResult(result, ms = null) {
  if (result instanceof Error) clear(`Movement ${index + 1} cannot be shown: ${result.message}.`);
  else {
    [movement, predictedInPage] = [result, inPage()];
    player.load(1000 * result.t[result.t.length - 1], ms ?? 1000 * result.t[halfway(result)]);
  }
  retryButton.hidden = movement !== null;
  player.enable(movement !== null);
}

/** Shows no movement, and the reason. */
function clear(text) {
  movement = null;
  write(readout, text);
  for (const canvas of [scene, errors]) clearCanvas(canvas);
}

/** How far the cursor is from where the movement ended, px. @param {Movement} shown @param {number} event */
const distanceAt = (shown, event) => /** @type {number} */ (errorAt(shown, shown, event));

/** The event at half of the distance. @param {Movement} shown */
function halfway(shown) {
  const distances = shown.t.map((_, i) => distanceAt(shown, i));
  return Math.max(
    0,
    distances.findIndex((px) => px < distances[0] / 2),
  );
}

/** The last event at or before the time of the slider. @param {Movement} shown */
function currentEvent({ t: times }) {
  const after = times.findIndex((t) => 1000 * t > player.ms);
  return after < 0 ? times.length - 1 : Math.max(0, after - 1);
}

function draw() {
  if (movement === null || scene.clientWidth === 0) return;
  const event = currentEvent(movement),
    predictions = columnsOf(movement);
  drawMovement(scene, movement, predictions, event);
  drawErrors(errors, movement, predictions, Math.min(player.ms / 1000, movement.t[movement.t.length - 1]));
  scene.dataset.event = String(event);
  if (!player.playing) write(readout, readoutAt(movement, event, predictions));
}

/** @param {Movement} shown @param {number} event @param {(Column|null)[]} predictions */
function readoutAt(shown, event, predictions) {
  const distance = distanceAt(shown, event).toFixed(0);
  const parts = predictions.flatMap((column, which) => {
    if (column === null) return [];
    const error = errorAt(shown, column, event);
    return [`${selects[which].value} ${error === null ? "makes no prediction" : `is ${number(error)} px off`}`];
  });
  return `${shown.t[event].toFixed(2)} s: ${parts.join(", ")}, the cursor is ${distance} px from where it ended. Movement ${index + 1} of ${list.options.length}, ${shown.person}.`;
}

/**
 * Changes to another source of movements, unless a newer one has been requested meanwhile. The former one stays until the
 * first movement of the new source is there or has failed. @param {Promise<Source>} promise @returns {Promise<boolean>} whether it has changed
 */
async function changeSource(promise) {
  const request = ++sourceRequest;
  let opened, first;
  try {
    opened = await promise;
    first = await load(opened, 0);
  } catch (error) {
    if (request !== sourceRequest) return false;
    throw error;
  }
  if (request !== sourceRequest) return false;
  movementRequest += 1;
  player.stop();
  [source, index] = [opened, 0];
  list.replaceChildren(...opened.names.map((name, i) => new Option(name, String(i))));
  list.selectedIndex = 0;
  showStatus(opened.description, "open");
  sampleButton.disabled = opened.isSample;
  for (const control of [previousButton, nextButton, list]) control.disabled = false;
  showResult(first);
  if (!(first instanceof Error) && chosenPredictors().some((name) => !(name in first.predictions))) await show(0); // another was chosen meanwhile
  return true;
}

/** @param {File[]} files */
async function openRecording(files) {
  if (!files.length) return;
  showStatus("Reading…", "reading");
  try {
    await changeSource(fileSource(files));
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    showStatus(`Not opened: ${message}.${source === null ? "" : ` Still open: ${source.title}.`}`, "failed");
  }
}

async function openSample() {
  try {
    await changeSource(sampleSource());
  } catch (error) {
    showStatus(
      `The sample cannot be shown: ${sentence(/** @type {Error} */ (error).message)}${hasService ? " Is the service still running?" : ""}`,
      "failed",
    );
  }
}

/** Shows the embedded sample unless something else is open. */
export async function open() {
  const listing = await predictors();
  if (selects[0].options.length === 0) {
    fillSelect(selects[0], listing.predictors, listing.recommended);
    fillSelect(selects[1], listing.predictors, "", "none");
  }
  drawLegends();
  if (source === null) await changeSource(sampleSource());
  else if (movement === null || predictedInPage !== inPage()) await show(index, movement && player.ms);
  draw();
}

/** Pauses the replay. */
export function close() {
  player.stop();
}

previousButton.addEventListener("click", () => show(index - 1));
nextButton.addEventListener("click", () => show(index + 1));
list.addEventListener("change", () => show(list.selectedIndex));
for (const select of selects) select.addEventListener("change", () => source && show(index, player.ms));
fileInput.addEventListener("click", () => (fileInput.value = "")); // so that the same file can be opened again
fileInput.addEventListener("change", () => openRecording([...(fileInput.files ?? [])]));
sampleButton.addEventListener("click", openSample);
retryButton.addEventListener("click", () => show(index));
acceptFiles(part("replay-drop"), (files) => openRecording(files));
onRepaint(draw);
