// Strokes and marks on a canvas, in CSS pixels and in the colours of the style sheet.

const NAMES = [
  "panel", "text", "quiet", "line", "past", "future", "endpoint", "second", "none", "target", "ballistic", "corrective",
];

let ink = null;
const listeners = new Set();

/** The colours of the style sheet, by name; read again when the theme changes. */
export function inks() {
  if (ink === null) {
    const style = getComputedStyle(document.documentElement);
    ink = Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
    ink.series = [1, 2, 3, 4, 5, 6, 7, 8].map((i) => style.getPropertyValue(`--series-${i}`).trim());
  }
  return ink;
}

/** Calls back when pictures must be drawn again: another theme or another size of the window. */
export function onRepaint(callback) {
  listeners.add(callback);
}

for (const query of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"]) {
  window.matchMedia(query).addEventListener("change", () => {
    ink = null;
    for (const callback of listeners) callback();
  });
}
window.addEventListener("resize", () => {
  for (const callback of listeners) callback();
});

/** Whether the person asked for less motion. */
export const calm = () => window.matchMedia("(prefers-reduced-motion: reduce)").matches;

/** The canvas cleared and sharp on any display; lengths are CSS pixels. */
export function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  const columns = Math.round(width * ratio), rows = Math.round(height * ratio);
  if (canvas.width !== columns || canvas.height !== rows) [canvas.width, canvas.height] = [columns, rows];
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.lineJoin = pen.lineCap = "round";
  return { pen, width, height };
}

/** A stroke through points [x, y]. */
export function line(pen, points, colour, width, dash = []) {
  if (points.length < 2) return;
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.beginPath();
  points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
  pen.stroke();
  pen.setLineDash([]);
}

function finish(pen, colour, filled, width) {
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = width;
  if (filled) pen.fill();
  else pen.stroke();
}

/** A disc, or a ring where it is not filled. */
export function disc(pen, [x, y], radius, colour, filled = false, width = 2) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  finish(pen, colour, filled, width);
}

/** A ring as opaque as a number from 0 to 1 says: at 0 there is nothing. */
export function halo(pen, place, radius, colour, share, width = 4) {
  if (!(share > 0)) return;
  pen.save();
  pen.globalAlpha = Math.min(1, share);
  disc(pen, place, radius, colour, false, width);
  pen.restore();
}

/** A rectangle tinted as strongly as a number from 0 to 1 says, its edge thicker where it is marked. */
export function tile(pen, { x, y, width, height }, colour, edge, share, marked) {
  pen.beginPath();
  pen.roundRect(x, y, width, height, 6);
  pen.save();
  pen.globalAlpha = Math.min(1, share);
  finish(pen, colour, true, 0);
  pen.restore();
  finish(pen, marked ? colour : edge, false, marked ? 4 : 1.5);
}

/** A square on its corner. */
export function diamond(pen, [x, y], radius, colour, filled = false, width = 2) {
  pen.beginPath();
  pen.moveTo(x, y - radius);
  pen.lineTo(x + radius, y);
  pen.lineTo(x, y + radius);
  pen.lineTo(x - radius, y);
  pen.closePath();
  finish(pen, colour, filled, width);
}

/** The marks of the first and the second predictor: they differ in shape as in colour. */
export const MARKS = [
  { shape: disc, colour: "endpoint", dash: [4, 5], outline: [] },
  { shape: diamond, colour: "second", dash: [1, 5], outline: [6, 4] },
];
