// Follows the pointer and the registered elements, and decides what fires: one tracker for each predictor.

import { Elements } from "../client/elements.js";
import { closest, PageChoices } from "../client/page-choices.js";
import { PointerStream } from "../client/pointer-stream.js";
import { Proposals } from "../client/proposals.js";
import { CENTRE_X, CENTRE_Y, FIELDS, HEIGHT, WIDTH } from "../laws/targets/rectangles.js";
import { claimed, REMAINING_S } from "../prediction/row.js";
import { reached } from "./keyboard.js";
import { ledger } from "./registration.js";
import { NearView, ScrollAhead } from "./scroll.js";
import { Shares } from "./shares.js";

const A_FRAME = 8; // elements measured in a frame without a scroll, besides the likely ones
const LIKELY = 0.02; // an element of this share is measured in each frame
const REST_MS = 100; // a pointer without events for this long is at rest
const MOST_PRESSES = 20; // of Tab
const BUTTONS = 5; // the place in the row of an event
const COVERED_MS = 250; // how long an answer of the hit test is used

let entries = 0; // so far

/** A registered element. */
class Entry {
  /** Its place as a row of the targets' table: centre and size px with the slop, logarithm of its weight. */ row =
    new Float64Array(FIELDS);
  /** Whether nothing of it can be seen. */ isHidden = true;
  /** The same in none of the others. */ number = (entries += 1);
  /** @type {Set<import("./registration.js").Registration>} */ registrations = new Set();
  #slop = [0, 0, 0, 0];
  #coveredAt = -Infinity;
  #covered = false;

  /** @param {Element} element */
  constructor(element) {
    this.element = element;
  }

  /** Takes the largest weight and slop of its registrations, and for each policy the lowest threshold. */
  update() {
    const options = [...this.registrations].map((one) => one.options);
    const lowest = (policy) =>
      Math.min(...[...this.registrations].filter((one) => one.follows(policy)).map((one) => one.options.threshold));
    this.weight = Math.max(0, ...options.map(({ priority }) => priority));
    [this.prefetchFrom, this.highlightFrom] = [lowest("prefetch"), lowest("highlight")];
    this.#slop = ["top", "right", "bottom", "left"].map((side) =>
      Math.max(0, ...options.map(({ hitSlop }) => hitSlop[side])),
    );
  }

  /** What it is to the user: its name in HTML and its size, to the nearest power of two. */
  get kind() {
    const { row } = this;
    return [this.element.localName, Math.round(Math.log2(row[WIDTH])), Math.round(Math.log2(row[HEIGHT]))].join();
  }

  /** Measures it. @param {DOMRectReadOnly} [box] if its rectangle is known already @returns {boolean} whether it was hidden before and is not now, or the reverse */
  measure(box = this.element.getBoundingClientRect()) {
    const { left, top, width, height } = box,
      [up, right, down, back] = this.#slop,
      { row, isHidden } = this;
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
  #rows = [];
  #buttons = 0;
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
        end: (...ended) => this.#highlights.end(...ended),
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
    this.#elements.observe(element);
    if (registration.options.scroll === "view") this.#watchNear(element);
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
      this.#elements.unobserve(element);
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

  #close() {
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
    const rows = this.#rows.splice(0);
    if (rows.length === 0) return;
    let answer = null;
    const entered = this.#shares.follow(rows, (row, begins) => {
      answer = this.#source.add(row, begins);
    });
    for (const entry of entered) this.#firePrefetch(entry, "entered", { isSeen: false });
    if (!this.#source.flush()) this.#choose(answer);
  }

  /** A prediction has come: computes the shares, and what they decide. @param {number[]|null} answer */
  #choose(answer) {
    const shares = this.#shares;
    shares.weigh(answer);
    for (const entry of shares.worthPrefetching()) this.#firePrefetch(entry, "predicted", { isSeen: false });
    const predicted = shares.headedFor(),
      over = shares.enclosing();
    this.#predicted = this.#turn("predicted", this.#predicted, predicted);
    this.#over = this.#turn("entered", this.#over, over === predicted ? undefined : over);
  }

  /** Sets the element that a law highlights. @returns the same */
  #turn(reason, before, now) {
    if (before === now) return before;
    const { t } = this.#shares.cursor;
    const visible = now && now.highlightFrom < Infinity && !now.isCovered ? now : undefined;
    if (visible)
      this.#highlights.begin(`law ${reason}`, {
        id: visible,
        p: this.share(visible.element),
        t,
        reason,
        action: "propose",
      });
    if (before) this.#highlights.end(`law ${reason}`, before, { t });
    return now;
  }

  #highlight({ id: entry, action, reason, p, t }) {
    for (const one of entry.registrations) {
      if (one.options.policy !== "highlight") continue;
      if (action === "retract") one.withdraw(t ?? performance.now() / 1000);
      else if (one.follows("highlight") && one.mayFire(t, this.#visit))
        one.fire(this.#cause(reason, p, t), this.#visit);
    }
  }

  /** `isSeen` false: something else may lie over the element, which its rectangle does not tell. */
  #firePrefetch(
    entry,
    reason,
    { p = this.share(entry.element), t = this.#shares.cursor.t, press = 0, into = "", isSeen = true },
  ) {
    const visit = this.#visit + this.#shares.movement;
    for (const one of entry.registrations)
      if (
        one.follows("prefetch") &&
        one.mayFire(t, visit) &&
        accepts(one.options, reason, { press, into }) &&
        (isSeen || !entry.isCovered)
      )
        one.fire(this.#cause(reason, p, t), visit);
  }

  #cause(reason, p, t) {
    return { reason, p, t, remaining_s: reason === "predicted" ? claimed(this.#shares.answer[REMAINING_S]) : null };
  }

  /** The page itself chooses an element: by focus, by touch, or because the pointer is over it. */
  #begin(source, choice) {
    const { id: entry, reason } = choice;
    if (reason !== "entered") this.#visit += 1;
    this.#firePrefetch(entry, reason, choice);
    if ([...entry.registrations].some((one) => one.follows("highlight") && accepts(one.options, reason, choice)))
      this.#highlights.begin(source, choice);
  }

  /** The pointer is elsewhere. */
  #pause() {
    this.#shares.rest();
    [this.#predicted, this.#over] = [this.#turn("predicted", this.#predicted), this.#turn("entered", this.#over)];
  }

  #setInView(seen) {
    this.#changed = true;
    for (const { target, isIntersecting, boundingClientRect } of seen) {
      const entry = this.#entries.get(target);
      if (!isIntersecting || !entry) continue;
      entry.measure(boundingClientRect);
      if (navigator.maxTouchPoints > 0 && matchMedia("(hover: none)").matches)
        this.#firePrefetch(entry, "viewport", { p: 1, t: performance.now() / 1000 });
    }
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
    for (let i = 0; i < count; i += 1)
      if (scrolled || (i - first + count) % count < A_FRAME || this.#shares.share(i) >= LIKELY)
        changed = entries[i].measure() || changed;
    if (changed) this.#shares.replace(entries);
  }

  #replace() {
    this.#changed = false;
    const entries = [...this.#elements.inView].map((element) => this.#entries.get(element)).filter(Boolean);
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
    for (const one of event.composedPath()) if (this.#entries.has(one)) ledger.activate(one, event.timeStamp / 1000);
  }

  /** The focus has moved, or will: what the next presses reach is loaded ahead. */
  async #tab({ shiftKey, timeStamp }) {
    this.#visit += 1;
    await new Promise((moved) => setTimeout(moved));
    reached(document.activeElement, shiftKey, MOST_PRESSES).forEach((element, press) => {
      const found = closest(element, (one) => this.#entries.get(one));
      if (found) this.#firePrefetch(found.id, "tab", { p: 1, t: timeStamp / 1000, press: press + 1 });
    });
  }

  /** Fires what a scroll is about to bring into view. */
  #watchNear(element) {
    this.#near ??= new NearView((one) => this.#comeNear(one), this.#stop.signal);
    this.#near.observe(element);
  }

  #comeNear(element) {
    const entry = this.#entries.get(element);
    if (entry) this.#firePrefetch(entry, "scroll", { t: performance.now() / 1000, into: "view" });
  }

  /** A scroll that goes on while the pointer rests. */
  #scroll(entries) {
    const t = performance.now() / 1000;
    this.#ahead ??= new ScrollAhead();
    for (const entry of this.#ahead.comingUnder(entries, this.#shares.cursor, t))
      this.#firePrefetch(entry, "scroll", { t, isSeen: false, into: "pointer" });
  }
}

/** Whether a registration fires for a reason. */
function accepts({ touch, scroll, keyboard }, reason, { press, into }) {
  if (reason === "touch") return touch === "start";
  if (reason === "viewport") return touch === "viewport";
  if (reason === "scroll") return scroll === into;
  return reason !== "tab" || press <= keyboard;
}
