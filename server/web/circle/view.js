// The circle view: settings, the run, a row for each movement as it is scored.

import { showResult } from "./results.js";
import { CircleChoices } from "./choices.js";
import { CircleRows } from "./rows.js";
import { fits, overlap, readSettings, suit } from "./settings.js";
import { CircleTask } from "./task.js";
import { onRepaint } from "../drawing/canvas.js";
import { drawCircle } from "./picture.js";
import { count, offer, part, write } from "../page/elements.js";
import { circle } from "./geometry.js";
import { Ledger } from "../page/ledger.js";
import { follow } from "../page/pointer.js";
import { predictors } from "../service/http.js";
import { Status } from "../service/status.js";
import { Track } from "../service/track.js";

const FRESH_MS = 500;
const READY = ["open", "idle"]; // states of a connection in which a run can start: a sleeping one wakes
const DOWN = "Start is off: the service does not answer. Is it still running? The page tries again by itself.";

const [canvas, form, startButton, stopButton] = ["circle-scene", "circle-form", "circle-start", "circle-stop"].map(part);
const [said, progress] = ["circle-said", "circle-progress"].map(part);
const status = new Status(part("circle-connection"));
const rows = new CircleRows(part("circle-rows"));
const choices = new CircleChoices();

let active = false;
let drawing = false;
let offered = false;
let news = part("circle-said").textContent; // what is said of the run
let edited = false; // whether the distance is the person's own
let marked = false; // whether the service knows where the movement that goes on began
let names = []; // of every predictor
/** @type {Track|null} */ let track = null;
let ledger = new Ledger();
/** @type {CircleTask|null} */ let task = null;

function goal() {
  const { x, y, width } = task.goal;
  return { x, y, width };
}

function moved(events) {
  if (task === null || task.done) return;
  task.move(events);
  track?.connection.send(events);
}

/** A press selects; a finger has no path but while it touches, so that its lifting selects. */
function selected(row) {
  if (task === null || task.done) return;
  const trial = task.select(row);
  if (trial !== null) {
    if (marked) track.connection.trial("end", { x: trial.target[0], y: trial.target[1], width: trial.width });
    rows.add(trial, marked);
  }
  marked = task.running && track?.connection.state === "open";
  if (marked) track.connection.trial("start", goal());
  canvas.dataset.target = JSON.stringify(task.done ? null : { ...goal(), running: task.running });
  tell();
  if (task.done) finish();
}

/** Says how the run stands; while none goes on and the service is down, says that instead. */
function announce(words = news) {
  news = words;
  const idle = task === null || task.done;
  write(said, idle && ["waiting", "refused"].includes(status.state) ? DOWN : news);
}

function tell() {
  const misses = task.trials.filter(({ hit }) => !hit).length;
  progress.max = task.total;
  progress.value = task.trials.length;
  const counted = `${task.trials.length} of ${task.total} movements, ${misses} missed`;
  if (task.done) announce(`Done: ${counted}. The result is below.`);
  else if (!task.running) announce(`Block ${task.block} of ${task.settings.blocks}: click the filled target to begin. ${counted}.`);
  else announce(`Block ${task.block} of ${task.settings.blocks}: ${counted}.`);
}

function stateOf(state) {
  status.say(state, { predictor: form.elements.predictor.value, fault: track?.fault });
  startButton.disabled = !READY.includes(state);
  announce();
  if (state === "open") return;
  marked = false; // a session opened again knows of no movement
  rows.lose();
  choices.clear();
}

function connectWith(predictor) {
  if (track?.predictor === predictor && track.connection.state !== "closed") return;
  track?.close();
  track = null;
  track = new Track(predictor, {
    state: stateOf,
    score: (score) => { rows.scored(score); ledger.add(score); write(part("circle-ledger"), ledger.words); },
    prediction: (prediction) => choices.predicted(prediction),
    choice: (choice) => choices.take(choice),
    error: ({ code }) => code === "out_of_place" && rows.lose(),
  }, { encoding: "json" }); // packed predictions have no room for shares
}

function start() {
  const { settings, problem, field } = readSettings(form, canvas);
  if (problem) {
    announce(problem);
    field.focus();
    return;
  }
  task = new CircleTask(settings);
  rows.clear();
  ledger = new Ledger();
  write(part("circle-ledger"), "");
  connectWith(form.elements.predictor.value);
  choices.offer(track.connection, task.places, settings.width);
  running(true);
  marked = false;
  canvas.parentElement.scrollIntoView({ block: "nearest" });
  canvas.dataset.target = JSON.stringify({ ...goal(), running: false });
  tell();
}

function running(yes) {
  if (!yes) choices.clear();
  startButton.textContent = yes ? "Start again" : "Start";
  stopButton.disabled = !yes;
  part("circle-invitation").classList.toggle("away", yes);
  for (const field of form.elements) if (!["circle-start", "circle-stop"].includes(field.id) && field.name !== "shown") field.disabled = yes;
}

function stop(why = "") {
  if (task === null || task.done) return;
  const trials = task.trials;
  task = null;
  running(false);
  announce((trials.length ? `Stopped after ${count(trials.length, "movement")}.` : "Stopped.") + why);
  if (trials.length > 1) showResult(trials, names);
}

function finish() {
  running(false);
  showResult(task.trials, names);
}

function frame() {
  drawing = active;
  if (!active) return;
  const { settings, problem } = readSettings(form, canvas);
  const shown = task ?? { places: circle(settings.distance, settings.centre, settings.targets), settings };
  const going = task !== null && !task.done;
  write(part("circle-warning"), problem || going ? "" : overlap(settings));
  const told = form.elements.shown.checked;
  const fresh = told && track !== null && performance.now() - track.at < FRESH_MS;
  drawCircle(canvas, {
    places: shown.places, width: shown.settings.width, current: going ? task.current : null,
    last: task?.trials[task.trials.length - 1] ?? null, predicted: going && fresh ? track.latest : null,
    shares: going && told ? choices.shares : [], proposed: choices.proposed,
  });
  requestAnimationFrame(frame);
}

/** Another size of the window: a circle that no longer fits is not gone on with. */
function resized() {
  if (!active) return;
  if (task === null || task.done) refit();
  else if (!fits(task, canvas)) stop(" The window has become too small for this circle.");
}

/** A distance that the page chose follows what there is room for. */
function refit() {
  if (!edited) suit(form, canvas);
}

/** Connects and draws from now on. */
export async function open() {
  active = true;
  refit();
  if (!drawing) requestAnimationFrame(frame);
  drawing = true;
  const listing = await predictors();
  if (!offered) offer(part("circle-predictor"), listing.predictors, listing.recommended);
  offered = true;
  names = listing.predictors.map(({ name }) => name);
  announce();
  if (active) connectWith(form.elements.predictor.value);
}

/** Gives up a run that goes on, and lets the connection go. */
export function close() {
  if (task !== null && !task.done) {
    task = null;
    running(false);
    announce("The run was cancelled because another view was opened.");
  }
  active = false;
  track?.close();
  track = null;
}

if (window.matchMedia("(pointer: coarse)").matches) {
  write(part("circle-invitation").querySelector("span"), "drag to each next one and lift your finger on it");
}
form.addEventListener("submit", (event) => { event.preventDefault(); start(); });
form.elements.predictor.addEventListener("change", () => active && connectWith(form.elements.predictor.value));
for (const name of ["targets", "width"]) form.elements[name].addEventListener("input", refit);
form.elements.distance.addEventListener("input", () => (edited = true));
stopButton.addEventListener("click", () => stop());
onRepaint(resized);
document.addEventListener("keydown", (event) => event.key === "Escape" && active && stop());
follow(canvas, {
  moved,
  pressed: (row, event) => event.pointerType !== "touch" && event.button === 0 && selected(row),
  released: (row, event) => event.pointerType === "touch" && selected(row),
});
