// The gain curve of the system's transfer function: what was measured, what it was identified as, and how far that reaches.

import { inks, onRepaint } from "../drawing/canvas.js";
import uPlot from "../vendor/uPlot.esm.js";

const LEAST_TOP = 2;

/** A plot of gains over the hand's speed, in a box of fixed height. */
export class GainCurve {
  #box; #plot; #range = null;

  /** @param {HTMLElement} box */
  constructor(box) {
    this.#box = box;
    const quiet = () => inks().quiet;
    const grid = { stroke: () => inks().line, width: 1 };
    const axis = { stroke: quiet, grid, ticks: grid, font: "12px system-ui, sans-serif" };
    const series = (label, colour, dash, width, points) => ({ label, stroke: () => inks()[colour], dash, width, points: { show: false, ...points }, spanGaps: true });
    const options = {
      ...this.#size(),
      legend: { show: false },
      cursor: { show: false },
      padding: [10, 16, 0, 0],
      scales: { x: { time: false, range: (_, low, high) => [0, high > 0 ? 1.08 * high : 0.3] }, y: { range: (_, low, high) => [0, 1.1 * Math.max(LEAST_TOP, high ?? 0)] } },
      axes: [{ ...axis, size: 30, values: (_, marks) => marks.map((mark) => `${mark}`) }, { ...axis, size: 40 }],
      series: [{},
        series("measured", "quiet", [], 0, { show: true, size: 6, stroke: quiet, fill: quiet }),
        series("constant", "none", [2, 4], 2), series("sigmoid", "second", [8, 4], 2), series("polynomial", "endpoint", [], 2.5)],
      hooks: { drawClear: [(plot) => this.#shade(plot)] },
    };
    this.#plot = new uPlot(options, [[], [], [], [], []], box);
    onRepaint(() => this.fit());
  }

  /** @param {{speeds: number[], gains: number[], excited: number[]|null, measured_speeds: number[], measured_gains: number[], compared: object[]}} curve */
  show({ speeds, gains, excited, measured_speeds: speedsSeen, measured_gains: gainsSeen, compared }) {
    this.#range = excited;
    const other = (kind) => compared.find((one) => one.kind === kind)?.gains ?? [];
    const all = [...new Set([...speeds, ...speedsSeen])].sort((a, b) => a - b);
    const at = (xs, ys) => {
      const known = new Map(xs.map((x, i) => [x, ys[i]]));
      return all.map((x) => known.get(x) ?? null);
    };
    this.#plot.setData([all, at(speedsSeen, gainsSeen), at(speeds, other("constant")), at(speeds, other("sigmoid")), at(speeds, gains)]);
    this.#box.dataset.points = speeds.length;
  }

  /** Takes the size and the colours of the page. */
  fit() {
    if (this.#box.clientWidth > 0) this.#plot.setSize(this.#size());
  }

  #size() {
    return { width: Math.max(50, this.#box.clientWidth), height: Math.max(50, this.#box.clientHeight) };
  }

  /** The range of speeds that were seen. */
  #shade(plot) {
    if (this.#range === null) return;
    const { top, height } = plot.bbox;
    const [from, to] = this.#range.map((speed) => plot.valToPos(speed, "x", true));
    const pen = plot.ctx;
    pen.save();
    pen.fillStyle = inks().past;
    pen.globalAlpha = 0.1;
    pen.fillRect(from, top, to - from, height);
    pen.restore();
  }
}
