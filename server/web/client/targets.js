// The targets of a connection: rectangles that the page has set, and elements that are followed.

const IDLE_MS = 250; // elements are measured this often while the pointer rests
const ACTIVE_MS = 500; // and every frame for this long after an event

let unnamed = 0;

/** Knows where the targets are, and reports when they may have moved. */
export class Targets {
  #rectangles; #offset; #onChange; #signal; #observed = new Map(); #frame = false; #scrolled = false; #activeUntil = 0; #sizes; #views;

  /**
   * @param {import("../pointpred.js").Target[]} rectangles
   * @param {{offset: () => number[], onChange: (scrolled: boolean) => void, signal: AbortSignal}} options `offset`: what to
   *   add to positions in the viewport, px; `onChange` is called before the next frame is drawn: `scrolled` if the page was scrolled or resized
   */
  constructor(rectangles, { offset, onChange, signal }) {
    [this.#rectangles, this.#offset, this.#onChange, this.#signal] = [rectangles, offset, onChange, signal];
    this.#sizes = new ResizeObserver(() => this.#schedule());
    this.#views = new IntersectionObserver((entries) => this.#setInView(entries));
    const scroll = () => {
      this.#scrolled = true;
      this.#schedule();
    };
    for (const name of ["scroll", "resize"]) window.addEventListener(name, scroll, { signal, capture: true, passive: true });
    document.addEventListener("visibilitychange", () => this.#schedule(), { signal });
    const timer = setInterval(() => this.#observed.size && this.#schedule(), IDLE_MS);
    signal.addEventListener("abort", () => {
      clearInterval(timer);
      this.#sizes.disconnect();
      this.#views.disconnect();
    });
  }

  /** Replaces the rectangles; observed elements stay. @param {import("../pointpred.js").Target[]} rectangles */
  replace(rectangles) {
    this.#rectangles = rectangles;
    this.#schedule();
  }

  /** @param {Element} element @param {string} [id] */
  observe(element, id) {
    const former = this.#observed.get(element); // the browser does not report again that it is in view
    id ??= former?.id ?? (element.id || `element-${++unnamed}`);
    for (const [other, { id: used }] of this.#observed)
      if (used === id && other !== element) throw new TypeError(`the id ${id} belongs to another observed element`);
    this.#observed.set(element, { id, inView: former?.inView ?? false });
    this.#sizes.observe(element);
    this.#views.observe(element);
    this.#schedule();
    return id;
  }

  /** @param {Element} element */
  unobserve(element) {
    if (!this.#observed.delete(element)) return;
    this.#sizes.unobserve(element);
    this.#views.unobserve(element);
    this.#schedule();
  }

  /** The observed element that has an id. @param {string} id @returns {Element|undefined} */
  element(id) {
    for (const [element, one] of this.#observed) if (one.id === id) return element;
    return undefined;
  }

  /** The id of an observed element. @param {Element} element @returns {string|undefined} */
  id(element) {
    return this.#observed.get(element)?.id;
  }

  /** The pointer moves: elements are measured every frame for a while. */
  activate() {
    this.#activeUntil = performance.now() + ACTIVE_MS;
    if (this.#observed.size) this.#schedule();
  }

  /** Where every target is now. @returns {import("../pointpred.js").Target[]} */
  list() {
    const targets = [...this.#rectangles];
    for (const [element, { id, inView }] of this.#observed) {
      const box = inView ? this.#measure(element) : { width: 0, height: 0 };
      if (box.width > 0 && box.height > 0) targets.push({ id, ...box });
    }
    return targets;
  }

  /** An element as the true target of a trial. @param {Element} element @returns {import("../pointpred.js").Goal} */
  goal(element) {
    const { x, y, width, height } = this.#measure(element);
    return { x: x + width / 2, y: y + height / 2, width: Math.min(width, height) };
  }

  #measure(element) {
    const [right, down] = this.#offset();
    const { x, y, width, height } = element.getBoundingClientRect();
    return { x: x + right, y: y + down, width, height };
  }

  #setInView(entries) {
    for (const { target, isIntersecting } of entries) {
      const one = this.#observed.get(target);
      if (one) one.inView = isIntersecting;
    }
    this.#schedule();
  }

  /** Reports a possible change before the next frame is drawn, once; a hidden page draws no frames. */
  #schedule() {
    if (this.#frame || this.#signal.aborted) return;
    this.#frame = true;
    const report = () => {
      this.#frame = false;
      if (this.#signal.aborted) return;
      const scrolled = this.#scrolled;
      this.#scrolled = false;
      this.#onChange(scrolled);
      if (this.#observed.size && performance.now() < this.#activeUntil) this.#schedule();
    };
    if (document.hidden) setTimeout(report, 0);
    else requestAnimationFrame(report);
  }
}
