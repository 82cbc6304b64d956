// The replay of the embedded sample: reads trials from the service, and moves through one of them.

import { drawErrors, drawScene, errorAt } from "./drawing.js";

const FLOOR = "hold";
const part = (id) => document.getElementById(id);
const [scene, errors, play, time, previous, next, predictor, readout] = [
  "scene", "errors", "play", "time", "previous", "next", "predictor", "readout",
].map(part);

let samples = [];
let number = 0;
let movement = null;
let asked = 0;
let began = null; // when the replay began, on the animation clock, ms

async function read(address) {
  const answer = await fetch(address);
  const body = await answer.json();
  if (!answer.ok) throw new Error(body.message ?? `the service answered ${answer.status}`);
  return body;
}

function complain(error) {
  readout.textContent = `This cannot be shown: ${error.message}. Is the service still running?`;
}

/** Shows a movement at a time in ms; without one, where half of the way is done. */
async function show(which, ms = null) {
  const mine = ++asked;
  stop();
  number = (which + samples.length) % samples.length;
  const name = encodeURIComponent(samples[number].name);
  const chosen = encodeURIComponent([...new Set([predictor.value, FLOOR])].join(","));
  readout.textContent = "Computing the predictions… (the first time, the laws are compiled: some seconds)";
  const received = await read(`/v1/samples/${name}?predictors=${chosen}`);
  if (mine !== asked) return; // somebody went on meanwhile
  movement = received;
  time.max = Math.round(1000 * movement.t[movement.t.length - 1]);
  go(ms ?? 1000 * movement.t[halfWay()]);
}

function halfWay() {
  const away = movement.t.map((_, i) => errorAt(movement, movement.predictions[FLOOR], i));
  return Math.max(0, away.findIndex((px) => px < away[0] / 2));
}

/** The last event at or before the time the slider stands at. */
function event() {
  const after = movement.t.findIndex((t) => 1000 * t > Number(time.value));
  return after < 0 ? movement.t.length - 1 : Math.max(0, after - 1);
}

function go(ms) {
  time.value = Math.round(ms);
  time.setAttribute("aria-valuetext", `${(time.value / 1000).toFixed(2)} seconds`);
  draw();
}

function draw() {
  if (movement === null) return;
  const i = event();
  const own = movement.predictions[predictor.value];
  const none = movement.predictions[FLOOR];
  if (own === undefined) return;
  drawScene(scene, movement, own, i);
  drawErrors(errors, movement, own, none, i);
  if (began === null) readout.textContent = sentence(i, own, none);
}

function sentence(i, own, none) {
  const place = `Movement ${number + 1} of ${samples.length}, simulated person ${movement.user}, ${movement.t[i].toFixed(2)} s: `;
  const away = errorAt(movement, none, i).toFixed(0);
  const error = errorAt(movement, own, i);
  if (error === null) return `${place}${predictor.value} justifies no prediction now; the cursor is ${away} px from where it ended.`;
  return `${place}${predictor.value} is ${error.toFixed(0)} px off; the cursor is ${away} px from where it ended.`;
}

function stop() {
  began = null;
  play.textContent = "Play";
  draw();
}

function start() {
  const from = Number(time.value) >= Number(time.max) ? 0 : Number(time.value);
  began = performance.now() - from;
  play.textContent = "Pause";
  requestAnimationFrame(advance);
}

function advance(now) {
  if (began === null) return;
  const passed = Math.max(0, now - began);
  go(Math.min(passed, Number(time.max)));
  if (passed >= Number(time.max)) stop();
  else requestAnimationFrame(advance);
}

play.addEventListener("click", () => (began === null ? start() : stop()));
time.addEventListener("input", () => { stop(); go(Number(time.value)); });
previous.addEventListener("click", () => show(number - 1).catch(complain));
next.addEventListener("click", () => show(number + 1).catch(complain));
predictor.addEventListener("change", () => show(number, Number(time.value)).catch(complain));
window.addEventListener("resize", draw);
window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);

try {
  const listing = await read("/v1/samples");
  samples = listing.samples;
  predictor.replaceChildren(...listing.predictors.map(({ name, title }) => {
    const option = new Option(name, name, false, name === listing.preferred);
    option.title = title;
    return option;
  }));
  await show(0);
  for (const control of [play, time, previous, next, predictor]) control.disabled = false;
} catch (error) {
  complain(error);
}
