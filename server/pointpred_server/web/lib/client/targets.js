// The targets of a connection: rectangles that the page has set, and elements that are followed.

import { Elements } from "./elements.js";

const ACTIVE_MS = 500; // elements are measured every frame for this long after an event

let unnamed = 0;

/** Knows where the targets are, and reports when they may have moved. */
export class Targets {
  #rectangles;
  #offset;
  #ids = new Map();
  #elements;
  #activeUntil = 0;

  /**
   * @param {import("../index.d.ts").NamedTarget[]} rectangles
   * @param {{offset: () => number[], onChange: (scrolled: boolean) => void, signal: AbortSignal}} options `offset`: what to
   *   add to positions in the viewport, px; `onChange` is called before the next frame is drawn: `scrolled` if the page was scrolled or resized
   */
  constructor(rectangles, { offset, onChange, signal }) {
    [this.#rectangles, this.#offset] = [rectangles, offset];
    const onFrame = (scrolled) => {
      onChange(scrolled);
      if (performance.now() < this.#activeUntil) this.#scheduleSeen();
    };
    this.#elements = new Elements({ onFrame, signal });
  }

  /** Replaces the rectangles; observed elements stay. @param {import("../index.d.ts").NamedTarget[]} rectangles */
  replace(rectangles) {
    this.#rectangles = rectangles;
    this.#elements.schedule();
  }

  /** @param {Element} element @param {string} [id] */
  observe(element, id) {
    id ??= this.#ids.get(element) ?? (element.id || `element-${++unnamed}`);
    for (const [other, used] of this.#ids)
      if (used === id && other !== element) throw new TypeError(`the id ${id} belongs to another observed element`);
    this.#ids.set(element, id);
    this.#elements.observe(element);
    return id;
  }

  /** @param {Element} element */
  unobserve(element) {
    if (this.#ids.delete(element)) this.#elements.unobserve(element);
  }

  /** The observed element that has an id. @param {string} id @returns {Element|undefined} */
  element(id) {
    for (const [element, used] of this.#ids) if (used === id) return element;
    return undefined;
  }

  /** The id of an observed element. @param {Element} element @returns {string|undefined} */
  id(element) {
    return this.#ids.get(element);
  }

  /** The pointer moves: elements are measured every frame for a while. */
  activate() {
    this.#activeUntil = performance.now() + ACTIVE_MS;
    this.#scheduleSeen();
  }

  #scheduleSeen() {
    if (this.#elements.inView.size) this.#elements.schedule();
  }

  /** Where every target is now. @returns {import("../index.d.ts").NamedTarget[]} */
  list() {
    const targets = [...this.#rectangles];
    for (const [element, id] of this.#ids) {
      if (!this.#elements.inView.has(element)) continue;
      const box = this.#measure(element);
      if (box.width > 0 && box.height > 0) targets.push({ id, ...box });
    }
    return targets;
  }

  /** An element as the true target of a trial. @param {Element} element @returns {import("../index.d.ts").Goal} */
  goal(element) {
    const { x, y, width, height } = this.#measure(element);
    return { x: x + width / 2, y: y + height / 2, width: Math.min(width, height) };
  }

  #measure(element) {
    const [right, down] = this.#offset();
    const { x, y, width, height } = element.getBoundingClientRect();
    return { x: x + right, y: y + down, width, height };
  }
}
