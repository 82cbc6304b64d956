// The targets of the browser client: those given by hand, and elements of the page that are followed.

const LOOK_MS = 250; // observed elements are looked at so often while the pointer rests
const ACTIVE_MS = 500; // and every frame for so long after an event

let numbered = 0;

/** Knows where the targets are, and says when that may have changed. */
export class TargetWatch {
  #given; #offset; #changed; #signal; #observed = new Map(); #frame = false; #scrolled = false; #activeUntil = 0; #sizes; #views;

  /**
   * @param {import("../pointpred.js").Target[]} given
   * @param {{offset: () => number[], changed: (scrolled: boolean) => void, signal: AbortSignal}} told `offset`: what is to be
   *   added to positions in the viewport, px; `changed` is called before the next frame is drawn: whether the page was scrolled or resized
   */
  constructor(given, { offset, changed, signal }) {
    [this.#given, this.#offset, this.#changed, this.#signal] = [given, offset, changed, signal];
    this.#sizes = new ResizeObserver(() => this.#look());
    this.#views = new IntersectionObserver((entries) => this.#seen(entries));
    const look = () => this.#look();
    const scrolled = () => this.#look((this.#scrolled = true));
    for (const name of ["scroll", "resize"]) window.addEventListener(name, scrolled, { signal, capture: true, passive: true });
    document.addEventListener("visibilitychange", look, { signal });
    const timer = setInterval(() => this.#observed.size && this.#look(), LOOK_MS);
    signal.addEventListener("abort", () => {
      clearInterval(timer);
      this.#sizes.disconnect();
      this.#views.disconnect();
    });
  }

  /** Replaces those given by hand. @param {import("../pointpred.js").Target[]} list */
  give(list) {
    this.#given = list;
    this.#look();
  }

  /** @param {Element} element @param {string} [id] */
  observe(element, id) {
    const known = this.#observed.get(element); // nothing tells again that it is in view
    id ??= known?.id ?? (element.id || `element-${++numbered}`);
    for (const [other, { id: taken }] of this.#observed)
      if (taken === id && other !== element) throw new TypeError(`the id ${id} belongs to another observed element`);
    this.#observed.set(element, { id, inView: known?.inView ?? false });
    this.#sizes.observe(element);
    this.#views.observe(element);
    this.#look();
    return id;
  }

  /** @param {Element} element */
  unobserve(element) {
    if (!this.#observed.delete(element)) return;
    this.#sizes.unobserve(element);
    this.#views.unobserve(element);
    this.#look();
  }

  /** The observed element that has an id. @param {string} id @returns {Element|undefined} */
  element(id) {
    for (const [element, known] of this.#observed) if (known.id === id) return element;
    return undefined;
  }

  /** The id of an observed element. @param {Element} element @returns {string|undefined} */
  id(element) {
    return this.#observed.get(element)?.id;
  }

  /** The pointer moves: elements are looked at every frame for a while. */
  stir() {
    this.#activeUntil = performance.now() + ACTIVE_MS;
    if (this.#observed.size) this.#look();
  }

  /** Where every target is now. @returns {import("../pointpred.js").Target[]} */
  list() {
    const targets = [...this.#given];
    for (const [element, { id, inView }] of this.#observed) {
      const place = inView ? this.#place(element) : { width: 0, height: 0 };
      if (place.width > 0 && place.height > 0) targets.push({ id, ...place });
    }
    return targets;
  }

  /** An element as the true target of a trial. @param {Element} element @returns {import("../pointpred.js").Goal} */
  goal(element) {
    const { x, y, width, height } = this.#place(element);
    return { x: x + width / 2, y: y + height / 2, width: Math.min(width, height) };
  }

  #place(element) {
    const [right, down] = this.#offset();
    const { x, y, width, height } = element.getBoundingClientRect();
    return { x: x + right, y: y + down, width, height };
  }

  #seen(entries) {
    for (const { target, isIntersecting } of entries) {
      const known = this.#observed.get(target);
      if (known) known.inView = isIntersecting;
    }
    this.#look();
  }

  /** Looks before the next frame is drawn, once; hidden pages draw none. */
  #look() {
    if (this.#frame || this.#signal.aborted) return;
    this.#frame = true;
    const act = () => {
      this.#frame = false;
      if (this.#signal.aborted) return;
      const scrolled = this.#scrolled;
      this.#scrolled = false;
      this.#changed(scrolled);
      if (this.#observed.size && performance.now() < this.#activeUntil) this.#look();
    };
    if (document.hidden) setTimeout(act, 0);
    else requestAnimationFrame(act);
  }
}
