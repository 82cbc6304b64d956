// An element as a framework registers it: what it is told may change whenever the page is rendered.

import { onIntent } from "../intent/index.js";

const named = (_, value) => (typeof value === "function" ? "a function" : value);

/**
 * @typedef {import("../index.d.ts").IntentCallback} IntentCallback
 * @typedef {import("../index.d.ts").IntentOptions} IntentOptions
 */

/** An element, registered as long as there is something to call. Another callback is called from then on; other options register the element again. */
export class Registered {
  #element;
  #newest;
  #key = "";
  #stop = () => {};

  /** @param {Element} element @param {IntentCallback|null|undefined} callback @param {IntentOptions} [options] of `onIntent` */
  constructor(element, callback, options) {
    this.#element = element;
    this.update(callback, options);
  }

  /** @param {IntentCallback|null|undefined} callback @param {IntentOptions} [options] */
  update(callback, options = {}) {
    this.#newest = { ...options, callback };
    const key = callback ? JSON.stringify(options, named) : "";
    if (key === this.#key) return;
    this.stop();
    this.#key = key;
    if (!callback) return;
    const passed = Object.entries(this.#newest).map(([name, value]) => [
      name,
      typeof value === "function" ? (...about) => this.#newest[name](...about) : value,
    ]);
    const { callback: call, ...rest } = Object.fromEntries(passed);
    this.#stop = onIntent(this.#element, call, rest);
  }

  stop() {
    this.#stop();
  }
}

/**
 * What a directive or an action is given: the callback itself, the callback with options, or nothing to call.
 * @param {import("../index.d.ts").IntentBinding} value @returns {[(IntentCallback|null)?, IntentOptions?]}
 */
export function partsOf(value) {
  if (typeof value === "function") return [value];
  if (!value) return [];
  const { callback, ...options } = value;
  return [callback, options];
}
