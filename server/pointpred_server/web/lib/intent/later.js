// What a page needs only once its user scrolls or presses Tab, or if it has a map of links: loaded then.

const MOST_PRESSES = 20; // of Tab

/** The image that an area belongs to; null where there is none. @param {HTMLAreaElement} area @returns {HTMLImageElement|null} */
function imageOf(area) {
  const name = area.closest("map")?.name;
  return name ? document.querySelector(`img[usemap="#${CSS.escape(name)}"]`) : null;
}

/** The rectangle around an area, px of the viewport. @param {HTMLAreaElement} area @param {HTMLImageElement} image */
function boxOf({ shape, coords }, image) {
  const { left, top, width, height } = image.getBoundingClientRect();
  const numbers = coords.split(/[\s,;]+/).map(Number);
  const [x, y, radius] = numbers;
  if (shape === "default") return new DOMRect(left, top, width, height);
  if (shape === "circle") return new DOMRect(left + x - radius, top + y - radius, 2 * radius, 2 * radius);
  const across = numbers.filter((_, i) => i % 2 === 0),
    down = numbers.filter((_, i) => i % 2 === 1);
  const [west, north] = [Math.min(...across), Math.min(...down)];
  return new DOMRect(left + west, top + north, Math.max(...across) - west, Math.max(...down) - north);
}

const FOCUSABLE =
  "a[href], area[href], button, input, select, textarea, summary, iframe, audio[controls], video[controls], " +
  "[contenteditable]:not([contenteditable=false]), [tabindex]";
const SEEN = { visibilityProperty: true, contentVisibilityAuto: false };

/**
 * The elements that presses of Tab reach from one, in their order: first those with a positive tabindex, then the others as
 * they stand in the document. Shadow trees are not searched. Every radio button counts, although Tab reaches one of a group.
 * @param {Element|null} from the focused one @param {boolean} backwards with Shift @param {number} most presses
 * @returns {Element[]}
 */
function reached(from, backwards, most) {
  const order = [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(FOCUSABLE))].filter(
    ({ tabIndex }) => tabIndex >= 0,
  );
  const rank = ({ tabIndex }) => tabIndex || Infinity;
  if (order.some(({ tabIndex }) => tabIndex > 0))
    order.sort((one, other) => (rank(one) === rank(other) ? 0 : rank(one) - rank(other)));
  if (backwards) order.reverse();
  const found = [];
  for (let i = order.indexOf(/** @type {HTMLElement} */ (from)) + 1; i < order.length && found.length < most; i += 1)
    if (isReachable(order[i])) found.push(order[i]);
  return found;
}

const isReachable = (element) =>
  !element.matches(":disabled") && !element.closest("[inert]") && (element.checkVisibility?.(SEEN) ?? true);

const AHEAD_S = 0.15; // how long the present speed is taken to last
const SLOWEST = 50; // px/s; slower, nothing is about to come
const MARGIN = "25%"; // of the viewport: so near, an element is about to come into view

/** Speeds of the elements in view, from where they were a frame ago. */
class ScrollAhead {
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
class NearView {
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

/** What fires ahead of the keyboard and of scrolls, and areas of images. */
export class Later {
  #tracker;
  #signal;
  #ahead;
  /** @type {NearView|null} */ #near = null;

  /**
   * @param {import("./tracker.js").Tracker} tracker @param {AbortSignal} signal
   * @param {typeof import("../laws/targets/prefetch.js").contact} contact the law: loaded with what is there already
   */
  constructor(tracker, contact, signal) {
    [this.#tracker, this.#signal] = [tracker, signal];
    this.#ahead = new ScrollAhead(contact);
  }

  /** An area of an image has no box of its own: what is seen of it is the image. @param {import("./entry.js").Entry} entry */
  showArea(entry) {
    const { areas, elements } = this.#tracker,
      element = /** @type {HTMLAreaElement} */ (entry.element),
      image = imageOf(element);
    if (image === null || entry.registrations.size === 0) return;
    entry.shown = image;
    entry.box = () => boxOf(element, image);
    entry.parts = () => [entry.box()];
    entry.whole = /** @type {Element} */ (element.closest("map"));
    areas.set(image, (areas.get(image) ?? new Set()).add(entry));
    elements.unobserve(element);
    elements.observe(image);
    if ([...entry.registrations].some(({ options }) => options.scroll === "view")) this.watchNear(image);
  }

  /** The focus has moved, or will: what the next presses reach is loaded ahead. @param {boolean} backwards @param {number} t s */
  async tab(backwards, t) {
    await new Promise((moved) => setTimeout(moved));
    reached(document.activeElement, backwards, MOST_PRESSES).forEach((element, press) => {
      const entry = this.#tracker.entryAround(element);
      if (entry) this.#tracker.firePrefetch(entry, "tab", { p: 1, t, press: press + 1 });
    });
  }

  /** Fires what a scroll is about to bring into view. @param {Element} element */
  watchNear(element) {
    this.#near ??= new NearView((one) => this.#comeNear(one), this.#tracker.elements.inView, this.#signal);
    this.#near.observe(element);
  }

  /** A scroll that goes on while the pointer rests. @param {import("./entry.js").Entry[]} entries measured in this frame */
  scroll(entries) {
    const t = performance.now() / 1000;
    for (const entry of this.#ahead.comingUnder(entries, this.#tracker.shares.cursor, t))
      this.#tracker.firePrefetch(entry, "scroll", { t, isSeen: () => !entry.isCovered, into: "pointer" });
  }

  #comeNear(element) {
    for (const entry of this.#tracker.shownAs(element))
      this.#tracker.firePrefetch(entry, "scroll", { t: performance.now() / 1000, into: "view" });
  }
}
