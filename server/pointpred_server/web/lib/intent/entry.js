// A registered element: where it is, and whether the pointer can be over it.

import { ARMED } from "../laws/targets/prefetch.js";
import { CENTRE_X, CENTRE_Y, FIELDS, HEIGHT, WIDTH } from "../laws/targets/rectangles.js";

const COVERED_MS = 250; // how long an answer of the hit test is used
const DISABLED = ":disabled, [inert], [inert] *, [aria-disabled=true]";
const SEEN = { visibilityProperty: true, opacityProperty: true, contentVisibilityAuto: true };

/** The middle and the length of what is seen of a side, px. */
const seen = (low, high, most) => {
  const [from, to] = [Math.max(low, 0), Math.min(high, most)];
  return [0.5 * (from + to), Math.max(to - from, 0)];
};

let entries = 0; // so far

/** A registered element. */
export class Entry {
  /** Its place as a row of the targets' table: centre and size px with the slop, logarithm of its weight. */ row =
    new Float64Array(FIELDS);
  /** Whether nothing of it can be seen. */ isHidden = true;
  /** Its state in the law of prefetches. */ fired = ARMED;
  /** The same in none of the others. */ number = (entries += 1);
  /** @type {Set<import("./registration.js").Registration>} */ registrations = new Set();
  #slop = [0, 0, 0, 0];
  #coveredAt = -Infinity;
  #covered = false;

  /** @param {Element} element */
  constructor(element) {
    this.element = element;
    /** What of it is seen: an area is in an image. */
    this.shown = element;
    /** Its rectangle, px of the viewport. @type {() => DOMRectReadOnly} */
    this.box = () => element.getBoundingClientRect();
    /** The rectangles of its lines. @type {() => Iterable<DOMRectReadOnly>} */
    this.parts = () => element.getClientRects();
    /** What does not lie over it: for an area the map. */
    this.whole = element;
  }

  /** Takes the largest weight and slop of its registrations, and for each policy the lowest threshold. */
  update() {
    const options = [...this.registrations].map((one) => one.options);
    const lowest = (policy) =>
      Math.min(...[...this.registrations].filter((one) => one.follows(policy)).map((one) => one.options.threshold));
    /** @type {number} */ this.weight = Math.max(0, ...options.map(({ priority }) => priority));
    /** @type {number} */ this.prefetchFrom = lowest("prefetch");
    /** @type {number} */ this.highlightFrom = lowest("highlight");
    this.#slop = ["top", "right", "bottom", "left"].map((side) =>
      Math.max(0, ...options.map(({ hitSlop }) => hitSlop[side])),
    );
  }

  /** What it is to the user: its name in HTML and its size, to the nearest power of two. */
  get kind() {
    const { row } = this;
    return [this.element.localName, Math.round(Math.log2(row[WIDTH])), Math.round(Math.log2(row[HEIGHT]))].join();
  }

  /** Measures it. @returns {boolean} whether it was hidden before and is not now, or the reverse */
  measure() {
    const { left, top, width, height } = this.box(),
      [up, right, down, back] = this.#slop,
      { row, isHidden } = this;
    this.isHidden = !(width > 0 && height > 0 && this.weight > 0 && (this.shown.checkVisibility?.(SEEN) ?? true));
    row[CENTRE_X] = this.isHidden ? NaN : left + 0.5 * (width + right - back); // not a number is inside nothing
    row[CENTRE_Y] = top + 0.5 * (height + down - up);
    row[WIDTH] = width + right + back;
    row[HEIGHT] = height + up + down;
    return isHidden !== this.isHidden;
  }

  /** Whether nobody can use it: it is disabled or inert, or says that it is disabled. */
  get isDisabled() {
    return this.element.matches(DISABLED);
  }

  /** Whether the pointer passes it by: it is disabled, or takes no pointer events. */
  get isUnusable() {
    return this.isDisabled || getComputedStyle(this.shown).pointerEvents === "none";
  }

  /** Whether something else, such as a dialog, lies over the middle of what is seen of it: of a wrapped link its largest part. */
  get isCovered() {
    if (performance.now() - this.#coveredAt < COVERED_MS) return this.#covered;
    let largest = 0;
    /** @type {Element|null} */ let hit = null;
    for (const { left, top, right, bottom } of this.parts()) {
      const [x, across] = seen(left, right, innerWidth),
        [y, down] = seen(top, bottom, innerHeight);
      if (across * down <= largest) continue;
      largest = across * down;
      hit = this.#hit(x, y);
    }
    this.#coveredAt = performance.now();
    this.#covered = hit !== null && hit !== this.shown && !this.whole.contains(hit) && !hit.contains(this.element);
    return this.#covered;
  }

  /** Whether the pointer at a place of its rectangle is over it, as the page's own hit test says; in the slop it is. */
  isOver(x, y) {
    if (this.isBeside(x, y)) return !this.isCovered;
    const hit = this.#hit(x, y);
    return hit === null || this.element.contains(hit);
  }

  /** Whether a place lies beyond its sides: if it is in its rectangle, then in the slop. */
  isBeside(x, y) {
    const { row } = this,
      [up, right, down, back] = this.#slop;
    const [across, below] = [x - row[CENTRE_X], y - row[CENTRE_Y]],
      [halfWidth, halfHeight] = [0.5 * row[WIDTH], 0.5 * row[HEIGHT]];
    return (
      across < back - halfWidth || across > halfWidth - right || below < up - halfHeight || below > halfHeight - down
    );
  }

  #hit(x, y) {
    return /** @type {Partial<Document>} */ (this.element.getRootNode()).elementFromPoint?.(x, y) ?? null;
  }
}
