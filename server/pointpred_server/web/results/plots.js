// Plots of errors: highlighted lines differ in colour and dashes, hold is dotted, the others are grey.

import { Plot, axis } from "../drawing/plot.js";
import { BASELINE } from "./highlights.js";

const DASHES = [[], [9, 5], [10, 4, 2, 4], [18, 5], [5, 3], [10, 4, 2, 4, 2, 4]];
const COLOURS = 7; // the eighth colour of the style sheet is that of hold

/**
 * The style of a line. @param {string} name @param {number|null} index of its colour; null: it is grey
 * @returns {{colour: string, dash: number[], width: number, layer: number}} `colour`: the name of its variable in the style sheet
 */
export function lineStyle(name, index) {
  if (name === BASELINE) return { colour: "--series-8", dash: [1, 5], width: 3, layer: 1 };
  if (index === null) return { colour: "--faint", dash: [], width: 1, layer: 0 };
  return { colour: `--series-${1 + (index % COLOURS)}`, dash: DASHES[(index + Math.floor(index / COLOURS)) % DASHES.length], width: 2.5, layer: 2 };
}

const variable = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const plots = new Map(); // by their boxes

/**
 * Plots errors against shares of the path or of the time, in a box of fixed height.
 * @param {HTMLElement} box @param {number[]} shares
 * @param {{name: string, errors: (number|null)[], style: ReturnType<typeof lineStyle>}[]} lines
 */
export function plotErrors(box, shares, lines) {
  clearPlot(box);
  const ordered = [...lines].sort((a, b) => a.style.layer - b.style.layer);
  const most = Math.max(...lines.filter(({ name }) => name === BASELINE).flatMap(({ errors }) => errors), 1);
  plots.set(box, new Plot(box, {
    padding: [10, 26, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => [0, Math.min(high, 1.6 * most) * 1.05] } },
    axes: [axis({ size: 30, values: (_, marks) => marks.map((mark) => `${mark} %`) }), axis({ size: 46 })],
    series: [{}, ...ordered.map(({ name, style: { colour, dash, width } }) => ({
      label: name, stroke: () => variable(colour), width, dash, cap: "round", points: { show: false }, spanGaps: true,
    }))],
  }, [shares.map((share) => 100 * share), ...ordered.map(({ errors }) => errors)]));
}

/** Removes the plot from a box. */
export function clearPlot(box) {
  plots.get(box)?.destroy();
  plots.delete(box);
}

const SVG = "http://www.w3.org/2000/svg";

/** A short stroke in the style of a line, for legends and tables. */
export function lineSymbol({ colour, dash, width }) {
  const picture = document.createElementNS(SVG, "svg");
  const stroke = document.createElementNS(SVG, "line");
  const attributes = { x1: 2, y1: 6, x2: 38, y2: 6, "stroke-width": width, "stroke-dasharray": dash.join(" "), "stroke-linecap": "round" };
  for (const [name, value] of Object.entries(attributes)) stroke.setAttribute(name, String(value));
  stroke.style.stroke = `var(${colour})`;
  picture.setAttribute("viewBox", "0 0 40 12");
  picture.setAttribute("class", "swatch");
  picture.setAttribute("aria-hidden", "true");
  picture.append(stroke);
  return picture;
}
