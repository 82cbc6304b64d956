// What the service still compiles on its first start: asked once a second while something is left.

import { read } from "./http.js";

const AGAIN_MS = 1000;

/** @type {{done: number, of: number, next: string|null, ready: string[], recommended: string}|null} */ let now = null;
let asking = false;
const hearers = new Set();

/** What to say of it beside a predictor; empty where nothing is compiled. @param {string} predictor @param {boolean} connected */
export function compilingWords(predictor, connected) {
  if (now === null) return "";
  const what = connected && now.ready.includes(predictor) ? "Ready. Compiling the other predictors" : "Compiling";
  return `${what}, only this once: ${now.done} of ${now.of} (${now.next}).`;
}

/** Calls `hear` whenever there is something else to say. */
export function whileCompiling(hear) {
  hearers.add(hear);
}

/** Asks the service, and again while something is left. */
export async function askCompiling() {
  if (asking) return;
  asking = true;
  do {
    const said = await read("/v1/compiling").catch(() => null);
    const before = now;
    now = said?.next ? said : null;
    mark();
    if (now !== null || before !== null) for (const hear of hearers) hear();
    if (now !== null) await new Promise((wake) => setTimeout(wake, AGAIN_MS));
  } while (now !== null);
  asking = false;
}

/** Says beside each predictor that can be chosen whether it is compiled. */
function mark() {
  for (const option of document.querySelectorAll("option[data-predictor]")) {
    const name = option.dataset.predictor;
    const waits = now !== null && !now.ready.includes(name);
    option.label = waits ? `${name} (not compiled yet)` : name;
  }
}
