// The regions of a prediction as the page draws them: the 50 % ellipse tinted, the 80 % ellipse a thin outline.

import { regionOf } from "/pointpred.js";

const EASE_MS = 120;
const MOST_PER_MS = 0.006; // change of an axis' logarithm: a factor of 1.8 in 100 ms
const FILL = 0.16;
const TINTED = [0.35, 0.65]; // lengths of a region, as shares of the picture's diagonal: a tinted picture says nothing
const OUTLINED = { inner: [0.7, 1], outer: [1, 1.6] };

/**
 * @typedef {{x: number, y: number, major: number, minor: number, angle: number}} Region half axes in px, angle in radians
 * @typedef {{inner: Region, outer: Region}} Regions of 50 % and of 80 %
 */

/** The regions of a prediction; null where it claims none. @returns {Regions|null} */
export function regionsOf(prediction) {
  if (prediction == null || prediction.x === null || !prediction.region) return null;
  const [inner, outer] = [0.5, 0.8].map((level) => regionOf(prediction, level));
  return inner !== null && outer !== null && inner.minor > 0 ? { inner, outer } : null;
}

/** Follows the regions of one predictor so that their size never flashes: it glides, on a logarithmic scale. */
export class CalmRegions {
  #state = null; #at = 0;

  /**
   * The regions to draw now. @param {object|null} prediction @param {number} now ms
   * @param {boolean} still at once as large as they are @returns {Regions|null}
   */
  follow(prediction, now, still = false) {
    const wanted = regionsOf(prediction);
    if (wanted === null) this.#state = null;
    else if (this.#state === null || still) this.#state = stateOf(wanted);
    else this.#state = glide(this.#state, stateOf(wanted), now - this.#at);
    this.#at = now;
    return this.#state === null ? null : placed(this.#state, prediction);
  }
}

/** Logarithms of the axes, and the angle doubled as a vector: half a turn is no turn of an ellipse. */
function stateOf({ inner, outer }) {
  const logs = [inner.major, inner.minor, outer.major, outer.minor].map(Math.log);
  return { logs, cos: Math.cos(2 * inner.angle), sin: Math.sin(2 * inner.angle) };
}

function glide(from, to, ms) {
  const share = 1 - Math.exp(-ms / EASE_MS), most = MOST_PER_MS * ms;
  const logs = from.logs.map((value, i) => value + Math.max(-most, Math.min(most, share * (to.logs[i] - value))));
  return { logs, cos: from.cos + share * (to.cos - from.cos), sin: from.sin + share * (to.sin - from.sin) };
}

function placed({ logs, cos, sin }, { x, y }) {
  const [a, b, c, d] = logs.map(Math.exp), angle = Math.atan2(sin, cos) / 2;
  return { inner: { x, y, major: a, minor: b, angle }, outer: { x, y, major: c, minor: d, angle } };
}

/** How strongly something is drawn of a region: fully up to a share of the picture's diagonal, not at all beyond another. */
function strength({ major }, width, height, [full, none]) {
  const length = (2 * major) / Math.hypot(width, height);
  return Math.max(0, Math.min(1, (none - length) / (none - full)));
}

/** Whether the 50 % region is drawn in a picture so wide and high. @param {Regions|null} regions */
export const shown = (regions, width, height) => regions !== null && strength(regions.inner, width, height, OUTLINED.inner) > 0;

/**
 * Draws regions, within the canvas as everything on it is.
 * @param {Regions} regions @param {string} colour @param {number[]} dash of the outlines @param {number} opacity 0 to 1
 */
export function drawRegions(pen, { inner, outer }, colour, dash, width, height, opacity = 1) {
  pen.save();
  pen.strokeStyle = pen.fillStyle = colour;
  pen.setLineDash(dash);
  for (const [region, outlined, fill, thick] of [[outer, OUTLINED.outer, 0, 1], [inner, OUTLINED.inner, FILL, 1.5]]) {
    pen.beginPath();
    pen.ellipse(region.x, region.y, region.major, region.minor, region.angle, 0, 2 * Math.PI);
    pen.globalAlpha = fill * opacity * strength(region, width, height, TINTED);
    pen.fill();
    pen.globalAlpha = opacity * strength(region, width, height, outlined);
    pen.lineWidth = thick;
    pen.stroke();
  }
  pen.restore();
}
