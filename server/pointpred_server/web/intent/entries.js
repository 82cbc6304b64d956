// The registered elements: what is registered for each, and where it is.

import { CENTRE_X, CENTRE_Y, FIELDS, HEIGHT, WIDTH } from "../laws/targets/rectangles.js";

const COVERED_MS = 250; // how long an answer of the hit test is used

/** A registered element. */
export class Entry {
  /** Its place as a row of the targets' table: centre and size px with the slop, logarithm of its weight. */ row = new Float64Array(FIELDS);
  /** Whether nothing of it can be seen. */ isHidden = true;
  /** @type {Set<import("./registration.js").Registration>} */ registrations = new Set();
  #slop = [0, 0, 0, 0]; #coveredAt = -Infinity; #covered = false;

  /** @param {Element} element */
  constructor(element) {
    this.element = element;
  }

  /** Takes the largest weight and slop of its registrations, and for each policy the lowest threshold. */
  update() {
    const options = [...this.registrations].map((one) => one.options);
    const lowest = (policy) => Math.min(...[...this.registrations].filter((one) => one.follows(policy)).map((one) => one.options.threshold));
    this.weight = Math.max(0, ...options.map(({ priority }) => priority));
    [this.prefetchFrom, this.highlightFrom] = [lowest("prefetch"), lowest("highlight")];
    this.#slop = ["top", "right", "bottom", "left"].map((side) => Math.max(0, ...options.map(({ hitSlop }) => hitSlop[side])));
  }

  /** Measures it. @param {DOMRectReadOnly} [box] if its rectangle is known already @returns {boolean} whether it was hidden before and is not now, or the reverse */
  measure(box = this.element.getBoundingClientRect()) {
    const { left, top, width, height } = box, [up, right, down, back] = this.#slop, { row, isHidden } = this;
    const options = { visibilityProperty: true, opacityProperty: true, contentVisibilityAuto: true };
    this.isHidden = !(width > 0 && height > 0 && this.weight > 0 && (this.element.checkVisibility?.(options) ?? true));
    row[CENTRE_X] = this.isHidden ? NaN : left + 0.5 * (width + right - back); // not a number is inside nothing
    row[CENTRE_Y] = top + 0.5 * (height + down - up);
    row[WIDTH] = width + right + back;
    row[HEIGHT] = height + up + down;
    return isHidden !== this.isHidden;
  }

  /** Whether something else, such as a dialog, lies over its middle. */
  get isCovered() {
    if (performance.now() - this.#coveredAt < COVERED_MS) return this.#covered;
    const { left, top, right, bottom } = this.element.getBoundingClientRect();
    const middle = (low, high, most) => 0.5 * (Math.max(low, 0) + Math.min(high, most));
    const root = this.element.getRootNode();
    const hit = root.elementFromPoint?.(middle(left, right, innerWidth), middle(top, bottom, innerHeight)) ?? null;
    this.#coveredAt = performance.now();
    this.#covered = hit !== null && !this.element.contains(hit) && !hit.contains(this.element);
    return this.#covered;
  }
}
