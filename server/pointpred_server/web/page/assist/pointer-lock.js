// The pointer lock: the page gets the counts of the mouse instead of a cursor, until Escape or the page releases it.

/** @typedef {{t: number, dx: number, dy: number, buttons: number}} Counts */

const MOST_COUNTS = 32767;

/** What a browser's counts are. */
export const COUNTS = {
  raw: "Raw counts: your system's pointer acceleration is off.",
  accelerated: "This browser gives only accelerated movement: the gain applies on top of your system's acceleration.",
  unknown: "This browser does not tell whether your system's pointer acceleration is off.",
};

/** Whether this browser can capture the mouse. */
export const isSupported = () => "requestPointerLock" in Element.prototype && "onpointerlockchange" in document;

/** Requests the lock, with raw counts if the browser has them. Needs a click or a key just before. @returns {Promise<keyof typeof COUNTS>} */
async function request(element) {
  try {
    const promise = element.requestPointerLock({ unadjustedMovement: true });
    if (promise === undefined) return "unknown"; // an older browser, which ignores the option
    await promise;
    return "raw";
  } catch (error) {
    if (/** @type {Error} */ (error).name !== "NotSupportedError") throw error;
  }
  await element.requestPointerLock();
  return "accelerated";
}

/** The samples of an event: the coalesced ones if they add up to it. */
function samplesOf(event) {
  const parts = event.getCoalescedEvents?.() ?? [];
  const sum = (field) => parts.reduce((total, one) => total + one[field], 0);
  const complete = ["movementX", "movementY"].every((field) => Math.abs(sum(field) - event[field]) < 0.5);
  return parts.length > 1 && complete ? parts : [event];
}

/** Locks the pointer to an element. */
export class PointerLock {
  #element;
  #handlers;
  #rest = [0, 0];
  #last = -Infinity;
  /** @type {AbortController|null} */ #end = null;

  /**
   * @param {HTMLElement} element
   * @param {{onMove: (counts: Counts[]) => void, onPress: (t: number) => void,
   *   onLock: () => void, onRelease: () => void}} handlers
   */
  constructor(element, handlers) {
    [this.#element, this.#handlers] = [element, handlers];
    document.addEventListener("pointerlockchange", () => (this.active ? this.#onLock() : this.#onRelease()));
  }

  get active() {
    return document.pointerLockElement === this.#element;
  }

  /** Requests the lock. Throws the browser's error if it refuses. @returns {Promise<keyof typeof COUNTS>} */
  lock() {
    return request(this.#element);
  }

  release() {
    if (this.active) document.exitPointerLock();
  }

  #onLock() {
    [this.#rest, this.#last] = [[0, 0], -Infinity];
    this.#end?.abort();
    this.#end = new AbortController();
    const { signal } = this.#end;
    this.#element.addEventListener("pointermove", (event) => this.#onMove(event), { signal });
    this.#element.addEventListener("pointerdown", (event) => event.button === 0 && this.#onPress(event), { signal });
    this.#element.addEventListener("pointerup", (event) => this.#onMove(event), { signal });
    window.addEventListener("keydown", ({ key }) => key === "Escape" && this.release(), { signal });
    this.#handlers.onLock();
  }

  #onRelease() {
    if (this.#end === null) return; // another element had the lock
    this.#end.abort();
    this.#end = null;
    this.#handlers.onRelease();
  }

  #onPress(event) {
    this.#onMove(event);
    this.#handlers.onPress(event.timeStamp / 1000);
  }

  #onMove(event) {
    this.#handlers.onMove(
      samplesOf(event).map((one) => {
        this.#last = Math.max(this.#last, one.timeStamp / 1000);
        const [dx, dy] = this.#round([one.movementX, one.movementY]);
        return { t: this.#last, dx, dy, buttons: one.buttons };
      }),
    );
  }

  /** Whole counts: some browsers divide them by the zoom. The fractions are added to the next ones. */
  #round(counts) {
    return counts.map((count, axis) => {
      const sum = this.#rest[axis] + count,
        whole = Math.trunc(sum);
      this.#rest[axis] = sum - whole;
      return Math.max(-MOST_COUNTS, Math.min(MOST_COUNTS, whole));
    });
  }
}
