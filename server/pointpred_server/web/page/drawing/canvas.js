// Canvases in CSS pixels and in the colours of the style sheet, drawn again when the theme or the window changes.

const NAMES = [
  "panel",
  "text",
  "quiet",
  "line",
  "past",
  "future",
  "endpoint",
  "second",
  "none",
  "target",
  "ballistic",
  "corrective",
];

/** @type {Object<string, string>|null} */
let current = null;
const listeners = [];

/** The colours of the style sheet by name; they are read again when the theme changes. */
export function colours() {
  if (current === null) {
    const style = getComputedStyle(document.documentElement);
    current = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
  }
  return current;
}

/** Calls `redraw` when pictures must be drawn again: the theme or the size of the window has changed. @param {() => void} redraw */
export const onRepaint = (redraw) => listeners.push(redraw);

const repaint = () => listeners.forEach((redraw) => redraw());
for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"]) {
  window.matchMedia(query).addEventListener("change", () => {
    current = null;
    repaint();
  });
}
window.addEventListener("resize", repaint);

/** Whether the person has asked for less motion. */
export const prefersLessMotion = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;

/** Clears a canvas and makes it sharp on any display; lengths are CSS pixels. @param {HTMLCanvasElement} canvas */
export function clearCanvas(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth,
    height = canvas.clientHeight;
  const columns = Math.round(width * ratio),
    rows = Math.round(height * ratio);
  if (canvas.width !== columns || canvas.height !== rows) [canvas.width, canvas.height] = [columns, rows];
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.lineJoin = pen.lineCap = "round";
  return { pen, width, height };
}

/** Calls `draw` once per frame while it runs. */
export class FrameLoop {
  #draw;
  #running = false;
  #scheduled = false;

  /** @param {(now: number) => void} draw `now` in ms */
  constructor(draw) {
    this.#draw = draw;
  }

  /** Starts the loop; starting it twice makes no second one. */
  start() {
    this.#running = true;
    this.#schedule();
  }

  stop() {
    this.#running = false;
  }

  #schedule() {
    if (!this.#scheduled) requestAnimationFrame((now) => this.#frame(now));
    this.#scheduled = true;
  }

  #frame(now) {
    this.#scheduled = false;
    if (!this.#running) return;
    this.#draw(now);
    if (this.#running) this.#schedule();
  }
}
