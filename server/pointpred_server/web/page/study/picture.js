// The picture of the pointing task: its targets, the one to select, and where the last selection was.

import { clearCanvas, colours } from "../drawing/canvas.js";
import { bar, clamp, disc, halo, MARKS, segment } from "../drawing/marks.js";

const HALO_PX = 6; // beyond the edge of the target
const [THIN_PX, BROAD_PX] = [4, 8];

/** @param {import("../drawing/marks.js").Pen} pen @param {import("../drawing/marks.js").Point} centre @param {number} reach @param {string} colour */
function cross(pen, [x, y], reach, colour) {
  segment(pen, [x - reach, y - reach], [x + reach, y + reach], colour, 2);
  segment(pen, [x - reach, y + reach], [x + reach, y - reach], colour, 2);
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {{places: number[][], width: number, height?: number | null, current: number | null, last: import("./task.js").Trial | null,
 *   prediction?: import("../../lib/index.d.ts").Prediction | null, probabilities?: number[], proposed?: number | null}} scene `height` of
 *   bars; `probabilities` of the targets are shown as the opacity of their halos; that of the proposed one is broad
 */
export function drawTask(
  canvas,
  { places, width: size, height: high = null, current, last, prediction = null, probabilities = [], proposed = null },
) {
  const { pen, width, height } = clearCanvas(canvas);
  const { endpoint, target, none, panel, quiet, [MARKS[0].colour]: markColour } = colours();
  places.forEach((place, i) => {
    const [colour, filled, line] = i === current ? [target, true, 3] : [none, false, 1.5];
    if (high === null) disc(pen, place, size / 2, colour, filled, line);
    else bar(pen, place, size, high, colour, filled, line);
  });
  places.forEach((place, i) =>
    halo(pen, place, size / 2 + HALO_PX, endpoint, probabilities[i] ?? 0, i === proposed ? BROAD_PX : THIN_PX),
  );
  if (current !== null) cross(pen, places[current], Math.min(5, size / 5), panel);
  if (last !== null) cross(pen, [last.end[1], last.end[2]], 4, last.hit ? quiet : endpoint);
  if (prediction !== null && prediction.x !== null && prediction.y !== null) {
    MARKS[0].shape(pen, clamp([prediction.x, prediction.y], width, height), 9, markColour, false, 3);
  }
}
