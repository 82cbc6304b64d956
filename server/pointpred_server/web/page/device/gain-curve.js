// The gain curve of the system's transfer function: measured gains, the identified curve, and the speeds that were used.

import { colours } from "../drawing/canvas.js";
import { axis, Plot } from "../drawing/plot.js";

const LOWEST_TOP = 2;

const series = (label, colour, dash, width, points) => ({
  label,
  stroke: () => colours()[colour],
  dash,
  width,
  points: { show: false, ...points },
  spanGaps: true,
});

/** A plot of the gain against the hand's speed, in a box of fixed height. */
export class GainCurve {
  #box;
  #plot;
  /** @type {number[]|null} */ #excited = null;

  /** @param {HTMLElement} box */
  constructor(box) {
    this.#box = box;
    const quiet = () => colours().quiet;
    this.#plot = new Plot(
      box,
      {
        padding: [10, 16, 0, 0],
        scales: {
          x: { time: false, range: (_, _low, high) => [0, high > 0 ? 1.08 * high : 0.3] },
          y: { range: (_, _low, high) => [0, 1.1 * Math.max(LOWEST_TOP, high ?? 0)] },
        },
        axes: [axis({ size: 30, values: (_, marks) => marks.map((mark) => `${mark}`) }), axis({ size: 40 })],
        series: [
          {},
          series("measured", "quiet", [], 0, { show: true, size: 6, stroke: quiet, fill: quiet }),
          series("constant", "none", [2, 4], 2),
          series("sigmoid", "second", [8, 4], 2),
          series("polynomial", "endpoint", [], 2.5),
        ],
        hooks: { drawClear: [(plot) => this.#shadeExcited(plot)] },
      },
      [[], [], [], [], []],
    );
  }

  /**
   * @param {{speeds: number[], gains: number[], excited: number[]|null, measured_speeds: number[], measured_gains: number[],
   *   compared: {kind: string, gains: number[]}[]}} curve
   */
  show({ speeds, gains, excited, measured_speeds: measuredSpeeds, measured_gains: measuredGains, compared }) {
    this.#excited = excited;
    const gainsOf = (kind) => compared.find((one) => one.kind === kind)?.gains ?? [];
    const all = [...new Set([...speeds, ...measuredSpeeds])].sort((a, b) => a - b);
    const onAll = (xs, ys) => {
      const byX = new Map(xs.map((x, i) => [x, ys[i]]));
      return all.map((x) => byX.get(x) ?? null);
    };
    this.#plot.setData([
      all,
      onAll(measuredSpeeds, measuredGains),
      onAll(speeds, gainsOf("constant")),
      onAll(speeds, gainsOf("sigmoid")),
      onAll(speeds, gains),
    ]);
    this.#box.dataset.points = String(speeds.length);
  }

  fit() {
    this.#plot.fit();
  }

  /** Shades the range of speeds that were used. @param {import("../vendor/uPlot.esm.js").default} plot */
  #shadeExcited(plot) {
    if (this.#excited === null) return;
    const { top, height } = plot.bbox;
    const [from, to] = this.#excited.map((speed) => plot.valToPos(speed, "x", true));
    const pen = plot.ctx;
    pen.save();
    pen.fillStyle = colours().past;
    pen.globalAlpha = 0.1;
    pen.fillRect(from, top, to - from, height);
    pen.restore();
  }
}
