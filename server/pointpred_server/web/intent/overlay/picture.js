// The rectangles, the shares and the prediction, drawn over the page.

import { regionOf } from "../../client/regions.js";
import { regionIn } from "../../prediction/row.js";

const LEVELS = [0.5, 0.9]; // of the regions
const SHOWN = 0.01; // shares from here on are written
const ROLES = ["idle", "fired", "lit", "ahead", "paper"]; // of colours
const NOTED_MS = 1500; // how long a reason stays beside its element

/** A canvas over the viewport. */
export class Picture {
  canvas = document.createElement("canvas");
  /** Carry the colours. */ samples = ROLES.map((className) => Object.assign(document.createElement("i"), { className }));
  #context = this.canvas.getContext("2d"); #notes = new Map();

  /** Writes a reason beside an element for a while. @param {import("../../index.d.ts").LedgerEntry} entry */
  note({ kind, element, reason }) {
    if (kind === "fired" || kind === "withheld") this.#notes.set(element, { text: kind === "fired" ? reason : "withheld", until: performance.now() + NOTED_MS });
  }

  /** @param {object[]} views of the trackers */
  draw(views) {
    const { canvas } = this, context = this.#context, ratio = devicePixelRatio;
    const [width, height] = [Math.round(innerWidth * ratio), Math.round(innerHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, innerWidth, innerHeight);
    context.font = "600 11px system-ui, sans-serif";
    const colours = Object.fromEntries(this.samples.map((one) => [one.className, getComputedStyle(one).color]));
    for (const { elements, cursor, answer } of views) {
      for (const one of elements) if (!one.isHidden) this.#drawElement(one, colours);
      this.#drawPrediction(cursor, answer, colours.ahead);
    }
    for (const [element, { until }] of this.#notes) if (until < performance.now()) this.#notes.delete(element);
  }

  #drawElement({ element, row: [x, y, width, height], registrations, share }, colours) {
    const context = this.#context, firings = [...registrations].map(({ firing }) => firing);
    const state = firings.some((one) => one?.policy === "highlight") ? "lit" : firings.some(Boolean) ? "fired" : "idle";
    const [left, top] = [x - 0.5 * width, y - 0.5 * height];
    context.fillStyle = context.strokeStyle = colours[state];
    context.globalAlpha = 0.3 * share;
    context.fillRect(left, top, width, height);
    context.globalAlpha = 1;
    context.lineWidth = state === "idle" ? 1 : 2;
    context.setLineDash(state === "idle" ? [4, 3] : []);
    context.strokeRect(left, top, width, height);
    context.setLineDash([]);
    const note = this.#notes.get(element)?.text, written = share >= SHOWN ? `${Math.round(100 * share)} %` : "";
    if (note || written) this.#label([note, written].filter(Boolean).join("  "), left, top, colours[state], colours.paper);
  }

  #label(text, left, top, colour, paper) {
    const context = this.#context, wide = context.measureText(text).width + 8, above = Math.max(0, top - 16);
    context.fillStyle = paper;
    context.fillRect(left, above, wide, 16);
    context.fillStyle = colour;
    context.fillText(text, left + 4, above + 12);
  }

  #drawPrediction(cursor, answer, colour) {
    const [, x, y] = answer;
    if (!(x === x && cursor.t > 0)) return;
    const context = this.#context, region = regionIn(answer);
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    context.moveTo(cursor.x, cursor.y);
    context.lineTo(x, y);
    context.stroke();
    for (const level of LEVELS) {
      const ellipse = regionOf({ x, y, region }, level);
      if (!ellipse) continue;
      context.beginPath();
      context.ellipse(x, y, ellipse.major, ellipse.minor, ellipse.angle, 0, 2 * Math.PI);
      context.globalAlpha = 0.08;
      context.fill();
      context.globalAlpha = 0.6;
      context.stroke();
      context.globalAlpha = 1;
    }
    context.beginPath();
    context.arc(x, y, 4, 0, 2 * Math.PI);
    context.fill();
  }
}
