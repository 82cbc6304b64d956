// Which part of the plane is shown: an attached device has no window that bounds its positions.

import { projectRegions } from "../drawing/regions.js";
import { bounds } from "../shell/numbers.js";

const MIN_PX = 240; // a small movement does not fill the picture
const ROOM = 1.25; // nothing touches the edge of the picture
const STEP = Math.SQRT2; // the scale changes in steps

/** Follows points [x, y] so that they fit into a picture; lengths of the plane are px at scale 1. */
export class Camera {
  scale = 1;
  #centre = [0, 0];

  /** Moves the camera if the points are not in the picture. */
  follow(points, width, height) {
    if (points.length === 0) return;
    const [left, right] = bounds(points.map(([x]) => x));
    const [top, bottom] = bounds(points.map(([, y]) => y));
    const fitting = Math.min(
      1,
      width / Math.max(MIN_PX, ROOM * (right - left)),
      height / Math.max(MIN_PX, ROOM * (bottom - top)),
    );
    if (fitting < this.scale || fitting > this.scale * STEP * STEP)
      this.scale = Math.min(1, STEP ** Math.floor(Math.log(fitting) / Math.log(STEP) + 1e-9));
    /** @param {import("../drawing/marks.js").Point} corner @param {number} share */
    const inPicture = ([x, y], share) =>
      Math.abs(x - this.#centre[0]) * this.scale < (share * width) / 2 &&
      Math.abs(y - this.#centre[1]) * this.scale < (share * height) / 2;
    if (!inPicture([left, top], 0.95) || !inPicture([right, bottom], 0.95))
      this.#centre = [(left + right) / 2, (top + bottom) / 2];
    /** @type {number} */ this.width = width;
    /** @type {number} */ this.height = height;
  }

  /** A point of the plane in px of the picture. @param {import("../drawing/marks.js").Point} point */
  place([x, y]) {
    return [(x - this.#centre[0]) * this.scale + this.width / 2, (y - this.#centre[1]) * this.scale + this.height / 2];
  }

  /** A mark of the plane as it appears in the picture. @param {import("../live/picture.js").Mark} mark @returns {import("../live/picture.js").Mark} */
  project({ prediction, regions, opacity }) {
    const [x, y] = this.place([prediction.x, prediction.y]);
    return {
      prediction: { ...prediction, x, y },
      regions: projectRegions(regions, this.scale, (point) => this.place(point)),
      opacity,
    };
  }
}
