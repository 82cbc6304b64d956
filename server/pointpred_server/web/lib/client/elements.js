// Elements that are followed: which of them are in view, and when they may have moved.

const IDLE_MS = 250; // elements are measured this often while the pointer rests

/** Knows which elements are in view, and reports before a frame is drawn when any may have moved. */
export class Elements {
  /** Those of which a part is in view; one that is not in the document is not. @type {Set<Element>} */ inView =
    new Set();
  #followed = new WeakSet();
  #onFrame;
  #onView;
  #signal;
  #frame = false;
  #scrolled = false;
  #views;

  /**
   * @param {{onFrame: (scrolled: boolean) => void, onView?: (entries: IntersectionObserverEntry[]) => void, signal: AbortSignal}} options
   *   `onFrame` is called at most once a frame, before it is drawn: `scrolled` if the page was scrolled or resized; `onView`
   *   when elements have come into view or left it
   */
  constructor({ onFrame, onView = () => {}, signal }) {
    [this.#onFrame, this.#onView, this.#signal] = [onFrame, onView, signal];
    this.#views = new IntersectionObserver((entries) => this.#setInView(entries));
    const scroll = () => {
      this.#scrolled = true;
      this.schedule();
    };
    for (const name of ["scroll", "resize"])
      window.addEventListener(name, scroll, { signal, capture: true, passive: true });
    document.addEventListener("visibilitychange", () => this.schedule(), { signal });
    const timer = setInterval(() => this.inView.size && this.schedule(), IDLE_MS);
    signal.addEventListener("abort", () => {
      clearInterval(timer);
      this.#views.disconnect();
    });
  }

  /** Begins to follow an element; once more changes nothing. @param {Element} element */
  observe(element) {
    this.#followed.add(element);
    this.#views.observe(element);
    this.schedule();
  }

  /** @param {Element} element */
  unobserve(element) {
    this.#followed.delete(element);
    this.inView.delete(element);
    this.#views.unobserve(element);
    this.schedule();
  }

  /** Reports a possible change before the next frame is drawn, once; a hidden page draws no frames. */
  schedule() {
    if (this.#frame || this.#signal.aborted) return;
    this.#frame = true;
    const report = () => {
      this.#frame = false;
      if (this.#signal.aborted) return;
      const scrolled = this.#scrolled;
      this.#scrolled = false;
      this.#onFrame(scrolled);
    };
    if (document.hidden) setTimeout(report, 0);
    else requestAnimationFrame(report);
  }

  #setInView(entries) {
    const followed = entries.filter(({ target }) => this.#followed.has(target)); // others were let go meanwhile
    for (const { target, isIntersecting } of followed) {
      if (isIntersecting) this.inView.add(target);
      else this.inView.delete(target);
    }
    this.#onView(followed);
    this.schedule();
  }
}
