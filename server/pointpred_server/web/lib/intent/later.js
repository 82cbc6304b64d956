// What a page needs only once its user scrolls or presses Tab, or if it has a map of links: loaded then.

import { boxOf, imageOf } from "./area.js";
import { reached } from "./keyboard.js";
import { NearView, ScrollAhead } from "./scroll.js";

const MOST_PRESSES = 20; // of Tab

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
