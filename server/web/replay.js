// The replay view: a recorded movement with a slider over its time, and what was predicted along it.

import { onRepaint, prepare } from "./draw.js";
import { drawErrors, drawScene, errorAt } from "./draw-replay.js";
import { number as written, offer, part, write } from "./elements.js";
import { acceptFiles } from "./replay-drop.js";
import { Player } from "./replay-player.js";
import { showScores } from "./replay-scores.js";
import { embedded, opened } from "./replay-source.js";
import { PREFERRED, predictors } from "./service.js";

const [scene, errors, previous, next] = ["scene", "errors", "previous", "next"].map((id) => part(`replay-${id}`));
const [list, readout, said, file, back] = ["trials", "readout", "source", "file", "sample"].map((id) => part(`replay-${id}`));
const choices = [0, 1].map((which) => part(`replay-predictor-${which}`));
const player = new Player(part("replay-play"), part("replay-time"), draw);

let source = null;
let movement = null;
let at = 0;
let asked = 0; // the newest wish for a movement; what comes late for an older one is not shown
let sought = 0; // and for a source

const columns = () => choices.map(({ value }) => movement.predictions[value] ?? null);

/** Shows a movement at a time in ms; without one, where half of the way is done. */
async function show(which, ms = null) {
  const mine = ++asked;
  player.stop();
  at = (which + source.names.length) % source.names.length;
  list.selectedIndex = at;
  write(readout, "Computing the predictions…");
  const names = [...new Set(choices.map(({ value }) => value).filter(Boolean))];
  try {
    const received = await source.movement(at, names);
    if (mine !== asked) return;
    movement = received;
    player.load(1000 * movement.t[movement.t.length - 1], ms ?? 1000 * movement.t[halfWay()]);
  } catch (error) {
    if (mine === asked) clear(`Movement ${at + 1} cannot be shown: ${error.message}.`);
  }
  player.enable(movement !== null);
}

/** Shows nothing, and why. */
function clear(words) {
  movement = null;
  write(readout, words);
  for (const canvas of [scene, errors]) prepare(canvas);
}

function halfWay() {
  const away = movement.t.map((_, i) => errorAt(movement, movement, i));
  return Math.max(0, away.findIndex((px) => px < away[0] / 2));
}

/** The last event at or before the time the slider stands at. */
function event() {
  const after = movement.t.findIndex((t) => 1000 * t > player.ms);
  return after < 0 ? movement.t.length - 1 : Math.max(0, after - 1);
}

function draw() {
  if (movement === null || scene.clientWidth === 0) return;
  const i = event();
  const own = columns();
  drawScene(scene, movement, own, i);
  drawErrors(errors, movement, own, i);
  scene.dataset.event = String(i);
  if (!player.playing) write(readout, sentence(i, own));
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

/** Goes over to another source of movements, unless yet another has been asked for; says whether it did. */
async function take(coming) {
  const mine = ++sought;
  try {
    const found = await coming;
    if (mine !== sought) return false;
    source = found;
  } catch (error) {
    if (mine !== sought) return false;
    throw error;
  }
  list.replaceChildren(...source.names.map((name, i) => new Option(name, String(i))));
  write(said, source.said);
  part("replay-result").hidden = source.csv === null;
  back.disabled = source.csv === null;
  for (const control of [previous, next, list]) control.disabled = false;
  await show(0);
  return true;
}

async function openFiles(files) {
  if (!files.length) return;
  write(said, "Reading…");
  try {
    if (!(await take(opened(files)))) return;
    const { csv } = source;
    await showScores(csv, [...choices[0].options].map(({ value }) => value), () => source.csv === csv);
  } catch (error) {
    write(said, `Not opened: ${error.message}.${source === null ? "" : " What was open before stays."}`);
  }
}

async function openSample() {
  try {
    await take(embedded());
  } catch (error) {
    write(said, `The sample cannot be shown: ${error.message}. Is the service still running?`);
  }
}

/** Shows the embedded sample, at first. */
export async function open() {
  const listing = await predictors();
  if (choices[0].options.length === 0) {
    offer(choices[0], listing.predictors, PREFERRED);
    offer(choices[1], listing.predictors, "", "none");
  }
  if (source === null) await take(embedded());
  draw();
}

/** Holds the replay. */
export function close() {
  player.stop();
}

previous.addEventListener("click", () => show(at - 1));
next.addEventListener("click", () => show(at + 1));
list.addEventListener("change", () => show(list.selectedIndex));
for (const choice of choices) choice.addEventListener("change", () => source && show(at, player.ms));
file.addEventListener("click", () => (file.value = "")); // the same file may be opened again
file.addEventListener("change", () => openFiles([...file.files]));
back.addEventListener("click", openSample);
acceptFiles(part("replay-drop"), openFiles);
onRepaint(draw);
