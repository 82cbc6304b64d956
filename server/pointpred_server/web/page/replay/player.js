// The time of a replay: a slider, and a button that plays it in real time.

import { write } from "../shell/elements.js";

/** Stands at a time or plays. */
export class Player {
  #button;
  #slider;
  #onChange;
  /** @type {number|null} */ #began = null; // when the replay began, on the clock of performance.now, ms

  /** @param {HTMLButtonElement} button @param {HTMLInputElement} slider in ms @param {() => void} onChange is called when the time or the state has changed */
  constructor(button, slider, onChange) {
    [this.#button, this.#slider, this.#onChange] = [button, slider, onChange];
    button.addEventListener("click", () => (this.playing ? this.stop() : this.#play()));
    slider.addEventListener("input", () => {
      this.#pause();
      this.seek(this.ms);
    });
  }

  get playing() {
    return this.#began !== null;
  }

  /** The current time. */
  get ms() {
    return Number(this.#slider.value);
  }

  /** Sets the duration and the time of another movement, ms. */
  load(duration, ms) {
    this.#slider.max = String(Math.round(duration));
    this.seek(ms);
  }

  seek(ms) {
    this.#slider.value = String(Math.round(ms));
    this.#slider.setAttribute("aria-valuetext", `${(this.ms / 1000).toFixed(2)} seconds`);
    this.#onChange();
  }

  stop() {
    this.#pause();
    this.#onChange();
  }

  enable(enabled) {
    this.#button.disabled = this.#slider.disabled = !enabled;
  }

  #pause() {
    this.#began = null;
    write(this.#button, "Play");
  }

  #play() {
    this.#began = performance.now() - (this.ms >= Number(this.#slider.max) ? 0 : this.ms);
    write(this.#button, "Pause");
    requestAnimationFrame((now) => this.#advance(now));
  }

  #advance(now) {
    if (this.#began === null) return;
    const ms = Math.max(0, now - this.#began),
      duration = Number(this.#slider.max);
    if (ms >= duration) this.#pause();
    else requestAnimationFrame((later) => this.#advance(later));
    this.seek(Math.min(ms, duration));
  }
}
