// A prediction as it is drawn and written: it fades when no newer one comes.

import { isVisible, outlinesOf } from "../drawing/regions.js";
import { cellsOf, write } from "../shell/elements.js";
import { number } from "../shell/numbers.js";

const GONE_MS = 200; // a prediction is drawn for this long
const FADE_MS = 80;

/** Whether a prediction says where a movement ends. @param {import("../service/predictor-connection.js").Prediction} one @returns {one is import("./picture.js").Mark["prediction"]} */
const isPlaced = (one) => one.x !== null;

/** The opacity of a prediction of this age, ms. */
export const opacityAfter = (ms) => Math.max(0, Math.min(1, (GONE_MS - ms) / FADE_MS));

/**
 * A prediction as it is drawn, if it says where a movement ends.
 * @param {import("../service/predictor-connection.js").Prediction|null} prediction @param {import("../drawing/regions.js").SmoothRegions} smoothRegions @param {number} now ms @param {number} opacity
 * @param {boolean} [still] @returns {import("./picture.js").Mark|null}
 */
export function markOf(prediction, smoothRegions, now, opacity, still = false) {
  const visible = prediction !== null && isPlaced(prediction) && prediction.phase !== "still" && opacity > 0;
  const regions = smoothRegions.update(visible ? prediction : null, now, still);
  return visible ? { prediction, regions, opacity, outlines: outlinesOf(prediction.mixture) } : null;
}

/** Length × breadth of a 50 % region, px; a region that is too large to draw is only compared with the picture. */
function sizeOf({ regions }, { clientWidth, clientHeight }, scale) {
  if (regions === null) return "none";
  const [width, height] = [clientWidth / scale, clientHeight / scale];
  if (!isVisible(regions, width, height)) return `over ${Math.floor(Math.hypot(width, height) / 100) * 100}`;
  const { major, minor } = regions.inner;
  return [major, minor].map((half) => number(Number((2 * half).toPrecision(2)))).join(" × ");
}

/** The fields that show phase, time left and region of a prediction. */
export class PredictionFields {
  #phase;
  #left;
  #region;

  /** @param {Element} container of elements with the attribute data-of */
  constructor(container) {
    ({ phase: this.#phase, left: this.#left, region: this.#region } = cellsOf(container));
  }

  /** @param {import("./picture.js").Mark|null} mark */
  writeTimes(mark) {
    write(this.#phase, mark?.prediction.phase ?? "–");
    write(this.#left, number(mark?.prediction.remaining_s, 2, "s"));
  }

  /** @param {import("./picture.js").Mark|null} mark @param {HTMLCanvasElement} canvas @param {number} scale of the picture */
  writeRegion(mark, canvas, scale = 1) {
    const inner = mark?.regions?.inner;
    this.#region.dataset.px = inner === undefined ? "" : `${2 * inner.major} ${2 * inner.minor}`;
    write(this.#region, mark === null ? "–" : sizeOf(mark, canvas, scale));
  }
}

/** Publishes what is drawn as data of the canvas. @param {HTMLCanvasElement} canvas @param {(import("./picture.js").Mark|null)[]} marks */
export function publishRegions(canvas, marks) {
  canvas.dataset.regions = JSON.stringify(marks.map((mark) => mark && { ...mark.regions, opacity: mark.opacity }));
}

/** Adds to the number of endpoints drawn, as data of the canvas. @param {HTMLCanvasElement} canvas @param {number} endpoints */
export function publishDrawn(canvas, endpoints) {
  canvas.dataset.drawn = String(Number(canvas.dataset.drawn ?? 0) + endpoints);
}
