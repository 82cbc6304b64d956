// The legend's swatches: each is drawn as what it stands for is drawn in the picture.

import { MARKS, disc, inks, line, onRepaint, prepare, tile } from "./canvas.js";
import { drawEndpoint } from "../live/picture.js";
import { drawRegions } from "./regions.js";
import { drawPhase } from "../live/strip.js";

const endpoint = (which) => (pen, width, height, ink) => drawEndpoint(pen, which, [2, height / 2], [width - 12, height / 2], ink);
const trail = (colour) => (pen, width, height, ink) => {
  line(pen, [[2, height / 2], [width - 8, height / 2]], ink[colour], 3);
  disc(pen, [width - 7, height / 2], 5, ink[colour], true);
};
const phase = (name) => (pen, width, height) => drawPhase(pen, name, 1, width - 1, 2, height - 4, 7);
const tiled = (share, framed) => (pen, width, height, ink) =>
  tile(pen, { x: 3, y: 3, width: width - 6, height: height - 6 }, ink.endpoint, ink.none, share, framed);

function region(pen, width, height, ink) {
  const at = { x: width / 2, y: height / 2, angle: 0 };
  const regions = { inner: { ...at, major: 0.27 * width, minor: 0.25 * height }, outer: { ...at, major: width / 2 - 2, minor: height / 2 - 2 } };
  drawRegions(pen, regions, ink[MARKS[0].colour], MARKS[0].outline, 10 * width, 10 * height);
}

const SWATCHES = {
  trail: trail("past"), simulated: trail("none"), endpoint: endpoint(0), second: endpoint(1), region,
  likely: tiled(0.5, false), proposed: tiled(0.9, true), ballistic: phase("ballistic"), corrective: phase("corrective"),
};

function drawAll() {
  for (const canvas of document.querySelectorAll("canvas[data-swatch]")) {
    if (canvas.clientWidth === 0) continue;
    const { pen, width, height } = prepare(canvas);
    SWATCHES[canvas.dataset.swatch](pen, width, height, inks());
  }
}

/** Draws the swatches that are visible, and again whenever theme or size change. */
export function drawSwatches() {
  onRepaint(drawAll);
  drawAll();
}
