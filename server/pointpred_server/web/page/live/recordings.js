// What the tiles stand for: recordings that load while the pointer is on its way, by the product's own `onIntent`.

import { ledger, onIntent, onLedger } from "../../lib/intent/index.js";
import { sample, samples } from "../service/service.js";
import { cellsOf, part, write } from "../shell/elements.js";
import { bounds, number } from "../shell/numbers.js";

const SHARES_NAME = { simulated: "simulated movements", own: "your movements" }; // in the ledger: each is counted by itself
const AWAY_MS = 4000; // the simulated hand leaves the page's own events alone while a person was here so lately
const [WIDTH, HEIGHT] = [100, 50]; // of the drawing of a recording
const MOST_POINTS = 60;

const picture = part("live-scene");
const buttons = /** @type {HTMLElement[]} */ ([...part("live-links").children]);
const cells = cellsOf(part("live-loaded"));

/** @type {string[]|null} */ let names = null; // of the recordings
let stops = []; // what ends the registrations
/** @type {keyof typeof SHARES_NAME|null} */ let whose = null; // a key of SHARES_NAME
let personAt = -Infinity;
/** @type {object|null} */ let take = null; // the simulated movement that is shown, and whether it has ended
let ended = false;

/** @param {HTMLElement} button @param {"idle"|"loading"|"loaded"|"hit"|"wasted"} state @param {string} words */
function show(button, state, words) {
  button.dataset.state = state;
  write(/** @type {Element} */ (button.querySelector("span")), words);
  if (state === "idle") button.querySelector("path")?.removeAttribute("d");
}

/** @param {HTMLElement} button */
async function load(button) {
  if (button.dataset.state !== "idle") return;
  show(button, "loading", "loading");
  try {
    names ??= (await samples()).map(({ name }) => name);
    const path = drawing(await sample(names[buttons.indexOf(button)]));
    if (button.dataset.state === "idle") return; // another movement has begun
    button.querySelector("path")?.setAttribute("d", path);
    if (button.dataset.state === "loading") show(button, "loaded", "loaded");
  } catch {
    show(button, "idle", "cannot be loaded");
  }
}

/** The path of a movement as it is written in SVG, as large as the drawing. */
function drawing({ x, y }) {
  const [[left, right], [top, bottom]] = [bounds(x), bounds(y)];
  const scale = Math.min(WIDTH / Math.max(1, right - left), HEIGHT / Math.max(1, bottom - top));
  const across = (px) => (WIDTH / 2 + scale * (px - (left + right) / 2)).toFixed(1);
  const down = (px) => (HEIGHT / 2 + scale * (px - (top + bottom) / 2)).toFixed(1);
  const step = Math.ceil(x.length / MOST_POINTS);
  const points = x.map((_, i) => i).filter((i) => i % step === 0 || i === x.length - 1);
  return `M${points.map((i) => `${across(x[i])} ${down(y[i])}`).join("L")}`;
}

/** A movement is over: what was loaded and not used was loaded in vain. */
export function settle() {
  for (const button of buttons)
    if (["loading", "loaded"].includes(String(button.dataset.state))) show(button, "wasted", "not used");
  count();
}

/** A movement begins: everything can be loaded again. */
export function clear() {
  for (const button of buttons) show(button, "idle", "not loaded");
}

/** Writes what the ledger says. */
function count() {
  const counts = ledger().names[SHARES_NAME[whose]];
  for (const of of ["fired", "hit", "wasted"]) write(cells[of], number(counts?.[of] ?? 0));
  write(cells.early, number(counts?.lead_s.median, 2, "s"));
}

/** Registers the buttons anew, so that nothing is learned of a person from simulated movements. @param {keyof typeof SHARES_NAME} who */
function register(who) {
  if (whose === who) return;
  close();
  whose = who;
  clear();
  count();
  stops = buttons.map((button) => onIntent(button, () => load(button), { once: false, name: SHARES_NAME[who] }));
}

/**
 * Moves the simulated hand: events for the page's own listeners, and a click on the tile at the end.
 * @param {object} shown the movement @param {number[]} position x, y in the picture, px @param {boolean} atEnd
 * @param {number} tile the place of the tile where it ends
 */
export function simulate(shown, [x, y], atEnd, tile) {
  if (performance.now() - personAt < AWAY_MS) return;
  register("simulated");
  if (shown !== take || (ended && !atEnd)) {
    clear();
    [take, ended] = [shown, false];
  }
  if (ended) return;
  const { left, top } = picture.getBoundingClientRect();
  const place = { clientX: left + picture.clientLeft + x, clientY: top + picture.clientTop + y };
  window.dispatchEvent(new PointerEvent("pointermove", { ...place, pointerType: "mouse", isPrimary: true }));
  if (!atEnd) return;
  ended = true;
  buttons[tile].dispatchEvent(new MouseEvent("click", { ...place, bubbles: true }));
  settle();
}

/** Shows a tile as it is once its recording was loaded, without a movement. @param {number} tile */
export function showLoaded(tile) {
  if (buttons[tile].dataset.state === "idle") load(buttons[tile]);
}

/** A person uses the page. */
function arrive({ isTrusted }) {
  if (!isTrusted) return;
  personAt = performance.now();
  register("own");
}

/** Follows the pointer, the keys and the fingers. */
export function open() {
  register("own");
}

export function close() {
  for (const stop of stops) stop();
  [stops, whose] = [[], null];
}

for (const kind of ["pointermove", "pointerdown", "keydown"])
  window.addEventListener(kind, (event) => whose && arrive(event), { capture: true, passive: true });
for (const button of buttons) button.addEventListener("click", () => load(button));
onLedger(({ kind, element, lead_s: lead }) => {
  const button = buttons.find((one) => one === element);
  if (kind !== "hit" || button === undefined) return;
  show(button, "hit", `${number(lead, 2, "s")} early`);
  count();
});
