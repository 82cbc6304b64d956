// What the live view shows of one predictor: its choice, its connection, its parameters, phase, time left and region.

import { number, write } from "../page/elements.js";
import { Parameters } from "./parameters.js";
import { CalmRegions, shown } from "../drawing/regions.js";
import { Status } from "../service/status.js";
import { Track, words } from "../service/track.js";

const GONE_MS = 200; // after the last answer nothing of it is left
const FADE_MS = 80;

/** How strongly something is drawn that came so many ms ago: it fades before it goes. */
export const opacityAfter = (ms) => Math.max(0, Math.min(1, (GONE_MS - ms) / FADE_MS));

/** A prediction as it is to be drawn, if it says where a movement ends. @returns {import("./picture.js").Mark|null} */
export function markOf(prediction, calm, now, opacity, still = false) {
  const there = prediction !== null && prediction.x !== null && prediction.phase !== "still" && opacity > 0;
  const regions = calm.follow(there ? prediction : null, now, still);
  return there ? { prediction, regions, opacity } : null;
}

/** The length and breadth of a 50 % region, px, in words; it is never given as larger than what is drawn of it. */
export function sizeOf({ regions }, { clientWidth, clientHeight }, scale = 1) {
  if (regions === null) return "not given";
  const [width, height] = [clientWidth / scale, clientHeight / scale];
  if (!shown(regions, width, height)) return `over ${Math.floor(Math.hypot(width, height) / 100) * 100}`;
  const { major, minor } = regions.inner;
  return [major, minor].map((half) => number(Number((2 * half).toPrecision(2)))).join(" × ");
}

/** One predictor's card; `track` is null while none is chosen or the view is closed. */
export class LiveCard {
  /** @type {Track|null} */ track = null;
  /** As the service describes them. @type {object[]} */ #listed = [];
  #card; #status; #about; #of; #told; #options; #calm = new CalmRegions();

  /**
   * @param {HTMLElement} card @param {HTMLDetailsElement} parameters
   * @param {(prediction: object, name: string) => void} predicted hears of each, and whose it is
   * @param {{choice?: (one: object) => void}} told @param {import("/pointpred.js").Options} options of the connection
   */
  constructor(card, parameters, predicted, told = {}, options = {}) {
    this.#options = options;
    this.#card = card;
    this.select = card.querySelector("select");
    this.#status = new Status(card.querySelector(".connection"));
    this.#about = card.querySelector(".about");
    this.#of = Object.fromEntries(["phase", "left", "region"].map((of) => [of, card.querySelector(`[data-of=${of}]`)]));
    this.#told = { prediction: (one) => predicted(one, this.track.speaker), state: () => this.#say(), error: (one) => this.#refused(one), ...told };
    this.parameters = new Parameters(parameters, () => this.#configure());
    this.select.addEventListener("change", () => this.#choose());
  }

  get offered() {
    return this.#listed.length > 0;
  }

  /** Offers predictors, the chosen one first. @param {object[]} predictors */
  offer(predictors) {
    this.#listed = predictors;
    this.#describe();
  }

  /** Connects with the predictor chosen, if any. */
  open() {
    const parameters = this.parameters.values;
    if (this.track === null && this.select.value) this.track = new Track(this.select.value, this.#told, { ...this.#options, parameters });
    this.#say();
  }

  close() {
    this.track?.close();
    this.track = null;
  }

  /** What is to be drawn of the newest prediction: nothing once no answers come, or where the movement is over. */
  mark(now) {
    const track = this.track;
    const lives = track !== null && track.connection.state === "open";
    return markOf(lives ? track.latest : null, this.#calm, now, lives ? opacityAfter(performance.now() - track.at) : 0);
  }

  /** Writes the size of the region that is drawn in a picture. @param {import("./picture.js").Mark|null} mark */
  tellRegion(mark, canvas) {
    const inner = mark?.regions?.inner;
    this.#of.region.dataset.px = inner === undefined ? "" : `${2 * inner.major} ${2 * inner.minor}`;
    write(this.#of.region, mark === null ? "–" : sizeOf(mark, canvas));
  }

  /** Writes the other numbers. @param {import("./picture.js").Mark|null} mark */
  tell(mark) {
    write(this.#of.phase, mark?.prediction.phase ?? "–");
    write(this.#of.left, number(mark?.prediction.remaining_s, 2, "s"));
  }

  #choose() {
    this.#describe();
    if (!this.select.value) this.close();
    else if (this.track === null) this.open();
    else this.track.choose(this.select.value);
    this.#say();
  }

  /** What the predictor does, in its own words, and its parameters. */
  #describe() {
    const chosen = this.#listed.find(({ name }) => name === this.select.value) ?? null;
    write(this.#about, chosen?.title ? `${chosen.title[0].toUpperCase()}${chosen.title.slice(1)}.` : "");
    this.parameters.show(chosen);
  }

  #configure() {
    this.track?.configure(this.select.value, this.parameters.values);
  }

  #refused({ message, path }) {
    if ((path ?? "").startsWith("$.parameters")) this.parameters.refused(message, path);
    this.#say();
  }

  #say() {
    const predictor = this.select.value;
    this.#card.dataset.chosen = predictor;
    const without = predictor || !this.offered ? words("connecting") : "None chosen.";
    this.#status.say(this.track?.connection.state, { predictor, fault: this.track?.fault, without });
  }
}
