// The law of the endpoint as a mixture: targets and places where the movement may end, and elsewhere; as `pointpred/predictors/mixture.py`.

import {
  corrected_probability as corrected,
  HEAVINESS_LEAST,
  outlines,
  POLYGONS,
  points_of as pointsOf,
  threshold_of as thresholdOf,
  VERTICES,
} from "../laws/predictors/mixture.js";

/** Numbers of a part: its share, centre px, scale matrix px^2, tail; 0: a normal law. */
export const PART = 7;

/** So many parts without numbers. @param {number} count */
export const partRows = (count) => Array.from({ length: count }, () => new Float64Array(PART));

const [SHARE, TAIL] = [0, 6];
/** @type {{vertices: Float64Array[]|null, ends: Float64Array}} */
const room = { vertices: null, ends: new Float64Array(POLYGONS) }; // for outlines, made when they are first asked for

/** One of the parts holds, each with its share; elsewhere first. */
export class Mixture {
  #rows;
  #offsets;

  /** @param {Float64Array[]} rows the parts @param {number[]} offsets how the regions of 50 and 80 % are corrected for the person */
  constructor(rows, offsets) {
    [this.#rows, this.#offsets] = [rows, offsets];
  }

  /** The parts, as Python's. @returns {{share: number, x: number, y: number, scale: number[], tail: number|null}[]} */
  get parts() {
    return this.#rows.map(([share, x, y, sxx, sxy, syy, tail]) => ({
      share,
      x,
      y,
      scale: [sxx, sxy, syy],
      tail: tail || null,
    }));
  }

  get offsets() {
    return this.#offsets;
  }

  /** This mixture, whose parts of elsewhere are those of another one. @param {Mixture|null} own */
  among(own) {
    if (own === null) return this;
    const [first, ...aimed] = this.#rows,
      total = own.#rows.reduce((sum, row) => sum + row[SHARE], 0);
    const scaled = own.#rows.map(([share, ...law]) => Float64Array.of((share * first[SHARE]) / total, ...law));
    return new Mixture([...scaled, ...aimed], this.#offsets);
  }

  /** This mixture, where parts that are less likely count for the first. @param {number} least */
  likely(least) {
    const [first, ...others] = this.#rows,
      kept = others.filter((row) => row[SHARE] >= least);
    const share = kept.reduce((rest, row) => rest - row[SHARE], 1);
    return new Mixture([Float64Array.of(Math.max(share, 0), ...first.slice(1)), ...kept], this.#offsets);
  }

  /**
   * The outlines of the smallest region that holds the endpoint with this probability: closed polygons of points [x, y] px; a hole
   * turns the other way round.
   * @param {number} level in (0, 1); a RangeError otherwise
   * @param {number} [points] of each part by which the probability is counted: as many as in Python unless given
   * @returns {[number, number][][]}
   */
  outlines(level, points = pointsOf(this.#rows.length)) {
    if (!(level > 0 && level < 1)) throw new RangeError(`level must be a probability in (0, 1), received ${level}`);
    const rows = this.#rows,
      content = corrected(level, rows[0][TAIL] || 2 / HEAVINESS_LEAST, ...this.#offsets);
    const { ends } = room,
      vertices = (room.vertices ??= Array.from({ length: VERTICES }, () => new Float64Array(2))),
      threshold = thresholdOf(rows, rows.length, content, points);
    const count = outlines(rows, rows.length, threshold, vertices, ends);
    return Array.from({ length: count }, (_, k) =>
      vertices.slice(k ? ends[k - 1] : 0, ends[k]).map(([x, y]) => /** @type {[number, number]} */ ([x, y])),
    );
  }
}
