// The replay view: a recorded movement with a slider over its time, and what was predicted along it.

import { onRepaint } from "./draw.js";
import { drawErrors, drawScene, errorAt } from "./draw-replay.js";
import { number as written, offer, part, write } from "./elements.js";
import { embedded, opened } from "./replay-source.js";
import { expectScores, scoreTable, sentence as scoredSentence, setOf } from "./scores.js";
import { PREFERRED, predictors, score } from "./service.js";

const [scene, errors, play, time, previous, next] = ["scene", "errors", "play", "time", "previous", "next"].map((id) => part(`replay-${id}`));
const [list, readout, said, file, back, drop] = ["trials", "readout", "source", "file", "sample", "drop"].map((id) => part(`replay-${id}`));
const choices = [0, 1].map((which) => part(`replay-predictor-${which}`));
const controls = [play, time, previous, next, list];

let source = null;
let movement = null;
let at = 0;
let asked = 0;
let began = null; // when the replay began, on the animation clock, ms

const columns = () => choices.map(({ value }) => movement.predictions[value] ?? null);

function complain(error) {
  write(said, `This cannot be shown: ${error.message}. Is the service still running?`);
}

/** Shows a movement at a time in ms; without one, where half of the way is done. */
async function show(which, ms = null) {
  const mine = ++asked;
  stop();
  at = (which + source.names.length) % source.names.length;
  list.selectedIndex = at;
  write(readout, "Computing the predictions…");
  const names = [...new Set(choices.map(({ value }) => value).filter(Boolean))];
  const received = await source.movement(at, names);
  if (mine !== asked) return; // somebody went on meanwhile
  movement = received;
  time.max = String(Math.round(1000 * movement.t[movement.t.length - 1]));
  go(ms ?? 1000 * movement.t[halfWay()]);
}

function halfWay() {
  const away = movement.t.map((_, i) => errorAt(movement, movement, i));
  return Math.max(0, away.findIndex((px) => px < away[0] / 2));
}

/** The last event at or before the time the slider stands at. */
function event() {
  const after = movement.t.findIndex((t) => 1000 * t > Number(time.value));
  return after < 0 ? movement.t.length - 1 : Math.max(0, after - 1);
}

function go(ms) {
  time.value = String(Math.round(ms));
  time.setAttribute("aria-valuetext", `${(time.value / 1000).toFixed(2)} seconds`);
  draw();
}

function draw() {
  if (movement === null || scene.clientWidth === 0) return;
  const i = event();
  const own = columns();
  drawScene(scene, movement, own, i);
  drawErrors(errors, movement, own, i);
  scene.dataset.event = String(i);
  if (began === null) write(readout, sentence(i, own));
}

function sentence(i, own) {
  const away = errorAt(movement, movement, i).toFixed(0);
  const parts = own.flatMap((column, which) => {
    if (column === null) return [];
    const error = errorAt(movement, column, i);
    return [`${choices[which].value} ${error === null ? "says nothing" : `is ${written(error)} px off`}`];
  });
  return `${movement.t[i].toFixed(2)} s: ${parts.join(", ")}, the cursor is ${away} px from where it ended. Movement ${at + 1} of ${source.names.length}, ${movement.who}.`;
}

function stop() {
  began = null;
  write(play, "Play");
  draw();
}

function start() {
  const from = Number(time.value) >= Number(time.max) ? 0 : Number(time.value);
  began = performance.now() - from;
  write(play, "Pause");
  requestAnimationFrame(advance);
}

function advance(now) {
  if (began === null) return;
  const passed = Math.max(0, now - began);
  go(Math.min(passed, Number(time.max)));
  if (passed >= Number(time.max)) stop();
  else requestAnimationFrame(advance);
}

/** Goes over to another source of movements. */
async function take(found) {
  source = found;
  list.replaceChildren(...source.names.map((name, i) => new Option(name, String(i))));
  write(said, source.said);
  part("replay-result").hidden = source.csv === null;
  back.disabled = source.csv === null;
  await show(0);
  for (const control of controls) control.disabled = false;
}

async function openFiles(files) {
  if (!files.length) return;
  write(said, "Reading…");
  try {
    await take(await opened([...files]));
    await scoreFile();
  } catch (error) {
    write(said, `${files[0].name} cannot be shown: ${error.message}.`);
  }
}

async function scoreFile() {
  const { csv } = source;
  write(part("replay-scored"), "The service scores every predictor on this file…");
  expectScores(part("replay-scores"), [...choices[0].options].map(({ value }) => value));
  try {
    const set = setOf(await score(csv));
    if (source.csv !== csv) return;
    scoreTable(part("replay-scores"), set);
    write(part("replay-scored"), scoredSentence(set));
  } catch (error) {
    write(part("replay-scored"), `Not scored: ${error.message}.`);
  }
}

/** Shows the embedded sample, at first. */
export async function open() {
  const listing = await predictors();
  if (choices[0].options.length === 0) {
    offer(choices[0], listing.predictors, PREFERRED);
    offer(choices[1], listing.predictors, "", "none");
  }
  if (source === null) await take(await embedded());
  draw();
}

/** Holds the replay. */
export function close() {
  stop();
}

play.addEventListener("click", () => (began === null ? start() : stop()));
time.addEventListener("input", () => { stop(); go(Number(time.value)); });
previous.addEventListener("click", () => show(at - 1).catch(complain));
next.addEventListener("click", () => show(at + 1).catch(complain));
list.addEventListener("change", () => show(list.selectedIndex).catch(complain));
for (const choice of choices) choice.addEventListener("change", () => source && show(at, Number(time.value)).catch(complain));
file.addEventListener("change", () => openFiles(file.files));
back.addEventListener("click", () => embedded().then(take).catch(complain));
for (const kind of ["dragenter", "dragover", "dragleave", "drop"]) {
  document.addEventListener(kind, (dragged) => {
    if (drop.offsetParent === null) return; // another view is open
    dragged.preventDefault();
    drop.classList.toggle("over", kind === "dragenter" || kind === "dragover");
    if (kind === "drop") openFiles(dragged.dataTransfer.files);
  });
}
onRepaint(draw);
