// Plots of errors: the lines in front told apart by colour and dashes, no prediction in black or white, the others in grey.

import { inks, onRepaint } from "../drawing/canvas.js";
import { FLOOR } from "./highlights.js";
import uPlot from "../vendor/uPlot.esm.js";

const DASHES = [[], [9, 5], [10, 4, 2, 4], [18, 5], [5, 3], [10, 4, 2, 4, 2, 4]];
const COLOURS = 7; // the eighth of the style sheet is that of no prediction

/**
 * The look of a line. @param {string} name @param {number|null} place among the lines in front; null: it is not one
 * @returns {{colour: string, dash: number[], width: number, layer: number}} `colour`: its name in the style sheet
 */
export function lookOf(name, place) {
  if (name === FLOOR) return { colour: "--series-8", dash: [1, 5], width: 3, layer: 1 };
  if (place === null) return { colour: "--faint", dash: [], width: 1, layer: 0 };
  return { colour: `--series-${1 + (place % COLOURS)}`, dash: DASHES[(place + Math.floor(place / COLOURS)) % DASHES.length], width: 2.5, layer: 2 };
}

const plots = new Map();

/**
 * Draws errors over shares of the way or of the time, in a box of fixed height.
 * @param {HTMLElement} box @param {number[]} shares
 * @param {{name: string, errors: (number|null)[], look: ReturnType<typeof lookOf>}[]} lines
 */
export function plotErrors(box, shares, lines) {
  plots.get(box)?.destroy();
  const ordered = [...lines].sort((a, b) => a.look.layer - b.look.layer);
  const quiet = () => inks().quiet;
  const grid = { stroke: () => inks().line, width: 1 };
  const axis = { stroke: quiet, grid, ticks: grid, font: "12px system-ui, sans-serif" };
  const most = Math.max(...lines.filter(({ name }) => name === FLOOR).flatMap(({ errors }) => errors), 1);
  const options = {
    width: Math.max(50, box.clientWidth),
    height: Math.max(50, box.clientHeight),
    legend: { show: false },
    cursor: { show: false },
    padding: [10, 26, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => [0, Math.min(high, 1.6 * most) * 1.05] } },
    axes: [{ ...axis, size: 30, values: (_, marks) => marks.map((mark) => `${mark} %`) }, { ...axis, size: 46 }],
    series: [{}, ...ordered.map(({ name, look: { colour, dash, width } }) => ({
      label: name, stroke: () => inkOf(colour), width, dash, cap: "round", points: { show: false }, spanGaps: true,
    }))],
  };
  plots.set(box, new uPlot(options, [shares.map((share) => 100 * share), ...ordered.map(({ errors }) => errors)], box));
}

const inkOf = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Leaves a box empty. */
export function clearPlot(box) {
  plots.get(box)?.destroy();
  plots.delete(box);
}

const SVG = "http://www.w3.org/2000/svg";

/** A short stroke with the look of a line, for legends and tables. */
export function swatch({ colour, dash, width }) {
  const picture = document.createElementNS(SVG, "svg");
  const stroke = document.createElementNS(SVG, "line");
  const where = { x1: 2, y1: 6, x2: 38, y2: 6, "stroke-width": width, "stroke-dasharray": dash.join(" "), "stroke-linecap": "round" };
  for (const [name, value] of Object.entries(where)) stroke.setAttribute(name, String(value));
  stroke.style.stroke = `var(${colour})`;
  picture.setAttribute("viewBox", "0 0 40 12");
  picture.setAttribute("class", "swatch");
  picture.setAttribute("aria-hidden", "true");
  picture.append(stroke);
  return picture;
}

onRepaint(() => {
  for (const [box, plot] of plots) if (box.clientWidth > 0) plot.setSize({ width: box.clientWidth, height: box.clientHeight });
});
