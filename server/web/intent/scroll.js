// What a scroll is about to bring under the pointer that rests, or into view.

const AHEAD_S = 0.15; // how long the present speed is taken to last
const SLOWEST = 50; // px/s; slower, nothing is about to come
const MARGIN = "25%"; // of the viewport: so near, an element is about to come into view

/** Speeds of the elements in view, from where they were a frame ago. */
export class ScrollAhead {
  #at = -Infinity; #places = new Map();

  /**
   * The elements that their present speed brings under the pointer. A container that scrolls inside the page counts as the page does.
   * @param {import("./entries.js").Entry[]} entries measured in this frame @param {{x: number, y: number}} pointer px
   * @param {number} t s
   * @returns {import("./entries.js").Entry[]}
   */
  comingUnder(entries, { x, y }, t) {
    const dt = t - this.#at, before = this.#places;
    [this.#at, this.#places] = [t, new Map(entries.map((entry) => [entry, [entry.row[0], entry.row[1]]]))];
    if (!(dt > 0 && dt < AHEAD_S)) return [];
    return entries.filter((entry) => {
      const place = before.get(entry), [centreX, centreY, width, height] = entry.row;
      if (!place || entry.isHidden) return false;
      const vx = (centreX - place[0]) / dt, vy = (centreY - place[1]) / dt;
      return Math.hypot(vx, vy) >= SLOWEST && meets(centreX - x, centreY - y, vx * AHEAD_S, vy * AHEAD_S, 0.5 * width, 0.5 * height);
    });
  }
}

/** Whether a rectangle with its centre at (x, y) meets the origin on its way by (dx, dy). */
function meets(x, y, dx, dy, halfWidth, halfHeight) {
  let first = 0, last = 1;
  for (const [from, way, half] of [[x, dx, halfWidth], [y, dy, halfHeight]]) {
    if (way === 0 && Math.abs(from) > half) return false;
    if (way === 0) continue;
    const [one, other] = [(-half - from) / way, (half - from) / way];
    [first, last] = [Math.max(first, Math.min(one, other)), Math.min(last, Math.max(one, other))];
  }
  return first <= last;
}

/** Reports elements that come near the viewport, from the first scroll on: what is near it when the page is opened is not meant. */
export class NearView {
  #waiting = new Set(); #observer = null;

  /** @param {(element: Element) => void} onNear @param {AbortSignal} signal */
  constructor(onNear, signal) {
    window.addEventListener("scroll", () => this.#begin(onNear, signal), { signal, capture: true, passive: true, once: true });
  }

  /** @param {Element} element */
  observe(element) {
    if (this.#observer) this.#observer.observe(element);
    else this.#waiting.add(element);
  }

  #begin(onNear, signal) {
    this.#observer = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) if (isIntersecting) onNear(target);
    }, { rootMargin: MARGIN });
    signal.addEventListener("abort", () => this.#observer.disconnect());
    for (const element of this.#waiting) this.#observer.observe(element);
    this.#waiting.clear();
  }
}
