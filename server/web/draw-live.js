// The live picture: the trail, the predicted endpoints and their regions, or the replayed movement that invites.

import { MARKS, disc, ellipse, inks, line, prepare, tile } from "./draw.js";
import { inside } from "./geometry.js";
import { placed } from "./live-demo.js";
import { regionOf } from "/pointpred.js";

const TRAIL_S = 1.2;

function drawTrail(pen, trail, now, ink) {
  const points = trail.filter(([t]) => now - t < TRAIL_S);
  pen.save();
  pen.lineCap = "butt"; // round ends would show where pieces overlap
  for (let i = 1; i < points.length; i += 1) {
    const [t, x, y] = points[i];
    if (t - points[i - 1][0] > 0.3) continue;
    pen.globalAlpha = Math.max(0.08, 1 - (now - t) / TRAIL_S);
    line(pen, [points[i - 1].slice(1), [x, y]], ink.past, 3);
  }
  pen.restore();
  const last = trail[trail.length - 1];
  if (last !== undefined) disc(pen, last.slice(1), 5, ink.past, true);
}

/** Where the endpoint is likely to lie, where that is said: below everything else. */
function drawRegion(pen, which, prediction, ink) {
  const { colour, dash } = MARKS[which];
  const region = regionOf(prediction, 0.95);
  if (region) ellipse(pen, region, ink[colour], dash);
}

/** A predicted endpoint: the mark, and a dashed line to it. */
function drawEndpoint(pen, which, from, prediction, width, height, ink) {
  const { shape, colour, dash } = MARKS[which];
  const point = [prediction.x, prediction.y];
  const place = inside(point, width, height, 11);
  if (from !== undefined) line(pen, [from, place], ink[colour], 1.5, dash);
  shape(pen, place, 9, ink.panel, false, 6); // a rim: a tile in the mark's own colour may lie below
  shape(pen, place, 9, ink[colour], false, 3);
  shape(pen, place, 2, ink[colour], true);
}

/**
 * The pointer's own movement.
 * @param {number[][]} trail [t s, x, y] @param {(object|null)[]} predictions one for each predictor @param {number} now s
 * @param {import("./live-tiles.js").Tiles} tiles
 * @returns {number} endpoints drawn
 */
export function drawLive(canvas, trail, predictions, now, tiles) {
  const { pen, width, height } = prepare(canvas);
  const ink = inks();
  for (const one of tiles.list) tile(pen, one, ink.endpoint, ink.none, tiles.shares[one.id] ?? 0, one.id === tiles.proposed);
  const said = predictions.map((prediction, which) => ({ prediction, which })).filter(({ prediction }) => prediction !== null && prediction.x !== null);
  for (const { prediction, which } of said) drawRegion(pen, which, prediction, ink);
  drawTrail(pen, trail, now, ink);
  const from = trail[trail.length - 1]?.slice(1);
  for (const { prediction, which } of said) drawEndpoint(pen, which, from, prediction, width, height, ink);
  return said.length;
}

function caption(pen, words, [x, y], width, colour) {
  pen.font = "14px system-ui, sans-serif";
  const room = pen.measureText(words).width;
  pen.fillStyle = colour;
  pen.fillText(words, x + 22 + room < width ? x + 22 : x - 22 - room, y + 5);
}

/** A replayed movement up to an event, with its target. */
export function drawDemo(canvas, { movement, event }) {
  const { pen, width, height } = prepare(canvas);
  const ink = inks();
  const place = placed(movement, width, height);
  const points = movement.x.map((x, i) => place([x, movement.y[i]]));
  const end = points[points.length - 1];
  disc(pen, end, 15, ink.target);
  caption(pen, "where it will end", [end[0], end[1] + 14], width, ink.quiet);
  line(pen, points.slice(0, event + 1), ink.none, 3);
  disc(pen, points[event], 5, ink.none, true);
  const { x, y } = movement.predicted;
  if (x[event] === null) return;
  const [px, py] = place([x[event], y[event]]);
  drawEndpoint(pen, 0, points[event], { x: px, y: py }, width, height, ink);
  caption(pen, "predicted", inside([px, py - 14], width, height, 20), width, ink.endpoint);
}

/** Nothing to show but an empty picture. */
export function drawNothing(canvas) {
  prepare(canvas);
}

