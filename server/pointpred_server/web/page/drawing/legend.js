// The symbols of the legend, drawn like what they stand for.

import { clearCanvas, colours, onRepaint } from "./canvas.js";
import { disc, drawEndpoint, drawPhase, MARKS, segment, tile } from "./marks.js";
import { drawRegions } from "./regions.js";

const endpoint = (which) => (pen, width, height) => drawEndpoint(pen, which, [2, height / 2], [width - 12, height / 2]);
const trail = (name) => (pen, width, height) => {
  const colour = colours()[name];
  segment(pen, [2, height / 2], [width - 8, height / 2], colour, 3);
  disc(pen, [width - 7, height / 2], 5, colour, true);
};
const phase = (name) => (pen, width, height) => drawPhase(pen, name, 1, width - 1, 2, height - 4, 7);
const tileSymbol = (opacity, highlighted) => (pen, width, height) =>
  tile(
    pen,
    { x: 3, y: 3, width: width - 6, height: height - 6 },
    colours().endpoint,
    colours().none,
    opacity,
    highlighted,
  );

function region(pen, width, height) {
  const centre = { x: width / 2, y: height / 2, angle: 0 };
  const regions = {
    inner: { ...centre, major: 0.27 * width, minor: 0.25 * height },
    outer: { ...centre, major: width / 2 - 2, minor: height / 2 - 2 },
  };
  drawRegions(pen, regions, MARKS[0], 10 * width, 10 * height);
}

const SYMBOLS = {
  trail: trail("past"),
  simulated: trail("none"),
  endpoint: endpoint(0),
  second: endpoint(1),
  region,
  likely: tileSymbol(0.5, false),
  proposed: tileSymbol(0.9, true),
  ballistic: phase("ballistic"),
  corrective: phase("corrective"),
};

/** Draws the symbols that are visible; it is called again whenever theme or size change. */
export function drawLegends() {
  for (const canvas of /** @type {NodeListOf<HTMLCanvasElement>} */ (
    document.querySelectorAll("canvas[data-swatch]")
  )) {
    if (canvas.clientWidth === 0) continue;
    const { pen, width, height } = clearCanvas(canvas);
    SYMBOLS[String(canvas.dataset.swatch)](pen, width, height);
  }
}

onRepaint(drawLegends);
