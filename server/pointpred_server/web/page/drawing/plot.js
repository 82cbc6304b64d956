// What the plots of the page have in common: axes in the page's colours, and a size that follows their box.

import uPlot from "../vendor/uPlot.esm.js";
import { colours, onRepaint } from "./canvas.js";

const MIN_PX = 50;
const FONT = "12px system-ui, sans-serif";

/** An axis of uPlot in the colours of the page, with more options. */
export function axis(options) {
  const grid = { stroke: () => colours().line, width: 1 };
  return { stroke: () => colours().quiet, grid, ticks: grid, font: FONT, ...options };
}

const sizeOf = (box) => ({ width: Math.max(MIN_PX, box.clientWidth), height: Math.max(MIN_PX, box.clientHeight) });

/** A plot of uPlot without its own legend and cursor, as large as its box. */
export class Plot {
  /** @type {uPlot} */ #plot;
  #box;

  /** @param {HTMLElement} box of fixed height @param {object} options of uPlot @param {number[][]} data */
  constructor(box, options, data) {
    this.#box = box;
    this.#plot = new uPlot({ ...sizeOf(box), legend: { show: false }, cursor: { show: false }, ...options }, data, box);
    onRepaint(() => this.fit());
  }

  /** @param {number[][]} data */
  setData(data) {
    this.#plot.setData(data);
  }

  /** Takes the size and the colours of the page, if the plot is visible. */
  fit() {
    if (this.#box.clientWidth > 0) this.#plot.setSize(sizeOf(this.#box));
  }
}
