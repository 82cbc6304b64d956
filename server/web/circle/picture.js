// The picture of the circle: its targets, the one to select, where the last selection fell.

import { MARKS, disc, halo, inks, line, prepare } from "../drawing/canvas.js";
import { inside } from "./geometry.js";

function cross(pen, [x, y], reach, colour) {
  line(pen, [[x - reach, y - reach], [x + reach, y + reach]], colour, 2);
  line(pen, [[x - reach, y + reach], [x + reach, y - reach]], colour, 2);
}

const HALO_PX = 6; // beyond the edge of its target
const [THIN_PX, BROAD_PX] = [4, 8];

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{places: number[][], width: number, current: number | null, last: object | null, predicted: object | null,
 *   shares?: number[], proposed?: number | null}} scene `shares`: how likely each target is said to be, 0 to 1; shown as the
 *   opacity of its halo, which is broad for the one that is proposed
 */
export function drawCircle(canvas, { places, width: size, current, last, predicted, shares = [], proposed = null }) {
  const { pen, width, height } = prepare(canvas);
  const ink = inks();
  places.forEach((place, i) => disc(pen, place, size / 2, i === current ? ink.target : ink.none, i === current, i === current ? 3 : 1.5));
  places.forEach((place, i) => halo(pen, place, size / 2 + HALO_PX, ink.endpoint, shares[i] ?? 0, i === proposed ? BROAD_PX : THIN_PX));
  if (current !== null) cross(pen, places[current], Math.min(5, size / 5), ink.panel);
  if (last !== null) cross(pen, last.end.slice(1, 3), 4, last.hit ? ink.quiet : ink.endpoint);
  if (predicted !== null && predicted.x !== null) {
    const { shape, colour } = MARKS[0];
    shape(pen, inside([predicted.x, predicted.y], width, height), 9, ink[colour], false, 3);
  }
}
