// What part of an endless plane is shown: the trail of a device that no window bounds, without a screen.

const LEAST_PX = 240; // a twitch does not fill the picture
const ROOM = 1.25; // and nothing touches its edge
const STEP = Math.SQRT2; // the scale moves in steps, not all the time

/** Follows points [x, y] so that they fit into a picture; lengths of the plane are px at scale 1. */
export class Camera {
  scale = 1;
  #middle = [0, 0];

  /** Looks so that the points are seen; where they already are, nothing moves. */
  follow(points, width, height) {
    if (points.length === 0) return;
    const [left, right] = ends(points.map(([x]) => x));
    const [top, bottom] = ends(points.map(([, y]) => y));
    const wanted = Math.min(1, width / Math.max(LEAST_PX, ROOM * (right - left)), height / Math.max(LEAST_PX, ROOM * (bottom - top)));
    if (wanted < this.scale || wanted > this.scale * STEP * STEP) this.scale = Math.min(1, STEP ** Math.floor(Math.log(wanted) / Math.log(STEP) + 1e-9));
    const seen = ([x, y], share) => Math.abs(x - this.#middle[0]) * this.scale < (share * width) / 2 && Math.abs(y - this.#middle[1]) * this.scale < (share * height) / 2;
    if (!seen([left, top], 0.95) || !seen([right, bottom], 0.95)) this.#middle = [(left + right) / 2, (top + bottom) / 2];
    this.width = width;
    this.height = height;
  }

  /** Where a point of the plane stands in the picture. */
  place([x, y]) {
    return [(x - this.#middle[0]) * this.scale + this.width / 2, (y - this.#middle[1]) * this.scale + this.height / 2];
  }

  /** What is drawn of a prediction as it stands in the picture. @param {import("../live/picture.js").Mark} mark */
  view({ prediction, regions, opacity }) {
    const [x, y] = this.place([prediction.x, prediction.y]);
    const scaled = (one) => ({ x, y, major: this.scale * one.major, minor: this.scale * one.minor, angle: one.angle });
    const seen = regions && { inner: scaled(regions.inner), outer: scaled(regions.outer) };
    return { prediction: { ...prediction, x, y }, regions: seen, opacity };
  }
}

function ends(values) {
  return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
}
