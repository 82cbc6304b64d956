// The replay view: a recorded movement with a slider over its time, and what was predicted along it.

import { clearCanvas, onRepaint } from "../drawing/canvas.js";
import { drawLegends } from "../drawing/legend.js";
import { predictors } from "../service/listing.js";
import { hasService, inPage } from "../service/place.js";
import { fillSelect, part, sentence, write } from "../shell/elements.js";
import { number } from "../shell/numbers.js";
import { acceptFiles } from "./drop.js";
import { drawErrors } from "./errors.js";
import { drawMovement, errorAt } from "./picture.js";
import { Player } from "./player.js";
import { fileSource, sampleSource } from "./source.js";

const [scene, errors, previousButton, nextButton] = ["scene", "errors", "previous", "next"].map((id) =>
  part(`replay-${id}`),
);
const [list, readout, status, fileInput, sampleButton, retryButton] = [
  "trials",
  "readout",
  "source",
  "file",
  "sample",
  "retry",
].map((id) => part(`replay-${id}`));
const selects = [0, 1].map((which) => part(`replay-predictor-${which}`));
const player = new Player(part("replay-play"), part("replay-time"), draw);

let source = null;
let movement = null;
let index = 0;
let predictedInPage = null; // whether the movement was predicted in the page
let movementRequest = 0; // the newest one: answers to older requests are ignored
let sourceRequest = 0;

const columns = () => selects.map(({ value }) => movement.predictions[value] ?? null);

const chosenPredictors = () => [...new Set(selects.map(({ value }) => value).filter(Boolean))];

/** Writes the line about the source. @param {"reading"|"open"|"failed"} state @param {string} code of the error */
function showStatus(text, state, code = "") {
  write(status, text);
  Object.assign(status.dataset, { state, code });
}

/** Shows a movement at a time in ms; by default when half of the distance is done. */
async function show(which, ms = null) {
  const request = ++movementRequest;
  player.stop();
  retryButton.hidden = true;
  index = (which + source.names.length) % source.names.length;
  list.selectedIndex = index;
  write(readout, "Computing the predictions…");
  const result = await load(source, index);
  if (request === movementRequest) showResult(result, ms);
}

/** A movement of a source with its predictions, or the error instead. */
const load = (from, which) => from.movement(which, chosenPredictors()).catch((error) => error);

function showResult(result, ms = null) {
  if (result instanceof Error) clear(`Movement ${index + 1} cannot be shown: ${result.message}.`);
  else {
    [movement, predictedInPage] = [result, inPage()];
    player.load(1000 * movement.t[movement.t.length - 1], ms ?? 1000 * movement.t[halfway()]);
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

/** The event at half of the distance. */
function halfway() {
  const distances = movement.t.map((_, i) => errorAt(movement, movement, i));
  return Math.max(
    0,
    distances.findIndex((px) => px < distances[0] / 2),
  );
}

/** The last event at or before the time of the slider. */
function currentEvent() {
  const after = movement.t.findIndex((t) => 1000 * t > player.ms);
  return after < 0 ? movement.t.length - 1 : Math.max(0, after - 1);
}

function draw() {
  if (movement === null || scene.clientWidth === 0) return;
  const event = currentEvent(),
    predictions = columns();
  drawMovement(scene, movement, predictions, event);
  drawErrors(errors, movement, predictions, Math.min(player.ms / 1000, movement.t[movement.t.length - 1]));
  scene.dataset.event = String(event);
  if (!player.playing) write(readout, readoutAt(event, predictions));
}

function readoutAt(event, predictions) {
  const distance = errorAt(movement, movement, event).toFixed(0);
  const parts = predictions.flatMap((column, which) => {
    if (column === null) return [];
    const error = errorAt(movement, column, event);
    return [`${selects[which].value} ${error === null ? "makes no prediction" : `is ${number(error)} px off`}`];
  });
  return `${movement.t[event].toFixed(2)} s: ${parts.join(", ")}, the cursor is ${distance} px from where it ended. Movement ${index + 1} of ${source.names.length}, ${movement.person}.`;
}

/**
 * Changes to another source of movements, unless a newer one has been requested meanwhile. The former one stays until the
 * first movement of the new source is there or has failed. @returns {Promise<boolean>} whether it has changed
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
  list.replaceChildren(...source.names.map((name, i) => new Option(name, String(i))));
  list.selectedIndex = 0;
  showStatus(source.description, "open");
  sampleButton.disabled = source.isSample;
  for (const control of [previousButton, nextButton, list]) control.disabled = false;
  showResult(first);
  if (movement !== null && chosenPredictors().some((name) => !(name in movement.predictions))) await show(0); // another was chosen meanwhile
  return true;
}

async function openRecording(files) {
  if (!files.length) return;
  showStatus("Reading…", "reading");
  try {
    await changeSource(fileSource(files));
  } catch (error) {
    showStatus(
      `Not opened: ${error.message}.${source === null ? "" : ` Still open: ${source.title}.`}`,
      "failed",
      error.code,
    );
  }
}

async function openSample() {
  try {
    await changeSource(sampleSource());
  } catch (error) {
    showStatus(
      `The sample cannot be shown: ${sentence(error.message)}${hasService ? " Is the service still running?" : ""}`,
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
fileInput.addEventListener("change", () => openRecording([...fileInput.files]));
sampleButton.addEventListener("click", openSample);
retryButton.addEventListener("click", () => show(index));
acceptFiles(part("replay-drop"), (files) => openRecording(files));
onRepaint(draw);
