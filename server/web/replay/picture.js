// The scene of one recorded movement: where it went, and what was predicted at a moment of it.

import { MARKS, disc, inks, line, prepare } from "../drawing/canvas.js";
import { drawEndpoint } from "../live/picture.js";
import { inside } from "../circle/geometry.js";
import { drawRegions, regionsOf } from "../drawing/regions.js";

const MARGIN_PX = 22;

/**
 * @typedef {{t: number[], x: number[], y: number[], target: {x: number, y: number, width: number} | null}} Movement
 * @typedef {{x: (number|null)[], y: (number|null)[], regions: (object|null)[]}} Column a predictor's answers, one an event
 */

/** The distance from a predicted point to where the movement ended, px; null where nothing was predicted. */
export function errorAt(movement, column, i) {
  const last = movement.x.length - 1;
  const x = column.x[i], y = column.y[i];
  return x === null ? null : Math.hypot(x - movement.x[last], y - movement.y[last]);
}

/** Smallest and largest of many numbers; spreading long arrays as arguments would fail. */
function bounds(values) {
  return values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
}

/** The regions of a prediction in px of the canvas; null where it claims none. */
function regionsIn({ place, scale }, column, i) {
  const regions = regionsOf({ x: column.x[i], y: column.y[i], region: column.regions[i] });
  if (regions === null) return null;
  const moved = ({ x, y, major, minor, angle }) => {
    const [left, top] = place(x, y);
    return { x: left, y: top, major: scale * major, minor: scale * minor, angle };
  };
  return { inner: moved(regions.inner), outer: moved(regions.outer) };
}

/** Screen px of the movement to px of the canvas: one scale for both axes, the trail and the target inside. */
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
  const place = (x, y) => [width / 2 + scale * (x - (left + right) / 2), height / 2 + scale * (y - (top + bottom) / 2)];
  return { place, scale };
}

/**
 * The trail so far and to come, the target, the cursor, and the predicted endpoints with their regions at event `i`.
 * @param {HTMLCanvasElement} canvas @param {Movement} movement @param {(Column|null)[]} columns @param {number} i
 */
export function drawScene(canvas, movement, columns, i) {
  const { pen, width, height } = prepare(canvas);
  const ink = inks();
  const view = projection(movement, width, height);
  const { place, scale } = view;
  const answered = columns.flatMap((column, which) => (column === null || column.x[i] === null ? [] : [{ column, which }]));
  for (const { column, which } of answered) {
    const regions = regionsIn(view, column, i);
    if (regions !== null) drawRegions(pen, regions, ink[MARKS[which].colour], MARKS[which].outline, width, height);
  }
  const trail = movement.x.map((x, k) => place(x, movement.y[k]));
  if (movement.target !== null) {
    const { target } = movement;
    disc(pen, place(target.x, target.y), Math.max(4, (scale * (target.width || 0)) / 2), ink.target);
  }
  line(pen, trail.slice(i), ink.future, 2, [6, 5]);
  line(pen, trail.slice(0, i + 1), ink.past, 3);
  disc(pen, trail[i], 5, ink.none, true);
  for (const { column, which } of answered) {
    drawEndpoint(pen, which, trail[i], inside(place(column.x[i], column.y[i]), width, height, 11), ink);
  }
}
