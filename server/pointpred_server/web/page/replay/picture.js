// The picture of a recorded movement: its path, and what was predicted at one of its events.

import { clearCanvas, colours } from "../drawing/canvas.js";
import { clamp, disc, drawEndpoint, line, MARKS } from "../drawing/marks.js";
import { drawRegions, projectRegions, regionsOf } from "../drawing/regions.js";
import { bounds } from "../shell/numbers.js";

const MARGIN_PX = 22;

/**
 * @typedef {{t: number[], x: number[], y: number[], target: {x: number, y: number, width: number} | null, person: string,
 *   predictions: Object<string, Column>}} Movement predictions by their predictor
 * @typedef {{x: (number|null)[], y: (number|null)[], regions: import("../../lib/index.d.ts").Prediction["region"][]}} Column the predictions of a predictor, one per event
 */

/** The distance from a predicted point to where the movement ended, px; null if nothing was predicted. @param {Movement} movement @param {Pick<Column, "x"|"y">} column @param {number} i @returns {number|null} */
export function errorAt(movement, column, i) {
  const last = movement.x.length - 1;
  const x = column.x[i],
    y = column.y[i];
  return x === null || y === null ? null : Math.hypot(x - movement.x[last], y - movement.y[last]);
}

/** The projection from screen px to px of the canvas, with one scale for both axes; the path and the target fit inside. @param {Movement} movement @param {number} width @param {number} height */
function projection(movement, width, height) {
  const { target } = movement;
  const reach = target === null ? 0 : (target.width || 0) / 2;
  const xs = target === null ? movement.x : [...movement.x, target.x - reach, target.x + reach];
  const ys = target === null ? movement.y : [...movement.y, target.y - reach, target.y + reach];
  const [left, right] = bounds(xs);
  const [top, bottom] = bounds(ys);
  const room = 0.25 * Math.max(right - left, bottom - top, 1);
  const scale = Math.min(
    (width - 2 * MARGIN_PX) / (right - left + 2 * room),
    (height - 2 * MARGIN_PX) / (bottom - top + 0.6 * room),
  );
  /** @param {import("../drawing/marks.js").Point} point */
  const place = ([x, y]) => [
    width / 2 + scale * (x - (left + right) / 2),
    height / 2 + scale * (y - (top + bottom) / 2),
  ];
  return { place, scale };
}

/**
 * Draws the path before and after event `i`, the target, the cursor, and the predicted endpoints with their regions.
 * @param {HTMLCanvasElement} canvas @param {Movement} movement @param {(Column|null)[]} columns @param {number} i
 */
export function drawMovement(canvas, movement, columns, i) {
  const { pen, width, height } = clearCanvas(canvas);
  const { target: targetColour, future, past, none } = colours();
  const { place, scale } = projection(movement, width, height);
  const predicted = columns.flatMap((column, which) => {
    const [x, y] = [column?.x[i] ?? null, column?.y[i] ?? null];
    return column === null || x === null || y === null ? [] : [{ x, y, region: column.regions[i], which }];
  });
  for (const { which, ...prediction } of predicted) {
    const regions = regionsOf(prediction);
    drawRegions(pen, projectRegions(regions, scale, place), MARKS[which], width, height);
  }
  const path = movement.x.map((x, k) => place([x, movement.y[k]]));
  if (movement.target !== null) {
    const { target } = movement;
    disc(pen, place([target.x, target.y]), Math.max(4, (scale * (target.width || 0)) / 2), targetColour);
  }
  line(pen, path.slice(i), future, 2, [6, 5]);
  line(pen, path.slice(0, i + 1), past, 3);
  disc(pen, path[i], 5, none, true);
  for (const { x, y, which } of predicted) drawEndpoint(pen, which, path[i], clamp(place([x, y]), width, height, 11));
}
