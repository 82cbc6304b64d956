// Follows the pointer and the registered elements, and decides what fires: one tracker for each predictor.

import { Elements } from "../client/elements.js";
import { closest, PageChoices } from "../client/page-choices.js";
import { PointerStream } from "../client/pointer-stream.js";
import { contact } from "../laws/targets/prefetch.js";
import { claimed, REMAINING_S } from "../prediction/row.js";
import { Entry } from "./entry.js";
import { ledger } from "./registration.js";
import { HIGHLIGHTING, Shares } from "./shares.js";

const A_FRAME = 8; // elements measured in a frame without a scroll, besides the likely ones
const LIKELY = 0.02; // an element of this share is measured in each frame
const REST_MS = 100; // a pointer without events for this long is at rest
const BUTTONS = 5; // the place in the row of an event
const RIGHT = 2; // the button that opens a menu

/**
 * Why something fires: `score` is what was compared with `threshold`, null where nothing was.
 * @typedef {Omit<import("../index.d.ts").Firing, "element"|"name"|"policy"|"signal">} Cause
 */

/** Registered elements that share a predictor. */
export class Tracker {
  /** The registered elements in view. */ shares = new Shares();
  /** Where predictions come from. @type {import("./source.js").Source} */ source;
  /** Tells which elements are in view. @type {Elements} */ elements;
  /** The areas of images. @type {WeakMap<Element, Set<Entry>>} */ areas = new WeakMap();
  /** Counts the key presses and touches of the page. */ visit = 0;
  /** @type {WeakMap<Element, Entry>} */ #entries = new WeakMap();
  #count = 0;
  #onIdle;
  #eventAt = -Infinity;
  #next = 0;
  #changed = false;
  #stop = new AbortController();
  #pageChoices;
  /** @type {import("./later.js").Later|null} */ #later = null;
  /** @type {import("./highlights.js").Highlights|null} */ #highlights = null;
  /** @type {Promise<void>|null} */ #loading = null; // settles when highlights are loaded
  #failed = false;
  #rows = [];
  #buttons = 0;

  /**
   * @param {(onAnswer: (row: number[]) => void) => import("./source.js").Source} open makes the source of predictions
   * @param {() => void} onIdle called when the last registration has stopped, and nothing is listened to any more
   */
  constructor(open, onIdle) {
    const { signal } = this.#stop;
    this.#onIdle = onIdle;
    this.source = open((answer) => this.#choose(answer));
    this.elements = new Elements({
      onFrame: (scrolled) => this.#update(scrolled),
      onView: (seen) => this.#setInView(seen),
      signal,
    });
    new PointerStream(window, {
      raw: false,
      accepts: ({ pointerType }) => pointerType !== "touch",
      onRows: (rows) => this.#addRows(rows),
      signal,
    });
    this.#pageChoices = new PageChoices(window, {
      pointer: true,
      idOf: (one) => this.#entries.get(one),
      onLeave: () => this.#highlights?.pause(),
      signal,
      proposals: {
        has: (entry) => this.#highlights?.has(entry) ?? false,
        begin: (...begun) => this.#begin(...begun),
        end: (...ended) => this.#end(...ended),
      },
    });
    const listen = (name, handle) => window.addEventListener(name, handle, { signal, capture: true, passive: true });
    for (const name of ["click", "auxclick"]) listen(name, (event) => this.#activate(event));
    listen("keydown", ({ key, shiftKey, timeStamp }) => {
      if (key !== "Tab") return;
      this.visit += 1;
      this.#whenLater((later) => later.tab(shiftKey, timeStamp / 1000));
    });
  }

  /** @param {import("./registration.js").Registration} registration */
  add(registration) {
    const { element } = registration;
    const entry = this.#entries.get(element) ?? new Entry(element);
    entry.registrations.add(registration);
    entry.update();
    this.#entries.set(element, entry);
    this.#count += 1;
    this.#changed = true;
    if (registration.follows("highlight")) this.#loadHighlights();
    if (element.localName === "area" && entry.shown === element) this.#whenLater((later) => later.showArea(entry));
    this.elements.observe(entry.shown);
    if (registration.options.scroll === "view") this.#whenLater((later) => later.watchNear(entry.shown));
    this.#pageChoices.update();
  }

  /** @param {import("./registration.js").Registration} registration */
  remove(registration) {
    const { element } = registration,
      entry = this.#entries.get(element);
    if (!entry?.registrations.delete(registration)) return;
    registration.stop();
    entry.update();
    this.#count -= 1;
    if (entry.registrations.size === 0) {
      this.#entries.delete(element);
      this.areas.get(entry.shown)?.delete(entry);
      if (this.shownAs(entry.shown).length === 0) this.elements.unobserve(entry.shown);
      this.#pageChoices.update();
    }
    this.#changed = true;
    if (this.#count === 0) this.#close();
  }

  /** The share of an element now; 0 while it is not in view. @param {Element} element */
  share(element) {
    const place = this.shares.entries.indexOf(/** @type {Entry} */ (this.#entries.get(element)));
    return place < 0 ? 0 : this.shares.share(place);
  }

  /** Settles when predictions can come. @returns {Promise<void>} */
  get ready() {
    return this.source.ready;
  }

  /** The entry of a registered element, or of the innermost one that contains it. @param {Element|null} element */
  entryAround(element) {
    return closest(element, (one) => this.#entries.get(one))?.id;
  }

  /** Calls `use` with what a page needs only once its user scrolls or presses Tab, or if it has a map of links. */
  #whenLater(use) {
    import("./later.js").then(({ Later }) => {
      this.#later ??= new Later(this, contact, this.#stop.signal);
      use(this.#later);
    }, this.#fail);
  }

  /** Loads the highlights; after a failure the next call tries again. */
  #loadHighlights() {
    this.#loading ??= import("./highlights.js").then(
      ({ Highlights }) => {
        const { signal } = this.#stop;
        if (!signal.aborted) this.#highlights = new Highlights(this, HIGHLIGHTING, signal);
      },
      (error) => {
        this.#loading = null;
        this.#fail(error);
      },
    );
  }

  /** A part of the package cannot be loaded, such as without a network: told once. It is asked for again when it is next needed. */
  #fail = (error) => {
    if (!this.#failed) reportError(error);
    this.#failed = true;
  };

  /** Calls `use` with the highlights: if any are asked for, once they are loaded. */
  #highlight(use) {
    if (this.#highlights) use(this.#highlights);
    else this.#loading?.then(() => this.#highlights && use(this.#highlights));
  }

  #close() {
    this.#stop.abort();
    this.source.close();
    this.shares.replace([]); // whoever still holds the tracker holds no elements
    this.#onIdle();
  }

  /** Events wait for the frame, which the browser begins with them, unless a button has changed: what follows it may leave the page. */
  #addRows(rows) {
    this.#eventAt = performance.now();
    const pressed = rows.some((row) => row[BUTTONS] !== this.#buttons);
    this.#buttons = rows.at(-1)[BUTTONS];
    this.#rows.push(...rows);
    if (pressed) this.#use();
    else this.elements.schedule();
  }

  /** Every event is used, but shares are computed once. */
  #use() {
    const rows = this.#rows;
    if (rows.length === 0) return;
    this.#rows = [];
    /** @type {number[]|null} */
    let answer = null;
    const entered = this.shares.follow(rows, (row, begins) => {
      answer = this.source.add(row, begins);
    });
    for (const { entry, x, y } of entered)
      this.firePrefetch(entry, "entered", { isSeen: () => entry.isOver(x, y), isPassed: true });
    if (!this.source.flush()) this.#choose(answer);
  }

  /** A prediction has come: computes the shares, and what they decide. @param {number[]|null} answer */
  #choose(answer) {
    const { shares } = this;
    shares.weigh(answer);
    for (const { entry, p, score } of shares.worthPrefetching())
      this.firePrefetch(entry, "predicted", { p, score, isSeen: () => !entry.isCovered });
    this.#highlights?.choose();
  }

  /** The predicted time until the pointer arrives, s; null where none is predicted. */
  get remaining_s() {
    return claimed(this.shares.answer[REMAINING_S]);
  }

  /**
   * Fires the prefetches of an element that a reason counts for.
   * @param {Entry} entry @param {import("../index.d.ts").Reason} reason
   * @param {{p?: number, score?: number|null, t?: number, press?: number, into?: string, isSeen?: () => boolean, isPassed?: boolean}} more `isSeen`: whether nothing lies over the element, where its rectangle does not tell;
   *   `isPassed`: the pointer may be gone again
   */
  firePrefetch(
    entry,
    reason,
    {
      p = this.share(entry.element),
      score = null,
      t = this.shares.cursor.t,
      press = 0,
      into = "",
      isSeen = () => true,
      isPassed = false,
    },
  ) {
    for (const one of entry.registrations) {
      if (!one.follows("prefetch") || !accepts(one.options, reason, { press, into })) continue;
      if (isPassed && one.options.dwell_s > 0) continue;
      const visit = this.visit + this.shares.movement;
      one.afterDwell(reason, t, (at) => {
        if (one.mayFire(at, visit) && isReachable(entry, reason) && isSeen())
          one.fire(this.cause(reason, { p, score, threshold: entry.prefetchFrom, t: at }), visit);
      });
    }
  }

  /**
   * @param {Cause["reason"]} reason @param {{p: number, score?: number|null, threshold: number, t: number}} firing
   * @returns {Cause}
   */
  cause(reason, { p, score = null, threshold, t }) {
    const isPredicted = reason === "predicted";
    return {
      reason,
      p,
      score,
      threshold: isPredicted ? threshold : null,
      t,
      remaining_s: isPredicted ? this.remaining_s : null,
    };
  }

  /** The page itself chooses an element: by focus, by touch, or because the pointer is over it. */
  #begin(source, choice) {
    const { id: entry, reason } = choice;
    if (reason !== "entered") this.visit += 1;
    this.firePrefetch(entry, reason, choice);
    if (
      isReachable(entry, reason) &&
      [...entry.registrations].some((one) => one.follows("highlight") && accepts(one.options, reason, choice))
    ) {
      this.#loadHighlights();
      this.#highlight((highlights) => highlights.begin(source, choice));
    }
  }

  #end(source, entry, fields) {
    if (source === "entered")
      for (const one of entry.registrations) if (one.options.policy === "prefetch") one.cancel();
    this.#highlight((highlights) => highlights.end(source, entry, fields));
  }

  #setInView(seen) {
    this.#changed = true;
    const fires = navigator.maxTouchPoints > 0 && matchMedia("(hover: none)").matches;
    for (const { target, isIntersecting } of seen)
      for (const entry of fires && isIntersecting ? this.shownAs(target) : [])
        this.firePrefetch(entry, "viewport", { p: 1, t: performance.now() / 1000 });
  }

  /** The registered elements that are seen where one is: itself, and the areas of an image. @returns {Entry[]} */
  shownAs(element) {
    return [this.#entries.get(element) ?? [], ...(this.areas.get(element) ?? [])].flat();
  }

  /** Once a frame, while something happens. */
  #update(scrolled) {
    const { entries } = this.shares;
    if (this.#changed) this.#replace();
    else if (entries.length) this.#measure(scrolled);
    this.#use();
    if (!scrolled || performance.now() - this.#eventAt <= REST_MS) return;
    this.#highlights?.pause();
    if (this.#eventAt > -Infinity) this.#whenLater((later) => later.scroll(entries));
  }

  /** Measures every element after a scroll; otherwise the likely ones, and some of the others in turn. */
  #measure(scrolled) {
    const { entries } = this.shares,
      first = this.#next,
      count = entries.length;
    this.#next = (first + A_FRAME) % count;
    let changed = false;
    const measure = (i) => {
      changed = entries[i].measure() || changed;
    };
    if (scrolled) entries.forEach((_, i) => measure(i));
    else {
      for (let k = 0; k < Math.min(A_FRAME, count); k += 1) measure((first + k) % count);
      this.shares.likely(LIKELY).forEach(measure);
    }
    if (changed) this.shares.replace(entries);
  }

  #replace() {
    this.#changed = false;
    const entries = [...this.elements.inView].flatMap((element) => this.shownAs(element));
    for (const entry of entries) entry.measure();
    this.shares.replace(entries);
    this.#highlights?.keep(entries);
  }

  /** A click, or a key that acts as one. */
  #activate(event) {
    if (event.button === RIGHT) return;
    for (const element of event.composedPath())
      for (const one of this.#entries.get(element)?.registrations ?? []) ledger.activate(one, event.timeStamp / 1000);
  }
}

/** Whether an element can be used as a reason says: the keyboard reaches also what takes no pointer events. */
function isReachable(entry, reason) {
  return !(reason === "focus" || reason === "tab" ? entry.isDisabled : entry.isUnusable);
}

/** Whether a registration fires for a reason. */
function accepts({ touch, scroll, keyboard }, reason, { press, into }) {
  if (reason === "touch") return touch === "start";
  if (reason === "viewport") return touch === "viewport";
  if (reason === "scroll") return scroll === into;
  return reason !== "tab" || press <= keyboard;
}
