// What a scroll is about to bring under the pointer that rests, or into view.

const AHEAD_S = 0.15; // how long the present speed is taken to last
const SLOWEST = 50; // px/s; slower, nothing is about to come
const MARGIN = "25%"; // of the viewport: so near, an element is about to come into view

/** Speeds of the elements in view, from where they were a frame ago. */
export class ScrollAhead {
  #at = -Infinity;
  #places = new Map();
  #contact;

  /** @param {typeof import("../laws/targets/prefetch.js").contact} contact the law: loaded with what is there already */
  constructor(contact) {
    this.#contact = contact;
  }

  /**
   * The elements that their present speed brings under the pointer. A container that scrolls inside the page counts as the page does.
   * @param {import("./entry.js").Entry[]} entries measured in this frame @param {{x: number, y: number}} pointer px
   * @param {number} t s
   * @returns {import("./entry.js").Entry[]}
   */
  comingUnder(entries, { x, y }, t) {
    const dt = t - this.#at,
      before = this.#places;
    [this.#at, this.#places] = [t, new Map(entries.map((entry) => [entry, [entry.row[0], entry.row[1]]]))];
    if (!(dt > 0 && dt < AHEAD_S)) return [];
    return entries.filter((entry) => {
      const place = before.get(entry),
        [centreX, centreY] = entry.row;
      if (!place || entry.isHidden) return false;
      const vx = (centreX - place[0]) / dt,
        vy = (centreY - place[1]) / dt;
      return Math.hypot(vx, vy) >= SLOWEST && this.#contact(x, y, -vx, -vy, entry.row) <= AHEAD_S; // as the element sees the pointer come
    });
  }
}

/** Reports elements that come near the viewport, from the first scroll on: what is in view before has not come. */
export class NearView {
  #waiting = new Set();
  /** @type {IntersectionObserver|null} */ #observer = null;
  #seen = new WeakSet();

  /** @param {(element: Element) => void} onNear @param {Set<Element>} inView @param {AbortSignal} signal */
  constructor(onNear, inView, signal) {
    window.addEventListener("scroll", () => this.#begin(onNear, inView, signal), {
      signal,
      capture: true,
      passive: true,
      once: true,
    });
  }

  /** @param {Element} element */
  observe(element) {
    if (!this.#observer) return void this.#waiting.add(element);
    const { top, bottom } = element.getBoundingClientRect();
    if (bottom > 0 && top < innerHeight) this.#seen.add(element);
    this.#observer.observe(element);
  }

  #begin(onNear, inView, signal) {
    this.#observer = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries)
          if (!isIntersecting) this.#seen.delete(target);
          else if (!this.#seen.has(target)) onNear(target);
      },
      { rootMargin: MARGIN },
    );
    signal.addEventListener("abort", () => this.#observer?.disconnect());
    for (const element of this.#waiting) {
      if (inView.has(element)) this.#seen.add(element);
      this.#observer.observe(element);
    }
    this.#waiting.clear();
  }
}
