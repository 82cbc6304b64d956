// The live picture: tiles, the trail, the predicted endpoints and their regions.

import { clearCanvas, colours } from "../drawing/canvas.js";
import { clamp, disc, drawEndpoint, label, line, MARKS, tile } from "../drawing/marks.js";
import { drawRegions } from "../drawing/regions.js";
import { number } from "../shell/numbers.js";

const VISIBLE_S = 1.2; // a piece of the trail fades in this time
export const KEPT_S = 2;
const PAUSE_S = 0.3; // no line is drawn across a longer pause

/**
 * @typedef {{prediction: import("../service/predictor-connection.js").Prediction & {x: number, y: number}, regions: import("../drawing/regions.js").Regions|null, opacity: number,
 *   outlines?: [number, number][][][]|null}} Mark a prediction as it is drawn now, in px of the picture: the endpoint, the ellipses of
 *   its regions, and the outlines of a mixture's that are drawn instead
 * @typedef {{list: import("../../lib/index.d.ts").NamedTarget[], opacities: Object<string, number>, proposed: string|null}} TileState
 */

/** The part of a trail that is recent enough to draw; all of it if the pointer has rested since. @param {number[][]} trail [t s, x, y] @param {number} now s */
export const recentPart = (trail, now) =>
  trail.slice(
    Math.max(
      0,
      trail.findIndex(([t]) => t > now - KEPT_S),
    ),
  );

function drawTrail(pen, trail, now, colour) {
  const points = trail.filter(([t]) => now - t < VISIBLE_S);
  pen.save();
  pen.lineCap = "butt"; // round ends would show where pieces overlap
  for (let i = 1; i < points.length; i += 1) {
    const [t, x, y] = points[i];
    if (t - points[i - 1][0] > PAUSE_S) continue;
    pen.globalAlpha = Math.max(0.08, 1 - (now - t) / VISIBLE_S);
    line(pen, [points[i - 1].slice(1), [x, y]], colour, 3);
  }
  pen.restore();
  const last = trail[trail.length - 1];
  if (last !== undefined) disc(pen, last.slice(1), 5, colour, true);
}

/**
 * Draws a movement and what is predicted of it.
 * @param {HTMLCanvasElement} canvas @param {number[][]} trail [t s, x, y] @param {(Mark|null)[]} marks one for each predictor @param {number} now s
 * @param {TileState} tiles @param {"past"|"none"} colour of the trail @returns {number} endpoints drawn
 */
export function drawLive(canvas, trail, marks, now, tiles, colour = "past") {
  const { pen, width, height } = clearCanvas(canvas);
  const { endpoint, none, [colour]: trailColour } = colours();
  for (const one of tiles.list) tile(pen, one, endpoint, none, tiles.opacities[one.id] ?? 0, one.id === tiles.proposed);
  const shown = marks.flatMap((mark, which) => (mark === null ? [] : [{ ...mark, which }]));
  for (const { which, regions, opacity, outlines } of shown)
    drawRegions(pen, regions, MARKS[which], width, height, opacity, outlines);
  drawTrail(pen, trail, now, trailColour);
  const from = trail[trail.length - 1]?.slice(1);
  pen.save();
  for (const { which, prediction, opacity } of shown) {
    pen.globalAlpha = opacity;
    const end = clamp([prediction.x, prediction.y], width, height, 11);
    drawEndpoint(pen, which, from, end);
    if (prediction.remaining_s !== null && prediction.remaining_s > 0)
      label(pen, number(prediction.remaining_s, 2, "s"), end);
  }
  pen.restore();
  return shown.length;
}
