// Follows the pointer and the registered elements, and decides what fires: one tracker for each predictor.

import { Elements } from "../client/elements.js";
import { closest, PageChoices } from "../client/page-choices.js";
import { PointerStream } from "../client/pointer-stream.js";
import { Proposals } from "../client/proposals.js";
import { contact } from "../laws/targets/prefetch.js";
import { claimed, REMAINING_S } from "../prediction/row.js";
import { Entry } from "./entry.js";
import { ledger } from "./registration.js";
import { Shares } from "./shares.js";

const A_FRAME = 8; // elements measured in a frame without a scroll, besides the likely ones
const LIKELY = 0.02; // an element of this share is measured in each frame
const REST_MS = 100; // a pointer without events for this long is at rest
const LATE_MS = 300; // a highlight ends so long after the pointer should have been there, if it has stopped
const MOST_PRESSES = 20; // of Tab
const BUTTONS = 5; // the place in the row of an event
const RIGHT = 2; // the button that opens a menu

/**
 * Why something fires: `score` is what was compared with `threshold`, null where nothing was.
 * @typedef {{reason: string, p: number, score: number|null, threshold: number|null, t: number, remaining_s: number|null}} Cause
 */

/** What a page needs only once its user scrolls or presses Tab, or if it has a map of links. */
const later = () => import("./later.js");

/** Registered elements that share a predictor. */
export class Tracker {
  #entries = new WeakMap();
  #count = 0;
  #shares = new Shares();
  #source;
  #onIdle;
  #eventAt = -Infinity;
  #visit = 0;
  #next = 0;
  #changed = false;
  #elements;
  #stop = new AbortController();
  #pageChoices;
  #predicted;
  #over;
  #ahead = null;
  #near = null;
  #areas = new WeakMap(); // by their images
  #rows = [];
  #buttons = 0;
  #ending = 0;
  #highlights = new Proposals((choice) => this.#highlight(choice));

  /**
   * @param {(onAnswer: (row: number[]) => void) => object} open makes the source of predictions
   * @param {() => void} onIdle called when the last registration has stopped, and nothing is listened to any more
   */
  constructor(open, onIdle) {
    const { signal } = this.#stop;
    this.#onIdle = onIdle;
    this.#source = open((answer) => this.#choose(answer));
    this.#elements = new Elements({
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
      onLeave: () => this.#pause(),
      signal,
      proposals: {
        has: (entry) => this.#highlights.has(entry),
        begin: (...begun) => this.#begin(...begun),
        end: (...ended) => this.#end(...ended),
      },
    });
    const listen = (name, handle) => window.addEventListener(name, handle, { signal, capture: true, passive: true });
    for (const name of ["click", "auxclick"]) listen(name, (event) => this.#activate(event));
    listen("keydown", (event) => event.key === "Tab" && this.#tab(event));
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
    if (element.localName === "area" && entry.shown === element) this.#showArea(entry);
    this.#elements.observe(entry.shown);
    if (registration.options.scroll === "view") this.#watchNear(entry.shown);
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
      this.#areas.get(entry.shown)?.delete(entry);
      if (this.#shownAs(entry.shown).length === 0) this.#elements.unobserve(entry.shown);
      this.#pageChoices.update();
    }
    this.#changed = true;
    if (this.#count === 0) this.#close();
  }

  /** The share of an element now; 0 while it is not in view. @param {Element} element */
  share(element) {
    const place = this.#shares.entries.indexOf(this.#entries.get(element));
    return place < 0 ? 0 : this.#shares.share(place);
  }

  /** Settles when predictions can come. @returns {Promise<void>} */
  get ready() {
    return this.#source.ready;
  }

  /** What a picture of it needs. */
  get view() {
    const { entries, cursor, answer } = this.#shares;
    return {
      cursor,
      answer,
      predictor: this.#source.predictor,
      elements: entries.map(({ element, row, isHidden, registrations }, i) => ({
        element,
        row,
        isHidden,
        registrations,
        share: this.#shares.share(i),
      })),
    };
  }

  /** An area of an image has no box of its own: what is seen of it is the image. */
  async #showArea(entry) {
    const { boxOf, imageOf } = await later(),
      { element } = entry,
      image = imageOf(element);
    if (image === null || !this.#entries.has(element)) return;
    entry.shown = image;
    entry.box = () => boxOf(element, image);
    this.#areas.set(image, (this.#areas.get(image) ?? new Set()).add(entry));
    this.#elements.unobserve(element);
    this.#elements.observe(image);
    if ([...entry.registrations].some(({ options }) => options.scroll === "view")) this.#watchNear(image);
  }

  #close() {
    clearTimeout(this.#ending);
    this.#stop.abort();
    this.#source.close();
    this.#onIdle();
  }

  /** Events wait for the frame, which the browser begins with them, unless a button has changed: what follows it may leave the page. */
  #addRows(rows) {
    this.#eventAt = performance.now();
    const pressed = rows.some((row) => row[BUTTONS] !== this.#buttons);
    this.#buttons = rows.at(-1)[BUTTONS];
    this.#rows.push(...rows);
    if (pressed) this.#use();
    else this.#elements.schedule();
  }

  /** Every event is used, but shares are computed once. */
  #use() {
    const rows = this.#rows;
    if (rows.length === 0) return;
    this.#rows = [];
    let answer = null;
    const entered = this.#shares.follow(rows, (row, begins) => {
      answer = this.#source.add(row, begins);
    });
    for (const { entry, x, y } of entered)
      this.#firePrefetch(entry, "entered", { isSeen: () => entry.isOver(x, y), isPassed: true });
    if (!this.#source.flush()) this.#choose(answer);
  }

  /** A prediction has come: computes the shares, and what they decide. @param {number[]|null} answer */
  #choose(answer) {
    const shares = this.#shares,
      { x, y } = shares.cursor;
    shares.weigh(answer);
    for (const { entry, p, score } of shares.worthPrefetching())
      this.#firePrefetch(entry, "predicted", { p, score, isSeen: () => !entry.isCovered });
    const predicted = shares.headedFor(),
      over = shares.enclosing(),
      beside = over?.isBeside(x, y) ? over : undefined; // what the pointer itself is over the page tells
    this.#predicted = this.#turn("predicted", this.#predicted, predicted);
    this.#over = this.#turn("entered", this.#over, beside === predicted ? undefined : beside);
    clearTimeout(this.#ending);
    if (predicted) this.#ending = setTimeout(() => this.#expire(), 1000 * (this.#remaining ?? 0) + LATE_MS);
  }

  /** The pointer has stopped on the way: a movement that has not arrived by now is for something else. */
  #expire() {
    this.#shares.rest();
    this.#predicted = this.#turn("predicted", this.#predicted);
  }

  /** The predicted time until the pointer arrives, s; null where none is predicted. */
  get #remaining() {
    return claimed(this.#shares.answer[REMAINING_S]);
  }

  /** Sets the element that a law highlights. @returns the same */
  #turn(reason, before, now) {
    if (before === now) return before;
    const { t } = this.#shares.cursor,
      source = `law ${reason}`;
    const isLit = now && now.highlightFrom < Infinity && !now.isUnusable && !now.isCovered;
    if (isLit) {
      const score = reason === "predicted" ? this.#shares.litScore : null;
      this.#highlights.begin(source, { id: now, p: this.share(now.element), score, t, reason, action: "propose" });
    }
    if (before) this.#highlights.end(source, before, { t });
    return now;
  }

  #highlight({ id: entry, action, reason, p, score, t }) {
    for (const one of entry.registrations) {
      if (one.options.policy !== "highlight") continue;
      if (action === "retract") one.withdraw(t ?? performance.now() / 1000);
      else if (one.follows("highlight"))
        one.afterDwell(reason, t, (at) => {
          if (one.mayFire(at, this.#visit))
            one.fire(this.#cause(reason, { p, score, threshold: entry.highlightFrom, t: at }), this.#visit);
        });
    }
  }

  /**
   * @param {Entry} entry @param {string} reason
   * @param {{isSeen?: () => boolean, isPassed?: boolean}} more `isSeen`: whether nothing lies over the element, where its rectangle does not tell;
   *   `isPassed`: the pointer may be gone again
   */
  #firePrefetch(
    entry,
    reason,
    {
      p = this.share(entry.element),
      score = null,
      t = this.#shares.cursor.t,
      press = 0,
      into = "",
      isSeen = () => true,
      isPassed = false,
    },
  ) {
    for (const one of entry.registrations) {
      if (!one.follows("prefetch") || !accepts(one.options, reason, { press, into })) continue;
      if (isPassed && one.options.dwell_s > 0) continue;
      const visit = this.#visit + this.#shares.movement;
      one.afterDwell(reason, t, (at) => {
        if (one.mayFire(at, visit) && isReachable(entry, reason) && isSeen())
          one.fire(this.#cause(reason, { p, score, threshold: entry.prefetchFrom, t: at }), visit);
      });
    }
  }

  #cause(reason, { p, score = null, threshold, t }) {
    const isPredicted = reason === "predicted";
    return {
      reason,
      p,
      score,
      threshold: isPredicted ? threshold : null,
      t,
      remaining_s: isPredicted ? this.#remaining : null,
    };
  }

  /** The page itself chooses an element: by focus, by touch, or because the pointer is over it. */
  #begin(source, choice) {
    const { id: entry, reason } = choice;
    if (reason !== "entered") this.#visit += 1;
    this.#firePrefetch(entry, reason, choice);
    if (
      isReachable(entry, reason) &&
      [...entry.registrations].some((one) => one.follows("highlight") && accepts(one.options, reason, choice))
    )
      this.#highlights.begin(source, choice);
  }

  #end(source, entry, fields) {
    if (source === "entered")
      for (const one of entry.registrations) if (one.options.policy === "prefetch") one.cancel();
    this.#highlights.end(source, entry, fields);
  }

  /** The pointer is elsewhere. */
  #pause() {
    this.#expire();
    this.#over = this.#turn("entered", this.#over);
  }

  #setInView(seen) {
    this.#changed = true;
    const fires = navigator.maxTouchPoints > 0 && matchMedia("(hover: none)").matches;
    for (const { target, isIntersecting } of seen)
      for (const entry of fires && isIntersecting ? this.#shownAs(target) : [])
        this.#firePrefetch(entry, "viewport", { p: 1, t: performance.now() / 1000 });
  }

  /** The registered elements that are seen where one is: itself, and the areas of an image. @returns {Entry[]} */
  #shownAs(element) {
    return [this.#entries.get(element) ?? [], ...(this.#areas.get(element) ?? [])].flat();
  }

  /** Once a frame, while something happens. */
  #update(scrolled) {
    const { entries } = this.#shares;
    if (this.#changed) this.#replace();
    else if (entries.length) this.#measure(scrolled);
    this.#use();
    if (!scrolled || performance.now() - this.#eventAt <= REST_MS) return;
    this.#pause();
    if (this.#eventAt > -Infinity) this.#scroll(entries);
  }

  /** Measures every element after a scroll; otherwise the likely ones, and some of the others in turn. */
  #measure(scrolled) {
    const { entries } = this.#shares,
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
      this.#shares.likely(LIKELY).forEach(measure);
    }
    if (changed) this.#shares.replace(entries);
  }

  #replace() {
    this.#changed = false;
    const entries = [...this.#elements.inView].flatMap((element) => this.#shownAs(element));
    for (const entry of entries) entry.measure();
    this.#shares.replace(entries);
    for (const [reason, entry] of [
      ["predicted", this.#predicted],
      ["entered", this.#over],
    ])
      if (entry && !entries.includes(entry)) this.#turn(reason, entry, undefined);
  }

  /** A click, or a key that acts as one. */
  #activate(event) {
    if (event.button === RIGHT) return;
    for (const element of event.composedPath())
      for (const one of this.#entries.get(element)?.registrations ?? []) ledger.activate(one, event.timeStamp / 1000);
  }

  /** The focus has moved, or will: what the next presses reach is loaded ahead. */
  async #tab({ shiftKey, timeStamp }) {
    this.#visit += 1;
    const [{ reached }] = await Promise.all([later(), new Promise((moved) => setTimeout(moved))]);
    reached(document.activeElement, shiftKey, MOST_PRESSES).forEach((element, press) => {
      const found = closest(element, (one) => this.#entries.get(one));
      if (found) this.#firePrefetch(found.id, "tab", { p: 1, t: timeStamp / 1000, press: press + 1 });
    });
  }

  /** Fires what a scroll is about to bring into view. */
  async #watchNear(element) {
    const { NearView } = await later();
    this.#near ??= new NearView((one) => this.#comeNear(one), this.#elements.inView, this.#stop.signal);
    this.#near.observe(element);
  }

  #comeNear(element) {
    for (const entry of this.#shownAs(element))
      this.#firePrefetch(entry, "scroll", { t: performance.now() / 1000, into: "view" });
  }

  /** A scroll that goes on while the pointer rests. */
  async #scroll(entries) {
    const { ScrollAhead } = await later(),
      t = performance.now() / 1000;
    this.#ahead ??= new ScrollAhead(contact);
    for (const entry of this.#ahead.comingUnder(entries, this.#shares.cursor, t))
      this.#firePrefetch(entry, "scroll", { t, isSeen: () => !entry.isCovered, into: "pointer" });
  }
}

/** Whether an element can be used as a reason says: the keyboard reaches also what takes no pointer events. */
function isReachable(entry, reason) {
  return reason === "focus" || reason === "tab" || !entry.isUnusable;
}

/** Whether a registration fires for a reason. */
function accepts({ touch, scroll, keyboard }, reason, { press, into }) {
  if (reason === "touch") return touch === "start";
  if (reason === "viewport") return touch === "viewport";
  if (reason === "scroll") return scroll === into;
  return reason !== "tab" || press <= keyboard;
}
