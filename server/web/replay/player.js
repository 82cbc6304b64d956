// The time of a replay: a slider, a button that plays, the animation between them.

import { write } from "../page/elements.js";

/** Stands at a time or goes on in real time; whoever made it hears of every change. */
export class Player {
  #button; #slider; #changed; #began = null; // when the replay began, on the animation clock, ms

  /** @param {HTMLButtonElement} button @param {HTMLInputElement} slider in ms @param {() => void} changed */
  constructor(button, slider, changed) {
    [this.#button, this.#slider, this.#changed] = [button, slider, changed];
    button.addEventListener("click", () => (this.playing ? this.stop() : this.#start()));
    slider.addEventListener("input", () => {
      this.#halt();
      this.go(this.ms);
    });
  }

  get playing() {
    return this.#began !== null;
  }

  /** The time it stands at. */
  get ms() {
    return Number(this.#slider.value);
  }

  /** Gives it another movement of so many ms, at a time of it. */
  load(longest, ms) {
    this.#slider.max = String(Math.round(longest));
    this.go(ms);
  }

  go(ms) {
    this.#slider.value = String(Math.round(ms));
    this.#slider.setAttribute("aria-valuetext", `${(this.ms / 1000).toFixed(2)} seconds`);
    this.#changed();
  }

  stop() {
    this.#halt();
    this.#changed();
  }

  enable(yes) {
    this.#button.disabled = this.#slider.disabled = !yes;
  }

  #halt() {
    this.#began = null;
    write(this.#button, "Play");
  }

  #start() {
    this.#began = performance.now() - (this.ms >= Number(this.#slider.max) ? 0 : this.ms);
    write(this.#button, "Pause");
    requestAnimationFrame((now) => this.#advance(now));
  }

  #advance(now) {
    if (!this.playing) return;
    const passed = Math.max(0, now - this.#began), longest = Number(this.#slider.max);
    if (passed >= longest) this.#halt();
    else requestAnimationFrame((later) => this.#advance(later));
    this.go(Math.min(passed, longest));
  }
}
