// The assist view: the mouse lent to the page, its counts mapped by the service's own function, helped or not.

import { drawAssist } from "./picture.js";
import { KINDS, Lock, lendable } from "./pointer-lock.js";
import { Task } from "./task.js";
import { onRepaint } from "../drawing/canvas.js";
import { fill, offer, part, write } from "../page/elements.js";
import { predictors } from "../service/http.js";
import { Status } from "../service/status.js";
import { Track } from "../service/track.js";

const HELPING_MS = 60;
const SHOWN_MS = 500;
const BOUNDS = { cpi: "Counts per inch", gain: "Gain" };

const canvas = part("assist-scene"), form = part("assist-form"), select = part("assist-predictor"), take = part("assist-take");
const [said, results, invitation] = ["said", "results", "invitation"].map((of) => part(`assist-${of}`));
const status = new Status(part("assist-connection"));

let task = new Task();
let track = null; // a session lasts as long as the mouse is lent
let cursor = null;
let added = 0;
let helpedAt = -Infinity;
let kind = "unknown";
let asked = null; // what the form asked for when its numbers could last be used
let why = ""; // why the mouse is given back, where it was not the person's wish

const lock = new Lock(canvas, { moved, pressed, taken, given });

/** What the form asks for; null, said in its place, where a number cannot be used. */
function wishes() {
  for (const [name, noun] of Object.entries(BOUNDS)) {
    const { valueAsNumber: value, min, max } = form.elements[name];
    const fine = value >= Number(min) && value <= Number(max);
    form.elements[name].setAttribute("aria-invalid", String(!fine));
    if (!fine) {
      write(said, `${noun} must be a number from ${min} to ${max}.`);
      return null;
    }
  }
  return { cpi: form.elements.cpi.valueAsNumber, gain: form.elements.gain.valueAsNumber,
    strength: form.elements.strength.valueAsNumber / 100, alternate: form.elements.alternate.checked };
}

async function start(event) {
  event.preventDefault();
  asked = wishes();
  if (asked === null || lock.held) return;
  why = "";
  try {
    kind = await lock.take();
    if (lock.held) tell();
  } catch (error) {
    write(said, `The browser did not let this page capture the mouse: ${error.message}`);
  }
}

/** The mouse is ours: the field's middle, a session, a target. */
function taken() {
  const { cpi, gain, strength } = asked;
  const size = [canvas.clientWidth, canvas.clientHeight];
  cursor ??= size.map((each) => Math.round(each / 2));
  cursor = cursor.map((each, axis) => Math.min(each, size[axis] - 1));
  added = 0;
  track = new Track(select.value, { state, error: ({ message, recoverable }) => !recoverable && leave(message) },
    { assist: { strength, gain }, device: { cpi }, screen: { width_px: size[0], height_px: size[1], dpi: 96 } });
  track.connection.on("cursor", placed);
  next();
  tell();
  requestAnimationFrame(frame);
}

function next() {
  asked = wishes() ?? asked; // the keyboard can still change them
  const { gain, strength, alternate } = asked;
  task.next(cursor, [canvas.clientWidth, canvas.clientHeight], !alternate);
  track.connection.configure({ assist: { strength: task.helped ? strength : 0, gain } });
}

function tell() {
  invitation.classList.toggle("away", lock.held);
  if (lock.held) write(said, `Click the filled target, and each one after it. ${KINDS[kind]} Escape releases the mouse.`);
  fill(results, task.table);
}

function moved(counts) {
  if (track === null) return;
  for (const { t, dx, dy } of counts) if (dx || dy) task.moved(t);
  track.connection.send(counts.map(({ t, dx, dy, buttons }) => [t, ...cursor, dx, dy, buttons]));
}

function pressed(t) {
  if (task.pressed(cursor, t)) next();
  tell();
}

function placed({ x, y, added_px: now }) {
  cursor = [x, y];
  if (now > added) helpedAt = performance.now();
  added = now;
}

function frame() {
  draw();
  if (lock.held) requestAnimationFrame(frame);
}

function draw() {
  const held = lock.held, now = performance.now();
  const latest = held && track !== null && now - track.at < SHOWN_MS ? track.latest : null;
  const prediction = latest?.x == null ? null : [latest.x, latest.y];
  drawAssist(canvas, { cursor, target: held ? task.target : null, prediction, helps: held && now - helpedAt < HELPING_MS, held });
  Object.assign(canvas.dataset, { held, x: cursor?.[0] ?? "", y: cursor?.[1] ?? "", added, helped: task.helped,
    target: [task.target.x, task.target.y].join() });
}

function state(now) {
  status.say(now, { predictor: select.value, fault: track?.fault });
  if (now === "waiting" || now === "refused") leave("the service does not answer");
}

/** Nobody keeps a mouse whose cursor nobody moves. */
function leave(reason) {
  why = `The mouse was released: ${reason}.`;
  lock.give();
}

function given() {
  track?.close();
  track = null;
  tell();
  write(said, why || `The mouse was released. ${task.done.length ? "Capture it again to go on; the table is kept." : "No target was clicked."}`);
  draw();
}

/** Offers the predictors; nothing is connected until the mouse is lent. */
export async function open() {
  fill(results, task.table);
  draw();
  if (!lendable()) {
    write(said, "This browser cannot capture the mouse (it has no pointer lock), so this view does not work in it.");
    return;
  }
  const listing = await predictors();
  if (select.disabled) offer(select, listing.predictors, listing.recommended);
  take.disabled = false;
}

/** Gives the mouse back. */
export function close() {
  lock.give();
}

function showStrength() {
  const percent = form.elements.strength.valueAsNumber;
  write(part("assist-strength"), percent ? `up to ${percent} % faster` : "none");
}

form.addEventListener("submit", start);
form.elements.strength.addEventListener("input", showStrength);
part("assist-forget").addEventListener("click", () => {
  task = new Task();
  fill(results, task.table);
});
onRepaint(draw);
