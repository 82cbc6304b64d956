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

async function show(which, share) {
  const mine = ++asked;
  stop();
  number = (which + samples.length) % samples.length;
  const name = encodeURIComponent(samples[number].name);
  const chosen = encodeURIComponent([...new Set([predictor.value, FLOOR])].join(","));
  readout.textContent = "Computing the predictions… (the first time, the laws are compiled: some seconds)";
  const received = await read(`/v1/samples/${name}?predictors=${chosen}`);
  if (mine !== asked) return; // somebody went on meanwhile
  movement = received;
  time.max = movement.t.length - 1;
  go(Math.round(share * (movement.t.length - 1)));
}

function go(i) {
  time.value = i;
  time.setAttribute("aria-valuetext", `${movement.t[i].toFixed(2)} seconds`);
  draw();
}

function draw() {
  if (movement === null) return;
  const i = Number(time.value);
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
  const i = Number(time.value);
  const from = i >= movement.t.length - 1 ? 0 : movement.t[i];
  began = performance.now() - 1000 * from;
  play.textContent = "Pause";
  requestAnimationFrame(advance);
}

function advance(now) {
  if (began === null) return;
  const passed = (now - began) / 1000;
  const after = movement.t.findIndex((t) => t > passed);
  go(after < 0 ? movement.t.length - 1 : Math.max(0, after - 1));
  if (after < 0) stop();
  else requestAnimationFrame(advance);
}

play.addEventListener("click", () => (began === null ? start() : stop()));
time.addEventListener("input", () => { stop(); go(Number(time.value)); });
previous.addEventListener("click", () => show(number - 1, 0.5).catch(complain));
next.addEventListener("click", () => show(number + 1, 0.5).catch(complain));
predictor.addEventListener("change", () => {
  const share = movement === null ? 0.5 : Number(time.value) / Math.max(1, movement.t.length - 1);
  show(number, share).catch(complain);
});
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
  await show(0, 0.5);
  for (const control of [play, time, previous, next, predictor]) control.disabled = false;
} catch (error) {
  complain(error);
}
