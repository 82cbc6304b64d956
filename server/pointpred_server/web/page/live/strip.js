// The plot of speed: the pointer's speed over the last seconds, in front of the phases of the prediction.

import { colours } from "../drawing/canvas.js";
import { drawPhase } from "../drawing/marks.js";
import { axis, Plot } from "../drawing/plot.js";

const WINDOW_S = 5;
const LOWEST_TOP = 1000; // px/s
const STEP = 500; // px/s: the scale changes in steps

/** Intervals of equal phase among samples [time, phase], without `still`: [phase, from, to] in order. */
export function phaseIntervals(samples) {
  const intervals = [];
  samples.forEach(([at, phase], i) => {
    const last = intervals[intervals.length - 1];
    const end = samples[i + 1]?.[0] ?? at;
    if (last !== undefined && last[0] === phase) last[2] = end;
    else intervals.push([phase, at, end]);
  });
  return intervals.filter(([phase, from, to]) => phase !== null && phase !== "still" && to > from);
}

/** A rolling plot; times are ms of the page's clock. */
export class SpeedStrip {
  #samples = []; // [ms, px/s, phase]
  #plot;
  #now = 0;

  /** @param {HTMLElement} box of fixed height */
  constructor(box) {
    this.#plot = new Plot(
      box,
      {
        padding: [10, 20, 0, 0],
        scales: { x: { time: false, range: () => [-WINDOW_S, 0] }, y: { range: () => [0, this.#top()] } },
        axes: [
          axis({ values: (_, marks) => marks.map((mark) => (mark === 0 ? "now" : `${mark} s`)), incrs: [1], size: 26 }),
          axis({ size: 62, space: 28 }),
        ],
        series: [{}, { stroke: () => colours().past, width: 2, points: { show: false } }],
        hooks: { drawClear: [(plot) => this.#drawPhases(plot)] },
      },
      [[], []],
    );
  }

  /** Adds a sample of the speed, px/s, and the phase. */
  add(at, speed, phase) {
    this.#samples.push([at, speed, phase]);
    let old = 0;
    while (old < this.#samples.length && this.#samples[old][0] < at - 1000 * WINDOW_S - 100) old += 1;
    this.#samples.splice(0, old);
  }

  /** Draws the plot up to `now`. */
  draw(now) {
    this.#now = now;
    this.#plot.setData([this.#samples.map(([at]) => (at - now) / 1000), this.#samples.map(([, speed]) => speed)]);
  }

  fit() {
    this.#plot.fit();
  }

  #top() {
    const most = this.#samples.reduce((top, [, speed]) => Math.max(top, speed), 0);
    return Math.max(LOWEST_TOP, STEP * Math.ceil((1.1 * most) / STEP));
  }

  /** @param {import("../vendor/uPlot.esm.js").default} plot */
  #drawPhases(plot) {
    const { left, top, width, height } = plot.bbox;
    const pen = plot.ctx;
    const bar = 7 * (window.devicePixelRatio || 1);
    pen.save();
    pen.beginPath();
    pen.rect(left, top, width, height);
    pen.clip();
    for (const [phase, from, to] of phaseIntervals(this.#samples.map(([at, , phase]) => [at, phase]))) {
      const begin = plot.valToPos((from - this.#now) / 1000, "x", true);
      const end = plot.valToPos((to - this.#now) / 1000, "x", true);
      drawPhase(pen, phase, begin, end, top, height, bar);
    }
    pen.restore();
  }
}
