// Plots of errors: a line for each predictor, told apart by colour and dashes, no prediction in grey.

import { inks, onRepaint } from "./draw.js";
import uPlot from "./vendor/uPlot.esm.js";

const DASHES = [[], [8, 4], [2, 3], [10, 3, 2, 3]];
const FLOOR = "hold";

/** The look of the line number `i` among those that are not the floor. */
function look(name, i) {
  if (name === FLOOR) return { colour: () => inks().none, dash: [], width: 4 };
  return { colour: () => inks().series[i % 8], dash: DASHES[(i + Math.floor(i / 8)) % DASHES.length], width: 2 };
}

/** The looks of predictors in the order of their names. @param {string[]} names */
export function looks(names) {
  let at = 0;
  return names.map((name) => look(name, name === FLOOR ? 0 : at++));
}

const plots = new Map();

/**
 * Draws errors over shares of the way or of the time, in a box of fixed height.
 * @param {HTMLElement} box @param {number[]} shares @param {{name: string, errors: (number|null)[]}[]} lines
 */
export function plotErrors(box, shares, lines) {
  plots.get(box)?.destroy();
  const quiet = () => inks().quiet;
  const grid = { stroke: () => inks().line, width: 1 };
  const axis = { stroke: quiet, grid, ticks: grid, font: "12px system-ui, sans-serif" };
  const styled = looks(lines.map(({ name }) => name));
  const most = Math.max(...lines.filter(({ name }) => name === FLOOR).flatMap(({ errors }) => errors), 1);
  const options = {
    width: Math.max(50, box.clientWidth),
    height: Math.max(50, box.clientHeight),
    legend: { show: false },
    cursor: { show: false },
    padding: [10, 26, 0, 0],
    scales: { x: { time: false }, y: { range: (_, low, high) => [0, Math.min(high, 1.6 * most) * 1.05] } },
    axes: [{ ...axis, size: 30, values: (_, marks) => marks.map((mark) => `${mark} %`) }, { ...axis, size: 46 }],
    series: [{}, ...lines.map(({ name }, i) => ({
      label: name, stroke: styled[i].colour, width: styled[i].width, dash: styled[i].dash, points: { show: false }, spanGaps: true,
    }))],
  };
  plots.set(box, new uPlot(options, [shares.map((share) => 100 * share), ...lines.map(({ errors }) => errors)], box));
}

/** Leaves a box empty. */
export function clearPlot(box) {
  plots.get(box)?.destroy();
  plots.delete(box);
}

/** A legend with a stroke of each line. */
export function legend(list, names) {
  const styled = looks(names);
  list.replaceChildren(...names.map((name, i) => {
    const item = document.createElement("li");
    const swatch = document.createElement("canvas");
    swatch.width = 34;
    swatch.height = 12;
    const pen = swatch.getContext("2d");
    pen.strokeStyle = styled[i].colour();
    pen.lineWidth = styled[i].width;
    pen.setLineDash(styled[i].dash);
    pen.beginPath();
    pen.moveTo(1, 6);
    pen.lineTo(33, 6);
    pen.stroke();
    item.append(swatch, name === FLOOR ? "hold: no prediction" : name);
    return item;
  }));
  list.dataset.names = JSON.stringify(names);
}

onRepaint(() => {
  for (const [box, plot] of plots) if (box.clientWidth > 0) plot.setSize({ width: box.clientWidth, height: box.clientHeight });
  for (const list of document.querySelectorAll(".legend[data-names]")) legend(list, JSON.parse(list.dataset.names));
});
