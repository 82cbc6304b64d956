// What the service still compiles on its first start, requested once a second until it is done.

import { read } from "./http.js";
import { inPage, onPlace } from "./place.js";

const INTERVAL_MS = 1000;

/** @type {{done: number, of: number, next: string|null, ready: string[], recommended: string}|null} */ let progress = null;
let polling = false, wanted = false; // whether it is requested, and whether to go on
const listeners = new Set();

/**
 * What is compiled, as text and as a state; null if nothing is. @param {string} predictor in use @param {boolean} connected
 * @returns {{state: "ready"|"compiling", text: string}|null} "ready": the predictor is compiled, others are not
 */
export function compilingProgress(predictor, connected) {
  if (progress === null) return null;
  const state = connected && progress.ready.includes(predictor) ? "ready" : "compiling";
  const subject = state === "ready" ? "Ready. Compiling the other predictors" : "Compiling";
  return { state, text: `${subject} (first start only): ${progress.done} of ${progress.of}, ${progress.next}.` };
}

/** Calls `listener` whenever the progress has changed. */
export function onCompiling(listener) {
  listeners.add(listener);
}

/** Requests the progress, and again until everything is compiled or the page predicts. */
export async function pollCompiling() {
  wanted = true;
  if (polling) return;
  polling = true;
  while (wanted) {
    const answer = await read("/v1/compiling").catch(() => null);
    wanted = Boolean(answer?.next) && !inPage();
    set(wanted ? answer : null);
    if (wanted) await new Promise((resolve) => setTimeout(resolve, INTERVAL_MS));
  }
  polling = false;
}

function set(newest) {
  const before = progress;
  progress = newest;
  labelOptions();
  if (progress !== null || before !== null) for (const listener of listeners) listener();
}

onPlace(() => inPage() && set(null)); // in the page nothing is compiled

/** Labels the predictors that are not compiled yet. */
function labelOptions() {
  for (const option of document.querySelectorAll("option[data-predictor]")) {
    const name = option.dataset.predictor;
    const compiled = progress === null || progress.ready.includes(name);
    option.label = compiled ? name : `${name} (not compiled yet)`;
  }
}
