// The regions of a prediction as the page draws them: that of 50 % tinted, that of 80 % as a thin outline. A mixture of targets,
// places and elsewhere has the outlines of its own densest places, any other law an ellipse.

import { regionOf } from "../../lib/pointpred.js";
import { colours } from "./canvas.js";

const EASE_MS = 120;
const MOST_PER_MS = 0.006; // change of an axis' logarithm: a factor of 1.8 in 100 ms
const FILL = 0.16;
const TINT_RANGE = [0.35, 0.65]; // lengths of a region, as shares of the picture's diagonal: a region that covers the picture is not tinted
const OUTLINE_RANGE = { inner: [0.7, 1], outer: [1, 1.6] };

/**
 * @typedef {{x: number, y: number, major: number, minor: number, angle: number}} Region half axes in px, angle in radians
 * @typedef {{inner: Region, outer: Region}} Regions of 50 % and of 80 %
 * @typedef {Pick<import("../../lib/index.d.ts").Prediction, "x"|"y"|"region">} Predicted
 */

/** The regions of a prediction; null if it claims none. @param {Predicted|null|undefined} prediction @returns {Regions|null} */
export function regionsOf(prediction) {
  if (prediction == null || prediction.x === null || !prediction.region) return null;
  const [inner, outer] = [0.5, 0.8].map((level) => regionOf(prediction, level));
  return inner !== null && outer !== null && inner.minor > 0 ? { inner, outer } : null;
}

const LIKELY = 0.03; // a part that is less likely is drawn as elsewhere
const POINTS = 200; // a probability that is drawn may be off by 1 %

const outlined = new WeakMap(); // by mixture: a prediction is drawn in several frames

/**
 * The outlines of both regions of a mixture, inner and outer.
 * @param {import("../../lib/prediction/mixture.js").Mixture|null|undefined} mixture @returns {[number, number][][][]|null} null without one
 */
export function outlinesOf(mixture) {
  if (!mixture) return null;
  if (!outlined.has(mixture))
    outlined.set(
      mixture,
      [0.5, 0.8].map((level) => mixture.likely(LIKELY).outlines(level, POINTS)),
    );
  return outlined.get(mixture);
}

/** The regions as they appear in a picture. @param {Regions|null} regions @param {number} scale @param {(point: import("./marks.js").Point) => import("./marks.js").Point} place */
export function projectRegions(regions, scale, place) {
  const project = ({ x, y, major, minor, angle }) => {
    const [left, top] = place([x, y]);
    return { x: left, y: top, major: scale * major, minor: scale * minor, angle };
  };
  return regions && { inner: project(regions.inner), outer: project(regions.outer) };
}

/** Smooths the regions of one predictor over time, on a logarithmic scale, so that their size does not flicker. */
export class SmoothRegions {
  /** @type {ReturnType<typeof encode>|null} */ #state = null;
  #at = 0;

  /**
   * The regions to draw now. @param {Predicted|null} prediction @param {number} now ms
   * @param {boolean} still without a transition @returns {Regions|null}
   */
  update(prediction, now, still = false) {
    const target = regionsOf(prediction);
    if (target === null) this.#state = null;
    else if (this.#state === null || still) this.#state = encode(target);
    else this.#state = approach(this.#state, encode(target), now - this.#at);
    this.#at = now;
    return this.#state === null || target === null ? null : decode(this.#state, target.inner);
  }
}

/** The logarithms of the axes, and the doubled angle as a vector: half a turn leaves an ellipse the same. */
function encode({ inner, outer }) {
  const logs = [inner.major, inner.minor, outer.major, outer.minor].map(Math.log);
  return { logs, cos: Math.cos(2 * inner.angle), sin: Math.sin(2 * inner.angle) };
}

function approach(from, to, ms) {
  const share = 1 - Math.exp(-ms / EASE_MS),
    most = MOST_PER_MS * ms;
  const logs = from.logs.map((value, i) => value + Math.max(-most, Math.min(most, share * (to.logs[i] - value))));
  return { logs, cos: from.cos + share * (to.cos - from.cos), sin: from.sin + share * (to.sin - from.sin) };
}

function decode({ logs, cos, sin }, { x, y }) {
  const [a, b, c, d] = logs.map(Math.exp),
    angle = Math.atan2(sin, cos) / 2;
  return { inner: { x, y, major: a, minor: b, angle }, outer: { x, y, major: c, minor: d, angle } };
}

/** The opacity of a part of a region: full up to a share of the picture's diagonal, none beyond another. @param {Region} region @param {number} width @param {number} height @param {number[]} range */
function opacityOf({ major }, width, height, [full, none]) {
  const length = (2 * major) / Math.hypot(width, height);
  return Math.max(0, Math.min(1, (none - length) / (none - full)));
}

/** Whether the 50 % region is visible in a picture of this size. @param {Regions|null} regions */
export const isVisible = (regions, width, height) =>
  regions !== null && opacityOf(regions.inner, width, height, OUTLINE_RANGE.inner) > 0;

/** Adds a closed polygon to the path. */
function trace(pen, polygon) {
  polygon.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
  pen.closePath();
}

/**
 * Draws the regions of a predictor.
 * @param {import("./marks.js").Pen} pen @param {Regions|null} regions @param {import("./marks.js").Mark} mark of the predictor
 * @param {number} width @param {number} height of the picture, px @param {number} opacity 0 to 1
 * @param {[number, number][][][]|null} [outlines] drawn instead of the ellipses, inner and outer
 */
export function drawRegions(pen, regions, { colour, outline }, width, height, opacity = 1, outlines = null) {
  if (regions === null) return;
  const { inner, outer } = regions;
  pen.save();
  pen.strokeStyle = pen.fillStyle = colours()[colour];
  pen.setLineDash(outline);
  const [within, around] = outlines ?? [];
  for (const [
    region,
    polygons,
    outlineRange,
    fill,
    thickness,
  ] of /** @type {[Region, number[][][]|undefined, number[], number, number][]} */ ([
    [outer, around, OUTLINE_RANGE.outer, 0, 1],
    [inner, within, OUTLINE_RANGE.inner, FILL, 1.5],
  ])) {
    pen.beginPath();
    if (polygons === undefined)
      pen.ellipse(region.x, region.y, region.major, region.minor, region.angle, 0, 2 * Math.PI);
    else for (const polygon of polygons) trace(pen, polygon);
    pen.globalAlpha = fill * opacity * opacityOf(region, width, height, TINT_RANGE);
    pen.fill();
    pen.globalAlpha = opacity * opacityOf(region, width, height, outlineRange);
    pen.lineWidth = thickness;
    pen.stroke();
  }
  pen.restore();
}
