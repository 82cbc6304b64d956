// The mouse lent to the page: raw counts instead of a cursor, until Escape or the page gives it back.

/** What is to be said of the counts that a browser gives. */
export const KINDS = {
  raw: "Raw counts: your system's pointer acceleration is off.",
  adjusted: "This browser gives only accelerated movement: the gain works on top of your system's acceleration.",
  unknown: "This browser does not say whether your system's pointer acceleration is off.",
};

/** Whether this browser can lend its mouse at all. */
export const lendable = () => "requestPointerLock" in Element.prototype && "onpointerlockchange" in document;

/** Asks for the mouse, raw if that can be had; says which of `KINDS` it is. Needs a click or a key just before. */
async function request(element) {
  try {
    const asked = element.requestPointerLock({ unadjustedMovement: true });
    if (asked === undefined) return "unknown"; // a browser from before promises, and before the option
    await asked;
    return "raw";
  } catch (error) {
    if (error.name !== "NotSupportedError") throw error;
  }
  await element.requestPointerLock();
  return "adjusted";
}

/** The samples of one dispatch: the coalesced ones where they add up to it. */
function samples(event) {
  const parts = event.getCoalescedEvents?.() ?? [];
  const sum = (of) => parts.reduce((total, one) => total + one[of], 0);
  const whole = ["movementX", "movementY"].every((of) => Math.abs(sum(of) - event[of]) < 0.5);
  return parts.length > 1 && whole ? parts : [event];
}

/** Lends the mouse to an element. */
export class Lock {
  #element; #told; #rest = [0, 0]; #last = -Infinity; #end = null;

  /**
   * @param {HTMLElement} element
   * @param {{moved: (counts: {t: number, dx: number, dy: number, buttons: number}[]) => void, pressed: (t: number) => void,
   *   taken: () => void, given: () => void}} told `given`: the mouse is the person's again
   */
  constructor(element, told) {
    [this.#element, this.#told] = [element, told];
    document.addEventListener("pointerlockchange", () => (this.held ? this.#taken() : this.#given()));
  }

  get held() {
    return document.pointerLockElement === this.#element;
  }

  /** Asks for the mouse; says which of `KINDS`, or throws the browser's words. */
  take() {
    return request(this.#element);
  }

  give() {
    if (this.held) document.exitPointerLock();
  }

  #taken() {
    [this.#rest, this.#last] = [[0, 0], -Infinity];
    this.#end?.abort();
    this.#end = new AbortController();
    const { signal } = this.#end;
    this.#element.addEventListener("pointermove", (event) => this.#moved(event), { signal });
    this.#element.addEventListener("pointerdown", (event) => event.button === 0 && this.#pressed(event), { signal });
    this.#element.addEventListener("pointerup", (event) => this.#moved(event), { signal });
    window.addEventListener("keydown", ({ key }) => key === "Escape" && this.give(), { signal });
    this.#told.taken();
  }

  #given() {
    if (this.#end === null) return; // it was another element's
    this.#end.abort();
    this.#end = null;
    this.#told.given();
  }

  #pressed(event) {
    this.#moved(event);
    this.#told.pressed(event.timeStamp / 1000);
  }

  #moved(event) {
    this.#told.moved(samples(event).map((one) => {
      this.#last = Math.max(this.#last, one.timeStamp / 1000);
      const [dx, dy] = this.#whole([one.movementX, one.movementY]);
      return { t: this.#last, dx, dy, buttons: one.buttons };
    }));
  }

  /** Whole counts: some browsers divide them by the zoom. */
  #whole(moved) {
    return moved.map((each, axis) => {
      const sum = this.#rest[axis] + each, whole = Math.trunc(sum);
      this.#rest[axis] = sum - whole;
      return Math.max(-32767, Math.min(32767, whole));
    });
  }
}
