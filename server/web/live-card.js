// What the live view says about one predictor: its choice, its connection, phase, time left and region.

import { number, write } from "./elements.js";
import { Track, words } from "./track.js";
import { regionOf } from "/pointpred.js";

/** One predictor's card; `track` is null while none is chosen or the view is closed. */
export class LiveCard {
  /** @type {Track|null} */ track = null;
  offered = false;
  #status; #of; #told; #options;

  /**
   * @param {HTMLElement} card @param {(prediction: object, name: string) => void} predicted hears of each, and whose it is
   * @param {{choice?: (one: object) => void}} told @param {import("/pointpred.js").Options} options of the connection
   */
  constructor(card, predicted, told = {}, options = {}) {
    this.#options = options;
    this.select = card.querySelector("select");
    this.#status = card.querySelector(".connection");
    this.#of = Object.fromEntries(["phase", "left", "region"].map((of) => [of, card.querySelector(`[data-of=${of}]`)]));
    this.#told = { prediction: (one) => predicted(one, this.track.speaker), state: () => this.#say(), error: () => this.#say(), ...told };
    this.select.addEventListener("change", () => this.#choose());
  }

  /** Connects with the predictor chosen, if any. */
  open() {
    if (this.track === null && this.select.value) this.track = new Track(this.select.value, this.#told, this.#options);
    this.#say();
  }

  close() {
    this.track?.close();
    this.track = null;
  }

  /** The newest prediction, if it came within so many ms. */
  fresh(ms) {
    const track = this.track;
    return track !== null && performance.now() - track.at < ms ? track.latest : null;
  }

  /** Writes the numbers. */
  tell(fresh) {
    const now = this.fresh(fresh);
    write(this.#of.phase, now?.phase ?? "–");
    write(this.#of.left, now?.remaining_s == null ? "–" : number(now.remaining_s, 2, "s"));
    write(this.#of.region, now?.region ? this.#size(now) : now?.x == null ? "–" : "not given");
    this.#of.region.title = now?.x != null && !now.region ? `not given by ${this.track.predictor}` : "";
  }

  #size(prediction) {
    const region = regionOf(prediction, 0.95);
    return region === null ? "–" : `${number(2 * region.major)} × ${number(2 * region.minor)} px`;
  }

  #choose() {
    if (!this.select.value) this.close();
    else if (this.track === null) this.open();
    else this.track.choose(this.select.value);
    this.#say();
  }

  #say() {
    const state = this.track?.connection.state;
    this.#status.dataset.state = state ?? "";
    const said = state === undefined ? (this.select.value || !this.offered ? "Connecting…" : "None chosen.") : words(state);
    write(this.#status, this.track?.fault && state !== "open" ? `${said} ${this.track.fault}` : said);
  }
}
