// One page with ForesightJS and onIntent: both hear the same events, and each firing is kept with its time.

import { ForesightManager } from "js.foresight";
import { onIntent, register } from "/pointpred/intent/index.js";
import { build } from "/pointpred/prediction/build.js";

const PREDICTORS = new URLSearchParams(location.search).getAll("predictor");
const LONG_MS = 25; // a frame that takes longer than one and a half of 60 Hz

let events = [],
  fired = [],
  stops = [],
  frames = 0,
  long = 0,
  before = performance.now();

const manager = ForesightManager.initialize();
window.addEventListener(
  "pointermove",
  (event) => {
    for (const { timeStamp, clientX, clientY } of event.getCoalescedEvents())
      events.push([timeStamp / 1000, clientX, clientY]);
  },
  { capture: true, passive: true },
);
const watch = (now) => {
  frames += 1;
  long += now - before > LONG_MS;
  before = now;
  requestAnimationFrame(watch);
};
requestAnimationFrame(watch);

/** Loads the predictors, and keeps them between movements: an element that nobody sees stays registered with each. */
async function open() {
  const keeper = document.createElement("div");
  keeper.style.display = "none";
  document.body.append(keeper);
  await Promise.all(PREDICTORS.map((predictor) => build(predictor)));
  for (const predictor of PREDICTORS) register(keeper, { predictor });
}

/** Hears earlier movements. @param {number[][]} rows s before now (negative), px, px, buttons */
function learn(rows) {
  const now = performance.now();
  let pressed = 0;
  for (const [t, clientX, clientY, buttons] of rows) {
    const name = buttons > pressed ? "pointerdown" : buttons < pressed ? "pointerup" : "pointermove";
    const event = new PointerEvent(name, {
      isPrimary: true,
      pointerType: "mouse",
      bubbles: true,
      clientX,
      clientY,
      buttons,
    });
    Object.defineProperty(event, "timeStamp", { value: now + 1000 * t });
    document.body.dispatchEvent(event);
    pressed = buttons;
  }
}

/** Takes the targets away. */
function clear() {
  stops.splice(0).forEach((stop) => stop());
  document.querySelectorAll(".target").forEach((element) => element.remove());
}

/** Whether the middle of a target lies under another: then no place counts as covered, because onIntent leaves out what is. */
const overlap = (targets) =>
  targets.some(([left, top, width, height], place) =>
    targets.some(
      ([x, y, w, h], other) =>
        other !== place &&
        Math.abs(left + 0.5 * width - x - 0.5 * w) <= 0.5 * w &&
        Math.abs(top + 0.5 * height - y - 0.5 * h) <= 0.5 * h,
    ),
  );

/** Puts other targets in place. @param {number[][]} targets left, top, width, height px of each */
function show(targets) {
  clear();
  document.elementFromPoint = overlap(targets) ? () => null : Document.prototype.elementFromPoint;
  targets.forEach(([left, top, width, height], place) => {
    const element = document.createElement("div"),
      hear = (rule) => () => {
        fired.push([rule, place, performance.now() / 1000]);
      };
    element.className = "target";
    element.style = `left: ${left}px; top: ${top}px; width: ${width}px; height: ${height}px`;
    document.body.append(element);
    stops.push(manager.register({ element, callback: hear("ForesightJS") }).unregister);
    stops.push(...PREDICTORS.map((predictor) => onIntent(element, hear(predictor), { predictor, once: false })));
  });
}

/** Arms every target anew, onIntent's by their own law when the next movement begins, and forgets what was heard. */
function arm() {
  document.querySelectorAll(".target").forEach((element) => manager.reactivate(element));
  [events, fired, frames, long] = [[], [], 0, 0];
}

/** What was heard since then: times in s, positions in px. */
const heard = () => ({ events, fired, frames, long });

window.beside = { arm, learn, show, heard, opened: open() };
