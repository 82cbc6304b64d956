// The live picture: tiles, the trail, the predicted endpoints and their regions.

import { MARKS, disc, inks, line, prepare, tile } from "../drawing/canvas.js";
import { inside } from "../circle/geometry.js";
import { drawRegions } from "../drawing/regions.js";

const TRAIL_S = 1.2;

/**
 * @typedef {{prediction: object, regions: import("../drawing/regions.js").Regions|null, opacity: number}} Mark a prediction as it is
 *   drawn now: its endpoint in px of the picture
 * @typedef {{list: object[], shares: Object<string, number>, proposed: string|null}} Tiles
 */

export function drawTrail(pen, trail, now, colour) {
  const points = trail.filter(([t]) => now - t < TRAIL_S);
  pen.save();
  pen.lineCap = "butt"; // round ends would show where pieces overlap
  for (let i = 1; i < points.length; i += 1) {
    const [t, x, y] = points[i];
    if (t - points[i - 1][0] > 0.3) continue;
    pen.globalAlpha = Math.max(0.08, 1 - (now - t) / TRAIL_S);
    line(pen, [points[i - 1].slice(1), [x, y]], colour, 3);
  }
  pen.restore();
  const last = trail[trail.length - 1];
  if (last !== undefined) disc(pen, last.slice(1), 5, colour, true);
}

/** A predicted endpoint: the mark at a place, and a dashed line to it. */
export function drawEndpoint(pen, which, from, place, ink) {
  const { shape, colour, dash } = MARKS[which];
  if (from !== undefined) line(pen, [from, place], ink[colour], 1.5, dash);
  shape(pen, place, 9, ink.panel, false, 6); // a rim: a tile in the mark's own colour may lie below
  shape(pen, place, 9, ink[colour], false, 3);
  shape(pen, place, 2, ink[colour], true);
}

/**
 * A movement, and what is predicted of it.
 * @param {number[][]} trail [t s, x, y] @param {(Mark|null)[]} marks one for each predictor @param {number} now s
 * @param {Tiles} tiles @param {"past"|"none"} colour of the trail @returns {number} endpoints drawn
 */
export function drawLive(canvas, trail, marks, now, tiles, colour = "past") {
  const { pen, width, height } = prepare(canvas);
  const ink = inks();
  for (const one of tiles.list) tile(pen, one, ink.endpoint, ink.none, tiles.shares[one.id] ?? 0, one.id === tiles.proposed);
  const shown = marks.flatMap((mark, which) => (mark === null ? [] : [{ ...mark, which }]));
  for (const { which, regions, opacity } of shown) {
    if (regions !== null) drawRegions(pen, regions, ink[MARKS[which].colour], MARKS[which].outline, width, height, opacity);
  }
  drawTrail(pen, trail, now, ink[colour]);
  const from = trail[trail.length - 1]?.slice(1);
  pen.save();
  for (const { which, prediction, opacity } of shown) {
    pen.globalAlpha = opacity;
    drawEndpoint(pen, which, from, inside([prediction.x, prediction.y], width, height, 11), ink);
  }
  pen.restore();
  return shown.length;
}

/** An empty picture. */
export function drawNothing(canvas) {
  prepare(canvas);
}
