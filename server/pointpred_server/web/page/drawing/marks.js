// Strokes and marks on a canvas, in CSS pixels.

import { colours } from "./canvas.js";

/**
 * @typedef {CanvasRenderingContext2D} Pen
 * @typedef {number[]} Point x, y
 */

/** A line through points. @param {Pen} pen @param {Point[]} points @param {string} colour @param {number} width @param {number[]} [dash] */
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

/** A straight line between two points. @param {Pen} pen @param {Point} from @param {Point} to @param {string} colour @param {number} width */
export const segment = (pen, from, to, colour, width) => line(pen, [from, to], colour, width);

function paint(pen, colour, filled, width) {
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = width;
  if (filled) pen.fill();
  else pen.stroke();
}

/** A disc, or a ring if it is not filled. @param {Pen} pen @param {Point} centre @param {number} radius @param {string} colour */
export function disc(pen, [x, y], radius, colour, filled = false, width = 2) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  paint(pen, colour, filled, width);
}

/** A square on its corner. @param {Pen} pen @param {Point} centre @param {number} radius @param {string} colour */
function diamond(pen, [x, y], radius, colour, filled = false, width = 2) {
  pen.beginPath();
  pen.moveTo(x, y - radius);
  pen.lineTo(x + radius, y);
  pen.lineTo(x, y + radius);
  pen.lineTo(x - radius, y);
  pen.closePath();
  paint(pen, colour, filled, width);
}

/** A rectangle around its centre, or its border if it is not filled. @param {Pen} pen @param {Point} centre @param {number} width @param {number} height @param {string} colour */
export function bar(pen, [x, y], width, height, colour, filled = false, line = 2) {
  pen.beginPath();
  pen.rect(x - width / 2, y - height / 2, width, height);
  paint(pen, colour, filled, line);
}

/** A ring with an opacity from 0 to 1. @param {Pen} pen @param {Point} centre @param {number} radius @param {string} colour @param {number} opacity */
export function halo(pen, centre, radius, colour, opacity, width = 4) {
  if (!(opacity > 0)) return;
  pen.save();
  pen.globalAlpha = Math.min(1, opacity);
  disc(pen, centre, radius, colour, false, width);
  pen.restore();
}

/** A rectangle with a tint of an opacity from 0 to 1, and a thicker border if it is highlighted. */
export function tile(pen, { x, y, width, height }, colour, border, opacity, highlighted) {
  pen.beginPath();
  pen.roundRect(x, y, width, height, 6);
  pen.save();
  pen.globalAlpha = Math.min(1, opacity);
  paint(pen, colour, true, 0);
  pen.restore();
  paint(pen, highlighted ? colour : border, false, highlighted ? 4 : 1.5);
}

/** @typedef {{shape: typeof disc, colour: string, dash: number[], outline: number[]}} Mark of a predictor */

/** The marks of the first and the second predictor: they differ in shape as well as in colour. @type {Mark[]} */
export const MARKS = [
  { shape: disc, colour: "endpoint", dash: [4, 5], outline: [] },
  { shape: diamond, colour: "second", dash: [1, 5], outline: [6, 4] },
];

/** A predicted endpoint: the mark of a predictor, and a dashed line to it. @param {Pen} pen @param {number} which of the predictors @param {Point|undefined} from @param {Point} endpoint */
export function drawEndpoint(pen, which, from, endpoint) {
  const { shape, colour, dash } = MARKS[which],
    { [colour]: own, panel } = colours();
  if (from !== undefined) line(pen, [from, endpoint], own, 1.5, dash);
  shape(pen, endpoint, 9, panel, false, 6); // a rim: a tile of the same colour may lie below
  shape(pen, endpoint, 9, own, false, 3);
  shape(pen, endpoint, 2, own, true);
}

const TEXT_AT = [16, -16]; // from the mark that it belongs to

/** Words beside a mark, on a rim of the panel's colour. @param {Pen} pen @param {string} text @param {Point} mark */
export function label(pen, text, [x, y]) {
  pen.font = "600 13px system-ui, sans-serif";
  pen.strokeStyle = colours().panel;
  pen.fillStyle = colours().text;
  pen.lineWidth = 4;
  pen.textAlign = x + 60 > pen.canvas.clientWidth ? "right" : "left";
  const side = pen.textAlign === "right" ? -1 : 1,
    /** @type {[number, number]} */ at = [x + side * TEXT_AT[0], Math.max(y + TEXT_AT[1], 12)];
  pen.strokeText(text, ...at);
  pen.fillText(text, ...at);
}

/** The point nearest to another inside a picture: what lies outside is drawn at its edge. @param {Point} point @param {number} width @param {number} height */
export function clamp([x, y], width, height, margin = 9) {
  return [Math.min(width - margin, Math.max(margin, x)), Math.min(height - margin, Math.max(margin, y))];
}

/** A phase from `begin` to `end`: a tint below a bar that is solid if it is ballistic and hatched if it is corrective. */
export function drawPhase(pen, phase, begin, end, top, height, bar) {
  pen.fillStyle = pen.strokeStyle = colours()[phase];
  pen.globalAlpha = 0.14;
  pen.fillRect(begin, top, end - begin, height);
  pen.globalAlpha = 1;
  if (phase === "ballistic") pen.fillRect(begin, top, end - begin, bar);
  else hatch(pen, begin, end, top, bar);
}

function hatch(pen, begin, end, top, bar) {
  pen.lineWidth = bar / 4;
  pen.beginPath();
  for (let x = begin; x < end; x += bar * 0.7) {
    pen.moveTo(x, top + bar);
    pen.lineTo(Math.min(end, x + bar), top);
  }
  pen.stroke();
}
