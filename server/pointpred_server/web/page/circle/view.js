// The circle view: the settings, the run, and a row for each movement as it is scored.

import { FrameLoop, onRepaint } from "../drawing/canvas.js";
import { predictors } from "../service/listing.js";
import { ConnectionStatus, PredictorConnection } from "../service/predictor-connection.js";
import { inPage } from "../service/service.js";
import { Account } from "../shell/account.js";
import { fillSelect, part, write } from "../shell/elements.js";
import { count } from "../shell/numbers.js";
import { listenToPointer } from "../shell/pointer.js";
import { drawTask } from "../study/picture.js";
import { PointingTask } from "../study/task.js";
import { CircleChoices } from "./choices.js";
import { showResult } from "./results.js";
import { CircleRows } from "./rows.js";
import { fitDistance, fitsPicture, overlapWarning, readSettings, sequencesOf } from "./settings.js";

const SHOWN_MS = 500; // a prediction is drawn for this long
const MOST_SHOWN = 20_000; // predictions of a movement that are compared with its end
const READY = ["open", "idle"]; // states of a connection in which a run can start: the next event opens an idle one
const DOWN = "Start is disabled: the service does not answer. Is it still running? The page tries again by itself.";
const UNLOADED = "Start is disabled: the predictor could not be loaded. The page tries again by itself.";
const CANCELLED = {
  view: "The run was cancelled because another view was opened.",
  place: "The run was cancelled because you changed where predictions are made.",
};

/** @typedef {"ready"|"invalid"|"waiting"|"running"|"done"|"stopped"|"cancelled"} RunState */

const canvas = /** @type {HTMLCanvasElement} */ (part("circle-scene"));
const form = /** @type {import("./settings.js").CircleForm} */ (part("circle-form"));
const [startButton, stopButton] = /** @type {HTMLButtonElement[]} */ (["circle-start", "circle-stop"].map(part));
const progress = /** @type {HTMLProgressElement} */ (part("circle-progress"));
const [runStatus, ledgerLine] = ["circle-status", "circle-ledger"].map(part);
const status = new ConnectionStatus(part("circle-connection"));
const rows = new CircleRows(/** @type {HTMLTableSectionElement} */ (part("circle-rows")));
const choices = new CircleChoices();
const loop = new FrameLoop(frame);

let active = false;
let filled = false; // whether the predictors are offered
/** @type {{text: string, state: RunState}} */ let run = { text: runStatus.textContent, state: "ready" }; // what is shown of the run
let edited = false; // whether the person has set the distance
let started = false; // whether the session knows where the current movement began
/** @type {PredictorConnection|null} */ let connection = null;
let account = new Account();
/** @type {PointingTask|null} */ let task = null;
/** @type {import("../../lib/index.d.ts").Prediction[]} */ let shown = []; // during the current movement
let participant = "";

const isRunning = () => task !== null && !task.done;

/** @param {import("../study/task.js").Row[]} events */
function move(events) {
  if (task === null || task.done) return;
  task.move(events);
  connection?.send(events);
}

/** The target to click, as a session takes it. @param {PointingTask} task */
const goalOf = ({ goal: { x, y, width } }) => ({ x, y, width });

/** @param {PointingTask} shown */
function showTarget(shown) {
  const { done, running } = shown;
  canvas.dataset.target = JSON.stringify(done ? null : { ...goalOf(shown), running });
}

/** A press selects a target; a finger selects by lifting, because it has no path before it touches. @param {import("../study/task.js").Row} row */
function select(row) {
  if (task === null || task.done) return;
  const trial = task.select(row);
  if (trial !== null) {
    if (started) connection?.trial("end", { x: trial.target[0], y: trial.target[1], width: trial.sequence.width });
    rows.add(trial, shown);
  }
  shown = [];
  started = task.running && connection?.state === "open";
  if (started) connection?.trial("start", goalOf(task));
  showTarget(task);
  showProgress(task);
  if (task.done) finish(task);
}

/**
 * Shows how the run stands; between runs, that nothing can be predicted if so.
 * @param {string} [text] @param {RunState} [state]
 */
function showRunStatus(text = run.text, state = run.state) {
  run = { text, state };
  const down = !isRunning() && ["waiting", "refused"].includes(status.state);
  write(runStatus, !down ? text : inPage() ? UNLOADED : DOWN);
  runStatus.dataset.state = down ? "down" : state;
}

/** @param {PointingTask} shown */
function showProgress({ sequence: { block }, sequences, done, running, total, trials }) {
  const misses = trials.filter(({ hit }) => !hit).length;
  progress.max = total;
  progress.value = trials.length;
  const counts = `${trials.length} of ${total} movements, ${misses} missed`;
  if (done) showRunStatus(`Done: ${counts}. The result is below.`, "done");
  else if (!running)
    showRunStatus(`Block ${block} of ${sequences.length}: click the filled target to begin. ${counts}.`, "waiting");
  else showRunStatus(`Block ${block} of ${sequences.length}: ${counts}.`, "running");
}

function onState(state) {
  status.show(state, { error: connection?.error });
  startButton.disabled = !READY.includes(state);
  showRunStatus();
  if (state === "open") return;
  started = false; // a new session does not know the movement
  choices.clear();
}

function onScore(score) {
  const { fired, wasted, lead_s } = score;
  if (fired != null) account.add({ proposed: fired, wasted, lead_entry_s: lead_s });
  write(ledgerLine, account.text);
}

/** @param {string} predictor */
function connectWith(predictor) {
  if (connection?.predictor === predictor && connection.state !== "closed") return;
  connection?.close();
  connection = null;
  connection = new PredictorConnection(
    predictor,
    {
      state: onState,
      score: onScore,
      prediction: (prediction) => {
        if (task?.running && shown.length < MOST_SHOWN) shown.push(prediction);
        choices.addPrediction(prediction);
      },
      choice: (choice) => choices.addChoice(choice),
    },
    { encoding: "json" },
  ); // packed predictions have no probabilities of targets
}

function start() {
  const { settings, problem, field } = readSettings(form, canvas);
  if (problem) {
    showRunStatus(problem, "invalid");
    field?.focus();
    return;
  }
  task = new PointingTask(sequencesOf(settings), settings.centre);
  participant = settings.participant;
  rows.clear();
  account = new Account();
  write(ledgerLine, "");
  connectWith(form.elements.predictor.value);
  if (connection !== null) choices.register(connection, task.places, settings.width);
  setRunning(true);
  started = false;
  canvas.parentElement?.scrollIntoView({ block: "nearest" });
  showTarget(task);
  showProgress(task);
}

function setRunning(running) {
  if (!running) choices.clear();
  startButton.textContent = running ? "Start again" : "Start";
  stopButton.disabled = !running;
  part("circle-invitation").classList.toggle("away", running);
  for (const field of /** @type {Iterable<HTMLInputElement>} */ (form.elements))
    if (!["circle-start", "circle-stop"].includes(field.id) && field.name !== "shown") field.disabled = running;
}

/** Ends the run early. @param {string} reason a sentence to add */
function stop(reason = "") {
  if (task === null || task.done) return;
  const { trials } = task;
  task = null;
  setRunning(false);
  showRunStatus(
    (trials.length ? `Stopped after ${count(trials.length, "movement")}.` : "Stopped.") + reason,
    "stopped",
  );
  if (trials.length > 1) showResult(trials, participant);
}

/** @param {PointingTask} ended */
function finish({ trials }) {
  setRunning(false);
  showResult(trials, participant);
}

function frame() {
  const { settings, problem } = readSettings(form, canvas);
  const scene = task ?? new PointingTask(sequencesOf({ ...settings, blocks: 1 }), settings.centre);
  const running = task !== null && !task.done,
    showsPrediction = running && form.elements.shown.checked;
  write(part("circle-warning"), problem || running ? "" : overlapWarning(settings));
  const recent = connection !== null && performance.now() - connection.at < SHOWN_MS ? connection.latest : null;
  drawTask(canvas, {
    places: scene.places,
    width: scene.sequence.width,
    current: task !== null && running ? task.current : null,
    last: task?.trials[task.trials.length - 1] ?? null,
    prediction: showsPrediction ? recent : null,
    probabilities: showsPrediction ? choices.probabilities : [],
    proposed: choices.proposed,
  });
}

/** The window has another size: a run whose circle no longer fits is stopped. */
function onResize() {
  if (!active) return;
  if (task === null || task.done) updateDistance();
  else if (!fitsPicture(task, canvas)) stop(" The window has become too small for this circle.");
}

/** Fits the distance to the window unless the person has set it. */
function updateDistance() {
  if (!edited) fitDistance(form, canvas);
}

/** Connects and draws from now on. */
export async function open() {
  active = true;
  updateDistance();
  loop.start();
  const listing = await predictors();
  if (!filled) fillSelect(form.elements.predictor, listing.predictors, listing.recommended);
  filled = true;
  showRunStatus();
  if (active) connectWith(form.elements.predictor.value);
}

/** Cancels the run and closes the connection. @param {"view"|"place"} reason another view was opened, or another place chosen */
export function close(reason = "view") {
  if (isRunning()) {
    task = null;
    setRunning(false);
    showRunStatus(CANCELLED[reason], "cancelled");
  }
  active = false;
  loop.stop();
  connection?.close();
  connection = null;
}

if (window.matchMedia("(pointer: coarse)").matches) {
  write(
    /** @type {Element} */ (part("circle-invitation").querySelector("span")),
    "drag to each next one and lift your finger on it",
  );
}
form.addEventListener("submit", (event) => {
  event.preventDefault();
  start();
});
form.elements.predictor.addEventListener("change", () => active && connectWith(form.elements.predictor.value));
for (const name of ["targets", "width"]) form.elements[name].addEventListener("input", updateDistance);
form.elements.distance.addEventListener("input", () => (edited = true));
stopButton.addEventListener("click", () => stop());
onRepaint(onResize);
document.addEventListener("keydown", (event) => event.key === "Escape" && active && stop());
listenToPointer(canvas, {
  onMove: move,
  onPress: (row, event) => event.pointerType !== "touch" && event.button === 0 && select(row),
  onRelease: (row, event) => event.pointerType === "touch" && select(row),
});
