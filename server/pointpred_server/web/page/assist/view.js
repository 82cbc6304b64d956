// The assist view: the page captures the mouse, and the session moves a cursor by its counts, assisted or not.

import { clearCanvas, colours, FrameLoop, onRepaint } from "../drawing/canvas.js";
import { disc, segment } from "../drawing/marks.js";
import { predictors } from "../service/listing.js";
import { ConnectionStatus, PredictorConnection } from "../service/predictor-connection.js";
import { inPage } from "../service/service.js";
import { fillSelect, fillTable, part, write } from "../shell/elements.js";
import { COUNTS, isSupported, PointerLock } from "./pointer-lock.js";
import { Task } from "./task.js";

const ASSISTING_MS = 60;
const SHOWN_MS = 500; // a prediction is drawn for this long
const ARM_PX = 9; // of the cursor
const NUMBERS = { cpi: "Counts per inch", gain: "Gain" };

/**
 * @typedef {{cpi: number, gain: number, strength: number, alternate: boolean}} Settings `strength`: 0 to 1; `alternate`: half of the
 *   targets are not assisted
 * @typedef {HTMLFormElement & {elements: Record<keyof Settings, HTMLInputElement>}} AssistForm
 */

const canvas = /** @type {HTMLCanvasElement} */ (part("assist-scene")),
  form = /** @type {AssistForm} */ (part("assist-form")),
  select = /** @type {HTMLSelectElement} */ (part("assist-predictor")),
  captureButton = /** @type {HTMLButtonElement} */ (part("assist-capture")),
  results = /** @type {HTMLTableElement} */ (part("assist-results"));
const [message, invitation] = ["status", "invitation"].map((of) => part(`assist-${of}`));
const status = new ConnectionStatus(part("assist-connection"));
const lock = new PointerLock(canvas, { onMove: move, onPress: press, onLock: begin, onRelease: end });
const loop = new FrameLoop(draw);

let task = new Task();
/** @type {PredictorConnection|null} */ let connection = null; // exists while the mouse is captured
/** @type {[number, number]|null} */ let cursor = null;
let addedPx = 0;
let assistedAt = -Infinity;
let counts = "unknown";
/** @type {Settings|null} */ let settings = null; // of the form when its numbers were last valid
let releaseText = ""; // why the mouse is released, if the person has not released it

/** @param {string} text @param {"invalid"|"captured"|"refused"|"released"|"unsupported"} state */
function showMessage(text, state) {
  write(message, text);
  message.dataset.state = state;
}

/** The settings of the form; shows why and returns null if a number is not valid. @returns {Settings|null} */
function readSettings() {
  for (const [name, label] of Object.entries(NUMBERS)) {
    const { valueAsNumber: value, min, max } = form.elements[name];
    const valid = value >= Number(min) && value <= Number(max);
    form.elements[name].setAttribute("aria-invalid", String(!valid));
    if (!valid) {
      showMessage(`${label} must be a number from ${min} to ${max}.`, "invalid");
      return null;
    }
  }
  return {
    cpi: form.elements.cpi.valueAsNumber,
    gain: form.elements.gain.valueAsNumber,
    strength: form.elements.strength.valueAsNumber / 100,
    alternate: form.elements.alternate.checked,
  };
}

async function capture(event) {
  event.preventDefault();
  settings = readSettings();
  if (settings === null || lock.active) return;
  releaseText = "";
  try {
    counts = await lock.lock();
    canvas.dataset.counts = counts;
    if (lock.active) showTask();
  } catch (error) {
    showMessage(
      `The browser did not let this page capture the mouse: ${/** @type {Error} */ (error).message}`,
      "refused",
    );
  }
}

/** The mouse is captured: starts a session with the cursor in the middle of the field, and the first target. */
function begin() {
  const { cpi, gain, strength } = /** @type {Settings} */ (settings);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  const [x, y] = cursor ?? [Math.round(width / 2), Math.round(height / 2)];
  cursor = [Math.min(x, width - 1), Math.min(y, height - 1)];
  addedPx = 0;
  connection = new PredictorConnection(
    select.value,
    { state: onState, cursor: moveCursor, error: (error) => !error.recoverable && release(error.message) },
    { assist: { strength, gain }, device: { cpi }, screen: { width_px: width, height_px: height, dpi: 96 } },
  );
  setNextTarget(connection, cursor);
  showTask();
  loop.start();
}

/** @param {PredictorConnection} assisting @param {[number, number]} from */
function setNextTarget(assisting, from) {
  settings = readSettings() ?? settings; // the keyboard can still change them
  const { gain, strength, alternate } = /** @type {Settings} */ (settings);
  task.next(from, [canvas.clientWidth, canvas.clientHeight], !alternate);
  assisting.setAssistance({ strength: task.assisted ? strength : 0, gain });
}

function showTask() {
  invitation.classList.toggle("away", lock.active);
  if (lock.active)
    showMessage(
      `Click the filled target, and each one after it. ${COUNTS[counts]} Escape releases the mouse.`,
      "captured",
    );
  fillTable(results, task.table);
}

/** @param {import("./pointer-lock.js").Counts[]} samples */
function move(samples) {
  if (connection === null || cursor === null) return;
  for (const { t, dx, dy } of samples) if (dx || dy) task.move(t);
  const [x, y] = cursor;
  connection.send(samples.map(({ t, dx, dy, buttons }) => [t, x, y, dx, dy, buttons]));
}

/** @param {number} t */
function press(t) {
  if (connection !== null && cursor !== null && task.press(cursor, t)) setNextTarget(connection, cursor);
  showTask();
}

function moveCursor({ x, y, added_px: added }) {
  cursor = [x, y];
  if (added > addedPx) assistedAt = performance.now();
  addedPx = added;
}

function draw() {
  const { active } = lock,
    now = performance.now(),
    { target } = task;
  const latest = active && connection !== null && now - connection.at < SHOWN_MS ? connection.latest : null;
  const { pen } = clearCanvas(canvas),
    { target: targetColour, endpoint, text, quiet, past } = colours();
  if (active) disc(pen, [target.x, target.y], target.width / 2, targetColour, true);
  if (latest !== null && latest.x !== null && latest.y !== null) disc(pen, [latest.x, latest.y], 9, endpoint);
  if (cursor !== null) {
    const [x, y] = cursor,
      colour = active ? text : quiet;
    segment(pen, [x - ARM_PX, y], [x + ARM_PX, y], colour, 2);
    segment(pen, [x, y - ARM_PX], [x, y + ARM_PX], colour, 2);
    if (active && now - assistedAt < ASSISTING_MS) disc(pen, cursor, ARM_PX + 3, past, false, 2);
  }
  Object.assign(canvas.dataset, {
    captured: active,
    x: cursor?.[0] ?? "",
    y: cursor?.[1] ?? "",
    added: addedPx,
    assisted: task.assisted,
    target: [target.x, target.y].join(),
  });
}

function onState(state) {
  status.show(state, { error: connection?.error });
  if (state === "waiting" || state === "refused")
    release(inPage() ? "the predictor could not be loaded" : "the service does not answer");
}

/** Releases the mouse: without a session its cursor does not move. */
function release(reason) {
  releaseText = `The mouse was released: ${reason}.`;
  lock.release();
}

function end() {
  loop.stop();
  connection?.close();
  connection = null;
  showTask();
  showMessage(
    releaseText ||
      `The mouse was released. ${task.done.length ? "Capture it again to go on; the table is kept." : "No target was clicked."}`,
    "released",
  );
  draw();
}

/** Offers the predictors; the page connects when it captures the mouse. */
export async function open() {
  fillTable(results, task.table);
  draw();
  if (!isSupported()) {
    showMessage(
      "This browser cannot capture the mouse (it has no pointer lock), so this view does not work in it.",
      "unsupported",
    );
    return;
  }
  const listing = await predictors();
  if (select.disabled) fillSelect(select, listing.predictors, listing.recommended);
  captureButton.disabled = false;
}

/** Releases the mouse. */
export function close() {
  lock.release();
}

form.addEventListener("submit", capture);
form.elements.strength.addEventListener("input", () => {
  const percent = form.elements.strength.valueAsNumber;
  write(part("assist-strength"), percent ? `up to ${percent} % faster` : "none");
});
part("assist-clear").addEventListener("click", () => {
  task = new Task();
  fillTable(results, task.table);
});
onRepaint(draw);
