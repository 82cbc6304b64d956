// Proposals without registered elements: the places of a page where movements of the user ended before.

import { needDocument } from "../client/document.js";
import { PointerStream } from "../client/pointer-stream.js";
import { HIGHEST, LOWEST, USUAL } from "../laws/targets/decision.js";
import { claimed, isRefused, REMAINING_S } from "../prediction/row.js";
import { attempt, isAbort } from "./firing-ledger.js";
import { checked } from "./options.js";
import { canFollow } from "./register.js";

/** @typedef {import("../prediction/chooser.js").PlaceChooser} Chooser */

const DEFAULTS = { precision: USUAL[0], page: undefined, person: "", store: undefined };
const KNOWN = { precision: [LOWEST[0], HIGHEST[0]], page: ["a string"], person: ["a string"], store: ["a string"] };

/**
 * `onPlace` with a predictor that learns places. It calls `callback` when the user is heading for a place where movements ended before. Throws a TypeError for options that
 * cannot be used.
 * @param {(options?: {person: string}) => Promise<import("../prediction/pipeline.js").Pipeline>} build a pipeline of that predictor
 * @returns {(callback: (firing: import("../index.d.ts").PlaceFiring) => unknown, options?: import("../index.d.ts").PlaceOptions) =>
 *   import("../index.d.ts").PlaceHandle}
 */
export const onPlaceWith = (build) =>
  function onPlace(callback, options) {
    needDocument("onPlace");
    if (typeof callback !== "function") throw new TypeError(`onPlace needs a function to call, received ${callback}`);
    const checkedOptions = checked(options, { ...DEFAULTS, page: location.pathname }, KNOWN);
    if (!canFollow()) return { ready: Promise.resolve(), person: "", forget() {}, stop() {} };
    return new Places(build, callback, checkedOptions);
  };

/** What the page's store answers; undefined where the browser refuses it: cookies are blocked, or it is full. */
function inStorage(use) {
  try {
    return use(localStorage);
  } catch {
    return undefined;
  }
}

/** Follows the pointer, and proposes places of the page; scrolling moves them. */
class Places {
  /** Settles when the predictor is loaded. @type {Promise<void>} */ ready;
  #build;
  #callback;
  #options;
  /** @type {import("../prediction/pipeline.js").Pipeline|null} */ #pipeline = null;
  /** @type {Chooser|null} */ #chooser = null;
  #firings = new Map();
  #stop = new AbortController();

  constructor(build, callback, options) {
    [this.#build, this.#callback, this.#options] = [build, callback, options];
    this.ready = this.#load();
    this.ready.catch(reportError);
    const { signal } = this.#stop;
    new PointerStream(window, {
      raw: false,
      accepts: ({ pointerType }) => pointerType !== "touch",
      onRows: (rows) => this.#follow(rows),
      signal,
    });
    window.addEventListener("scroll", () => this.#enter(), { signal, passive: true });
    window.addEventListener("pagehide", () => this.#save(), { signal });
    window.addEventListener("storage", (event) => this.#follows(event) && this.#forget(), { signal });
  }

  /** What finished movements have taught of the person. @returns {string} */
  get person() {
    return this.#pipeline?.person ?? this.#options.person;
  }

  /** Forgets the person, here and in what was stored. */
  forget() {
    const { store } = this.#options;
    if (store !== undefined) inStorage((storage) => storage.removeItem(store));
    this.#forget();
  }

  /** Stops it. */
  stop() {
    this.#stop.abort();
    this.#withdraw();
    attempt(() => this.#save());
  }

  /** Whether another page has removed the person from the store: its user wants to be forgotten. @param {StorageEvent} event */
  #follows({ storageArea, key, newValue }) {
    const { store } = this.#options;
    return (
      store !== undefined &&
      inStorage((storage) => storage === storageArea) === true &&
      (key === null || (key === store && newValue === null))
    );
  }

  #forget() {
    this.#options.person = "";
    if (this.#pipeline === null) return;
    this.#pipeline.forget();
    this.#enter();
  }

  async #load() {
    const [{ PlaceChooser }, pipeline] = await Promise.all([import("../prediction/chooser.js"), this.#known()]);
    this.#pipeline = pipeline;
    this.#chooser = new PlaceChooser(pipeline, { precision: this.#options.precision });
    this.#enter();
  }

  /** A pipeline that knows the person; one that knows nobody where the string is of another version. */
  async #known() {
    const build = this.#build;
    const { store } = this.#options;
    const stored = () => (store === undefined ? "" : inStorage((storage) => storage.getItem(store)));
    const person = () => this.#options.person || stored() || "";
    const given = person();
    const pipeline = await build({ person: given }).catch(() => build());
    return person() === given ? pipeline : build(); // forgotten meanwhile
  }

  /** The places of the page are where it has been scrolled to; the movement is over. */
  #enter() {
    if (this.#pipeline === null) return;
    this.#withdraw();
    this.#pipeline.reset(); // one that goes on would stay where the page was
    this.#pipeline.enter(this.#options.page, -window.scrollX, -window.scrollY);
  }

  /** @param {import("../index.d.ts").EventRow[]} rows */
  #follow(rows) {
    if (this.#pipeline === null) return;
    for (const [t, x, y, , , buttons] of rows) {
      const row = [t, x, y, NaN, NaN, buttons],
        answer = this.#pipeline.advance(row);
      if (!isRefused(answer))
        for (const choice of /** @type {Chooser} */ (this.#chooser).update()) this.#turn(choice, answer, t);
    }
  }

  #turn({ action, id, place, reason, p }, answer, t) {
    if (action === "retract") return this.#end(id);
    const end = new AbortController();
    const firing = {
      id,
      place,
      reason,
      p,
      t,
      remaining_s: reason === "predicted" ? claimed(answer[REMAINING_S]) : null,
      signal: end.signal,
    };
    const cleanup = attempt(
      () => this.#callback(firing),
      (error) => isAbort(error) || reportError(error),
    );
    this.#firings.set(id, { end, cleanup: typeof cleanup === "function" ? cleanup : null });
  }

  #end(id) {
    const { end, cleanup } = this.#firings.get(id) ?? {};
    this.#firings.delete(id);
    end?.abort();
    if (cleanup) attempt(cleanup);
  }

  /** Nothing is proposed any more. */
  #withdraw() {
    for (const id of [...this.#firings.keys()]) this.#end(id);
    this.#chooser?.reset();
  }

  /** Finishes the movement, and keeps what it has taught. */
  #save() {
    const { store } = this.#options,
      pipeline = this.#pipeline;
    if (pipeline === null || store === undefined) return;
    this.#withdraw();
    pipeline.reset();
    if (pipeline.person) inStorage((storage) => storage.setItem(store, pipeline.person));
  }
}
