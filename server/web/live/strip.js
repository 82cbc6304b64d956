// The strip of speed: the last seconds of the pointer's speed, with the phases of the prediction behind it.

import { inks, onRepaint } from "../drawing/canvas.js";
import uPlot from "../vendor/uPlot.esm.js";

const WINDOW_S = 5;
const LOWEST_TOP = 1000; // px/s
const STEP = 500; // px/s: the scale moves in steps, not all the time

/** Stretches of equal phase among samples [at, phase]: [phase, from, to] in order, times in the samples' unit. */
export function stretches(samples) {
  const found = [];
  samples.forEach(([at, phase], i) => {
    const last = found[found.length - 1];
    const until = samples[i + 1]?.[0] ?? at;
    if (last !== undefined && last[0] === phase) last[2] = until;
    else found.push([phase, at, until]);
  });
  return found.filter(([phase, from, to]) => phase !== null && phase !== "still" && to > from);
}

/** A rolling plot; times are ms of the page's clock. */
export class Strip {
  #samples = []; // [at ms, px/s, phase]
  #plot; #now = 0; #box;

  /** @param {HTMLElement} box of fixed height */
  constructor(box) {
    this.#box = box;
    const quiet = () => inks().quiet;
    const grid = { stroke: () => inks().line, width: 1 };
    const font = "12px system-ui, sans-serif";
    const x = { stroke: quiet, grid, ticks: grid, font, values: (_, marks) => marks.map((mark) => (mark === 0 ? "now" : `${mark} s`)), incrs: [1], size: 26 };
    const y = { stroke: quiet, grid, ticks: grid, font, size: 62, space: 28 };
    const options = {
      ...this.#size(),
      legend: { show: false },
      cursor: { show: false },
      padding: [10, 20, 0, 0],
      scales: { x: { time: false, range: () => [-WINDOW_S, 0] }, y: { range: () => [0, this.#top()] } },
      axes: [x, y],
      series: [{}, { stroke: () => inks().past, width: 2, points: { show: false } }],
      hooks: { drawClear: [(plot) => this.#mark(plot)] },
    };
    this.#plot = new uPlot(options, [[], []], box);
    onRepaint(() => this.fit());
  }

  /** One sample of the speed, px/s, and the phase then. */
  add(at, speed, phase) {
    this.#samples.push([at, speed, phase]);
    let old = 0;
    while (old < this.#samples.length && this.#samples[old][0] < at - 1000 * WINDOW_S - 100) old += 1;
    this.#samples.splice(0, old);
  }

  /** Draws the strip as it stands at `now`. */
  draw(now) {
    this.#now = now;
    this.#plot.setData([this.#samples.map(([at]) => (at - now) / 1000), this.#samples.map(([, speed]) => speed)]);
  }

  /** Takes the size and the colours of the page. */
  fit() {
    if (this.#box.clientWidth > 0) this.#plot.setSize(this.#size());
  }

  #size() {
    return { width: Math.max(50, this.#box.clientWidth), height: Math.max(50, this.#box.clientHeight) };
  }

  #top() {
    const most = this.#samples.reduce((top, [, speed]) => Math.max(top, speed), 0);
    return Math.max(LOWEST_TOP, STEP * Math.ceil((1.1 * most) / STEP));
  }

  #mark(plot) {
    const { left, top, width, height } = plot.bbox;
    const pen = plot.ctx;
    const bar = 7 * (window.devicePixelRatio || 1);
    pen.save();
    pen.beginPath();
    pen.rect(left, top, width, height);
    pen.clip();
    for (const [phase, from, to] of stretches(this.#samples.map(([at, , phase]) => [at, phase]))) {
      const begin = plot.valToPos((from - this.#now) / 1000, "x", true);
      const end = plot.valToPos((to - this.#now) / 1000, "x", true);
      drawPhase(pen, phase, begin, end, top, height, bar);
    }
    pen.restore();
  }
}

/** A stretch of a phase: tinted, under a bar that is solid where it is ballistic and hatched where it is corrective. */
export function drawPhase(pen, phase, begin, end, top, height, bar) {
  pen.fillStyle = pen.strokeStyle = inks()[phase];
  pen.globalAlpha = 0.14;
  pen.fillRect(begin, top, end - begin, height);
  pen.globalAlpha = 1;
  if (phase === "ballistic") pen.fillRect(begin, top, end - begin, bar);
  else hatch(pen, begin, end, top, bar);
}

function hatch(pen, begin, end, top, bar) {
  pen.lineWidth = bar / 4;
  pen.beginPath();
  for (let x = begin; x < end; x += bar * 0.7) {
    pen.moveTo(x, top + bar);
    pen.lineTo(Math.min(end, x + bar), top);
  }
  pen.stroke();
}
