// The replay view: a recorded movement with a slider over its time, and what was predicted along it.

import { onRepaint, prepare } from "../drawing/canvas.js";
import { drawErrors } from "./errors.js";
import { drawScene, errorAt } from "./picture.js";
import { number as written, offer, part, write } from "../page/elements.js";
import { drawSwatches } from "../drawing/legend.js";
import { askColumns, closeColumns } from "./columns.js";
import { acceptFiles } from "./drop.js";
import { Player } from "./player.js";
import { Results } from "../results/results.js";
import { embedded, opened } from "./source.js";
import { predictors } from "../service/http.js";

const [scene, errors, previous, next] = ["scene", "errors", "previous", "next"].map((id) => part(`replay-${id}`));
const [list, readout, said, file, back, again] = ["trials", "readout", "source", "file", "sample", "again"].map((id) => part(`replay-${id}`));
const choices = [0, 1].map((which) => part(`replay-predictor-${which}`));
const player = new Player(part("replay-play"), part("replay-time"), draw);
const results = new Results("replay");

let source = null;
let movement = null;
let at = 0;
let asked = 0; // the newest wish for a movement; what comes late for an older one is not shown
let sought = 0; // and for a source

const columns = () => choices.map(({ value }) => movement.predictions[value] ?? null);

const chosen = () => [...new Set(choices.map(({ value }) => value).filter(Boolean))];

/** Shows a movement at a time in ms; without one, where half of the way is done. */
async function show(which, ms = null) {
  const mine = ++asked;
  player.stop();
  again.hidden = true;
  at = (which + source.names.length) % source.names.length;
  list.selectedIndex = at;
  write(readout, "Computing the predictions…");
  const received = await fetched(source, at);
  if (mine === asked) put(received, ms);
}

/** A movement of a source with its predictions, or the error instead of it. */
const fetched = (from, which) => from.movement(which, chosen()).catch((error) => error);

function put(received, ms = null) {
  if (received instanceof Error) clear(`Movement ${at + 1} cannot be shown: ${received.message}.`);
  else {
    movement = received;
    player.load(1000 * movement.t[movement.t.length - 1], ms ?? 1000 * movement.t[halfWay()]);
  }
  again.hidden = movement !== null;
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
  drawErrors(errors, movement, own, Math.min(player.ms / 1000, movement.t[movement.t.length - 1]));
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

/**
 * Goes over to another source of movements, unless yet another has been asked for; says whether it did. What is shown stays
 * until the first movement of the new source is there, or is known not to come.
 */
async function take(coming) {
  const mine = ++sought;
  let found, first;
  try {
    found = await coming;
    first = await fetched(found, 0);
  } catch (error) {
    if (mine !== sought) return false;
    throw error;
  }
  if (mine !== sought) return false;
  asked += 1;
  player.stop();
  [source, at] = [found, 0];
  list.replaceChildren(...source.names.map((name, i) => new Option(name, String(i))));
  list.selectedIndex = 0;
  write(said, source.said);
  part("replay-result").hidden = source.csv === null;
  back.disabled = source.csv === null;
  for (const control of [previous, next, list]) control.disabled = false;
  put(first);
  if (movement !== null && chosen().some((name) => !(name in movement.predictions))) await show(0); // chosen meanwhile
  return true;
}

async function openFiles(files, told = {}) {
  if (!files.length) return;
  if (told.columns === undefined) closeColumns(); // else what the form says may be refused: it stays until the file is open
  write(said, "Reading…");
  try {
    if (!(await take(opened(files, told)))) return;
    closeColumns();
    await results.score(source.csv, [...choices[0].options].map(({ value }) => value), "", source.told);
  } catch (error) {
    const before = source === null ? "" : ` What was open before stays: ${source.title}.`;
    const asks = error.refusal?.code === "columns";
    if (asks) askColumns(files[0].name, error.refusal, (chosen) => openFiles(files, chosen));
    write(said, asks ? `${files[0].name}: choose its columns in the form.${before}` : `Not opened: ${error.message}.${before}`);
  }
}

async function openSample() {
  closeColumns();
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
    offer(choices[0], listing.predictors, listing.recommended);
    offer(choices[1], listing.predictors, "", "none");
  }
  drawSwatches();
  if (source === null) await take(embedded());
  else if (movement === null) await show(at);
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
again.addEventListener("click", () => show(at));
acceptFiles(part("replay-drop"), (files) => openFiles(files));
onRepaint(draw);
