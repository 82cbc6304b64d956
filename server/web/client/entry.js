// What the page itself sees of observed elements, with or without a service: the keyboard's focus, a finger, the mouse over one.

const MOST_FINGERS = 16; // a finger whose end was never heard gives way to a new one

/**
 * Proposes an observed element when the keyboard's focus or a finger comes to it, and when the mouse enters it while
 * nobody else says so, or comes to it from outside the page. One that is proposed when the mouse is in it stays so until
 * the mouse leaves it. Of elements inside each other the innermost counts.
 */
export class Entry {
  #observed; #proposals; #alone = true; #under = null; #focused = null; #fingers = new Map(); #held = new Map();

  /**
   * @param {EventTarget} element whose events are heard
   * @param {{pointer: boolean, observed: (element: Element) => string|undefined, left: () => void,
   *   proposals: import("./proposals.js").Proposals, signal: AbortSignal}} told `observed`: the id of an observed element;
   *   `left`: the mouse goes where its moves are not heard, or the person to another window; `pointer`: false, only the focus counts
   */
  constructor(element, { pointer, observed, left, proposals, signal }) {
    [this.#observed, this.#proposals] = [observed, proposals];
    const hear = (name, act) => element.addEventListener(name, (event) => act(event.composedPath()[0], event), { signal, capture: true, passive: true });
    hear("focusin", (target, { timeStamp }) => this.#look(timeStamp, { focused: target instanceof Element && target.matches(":focus-visible") ? target : null }));
    hear("focusout", (_, { timeStamp, relatedTarget }) => relatedTarget || this.#look(timeStamp, { focused: null }));
    if (!pointer) return;
    const touch = ({ pointerType }) => pointerType === "touch";
    const within = (other) => other !== null && (!(element instanceof Node) || element.contains(other));
    const over = (event, under, gone) => {
      if (touch(event)) return;
      this.#look(event.timeStamp, { under });
      if (gone) left();
    };
    hear("pointerover", (target, event) => over(event, target, "contentWindow" in target)); // a frame hears the moves in it itself
    hear("pointerout", (_, event) => within(event.relatedTarget) || over(event, null, true));
    window.addEventListener("blur", left, { signal });
    hear("pointerdown", (target, event) => touch(event) && this.#touch(event, target));
    for (const end of ["pointerup", "pointercancel"])
      hear(end, (_, event) => touch(event) && this.#touch(event, null));
  }

  /** Whether nobody else says what is entered. @param {boolean} alone */
  set alone(alone) {
    this.#alone = alone;
    this.look();
  }

  /** Looks again: an element is observed, or no longer. */
  look() {
    this.#look(performance.now(), {});
  }

  #look(timeStamp, { under = this.#under, focused = this.#focused }) {
    const arrives = this.#under === null && under !== null; // from outside: to a service its first event is no entry
    [this.#under, this.#focused] = [under, focused];
    this.#hold("entered", "entered", this.#around(under), timeStamp / 1000, this.#alone || arrives);
    this.#hold("focus", "focus", this.#around(focused), timeStamp / 1000);
    for (const [finger, element] of [...this.#fingers]) this.#hold(`touch ${finger}`, "touch", this.#around(element), timeStamp / 1000);
  }

  /** A finger is put on an element, or lifted: each touches what it touches until it is itself lifted. */
  #touch({ pointerId, timeStamp }, element) {
    const oldest = this.#fingers.size === MOST_FINGERS && element && !this.#fingers.has(pointerId) ? this.#fingers.keys().next().value : pointerId;
    for (const [finger, touched] of [[oldest, null], [pointerId, element]]) {
      if (touched) this.#fingers.set(finger, touched);
      else this.#fingers.delete(finger);
      this.#hold(`touch ${finger}`, "touch", this.#around(touched), timeStamp / 1000);
    }
  }

  /** The innermost observed element around one. @returns {{id: string, element: Element}|null} */
  #around(element) {
    for (let one = element; one instanceof Element; one = one.parentElement ?? one.getRootNode().host) {
      const id = this.#observed(one);
      if (id !== undefined) return { id, element: one };
    }
    return null;
  }

  #hold(source, reason, now, t, sure = true) {
    const before = this.#held.get(source);
    if (before?.id === now?.id) return;
    this.#held.delete(source);
    const begins = now !== null && (sure || this.#proposals.stands(now.id));
    if (begins) this.#held.set(source, now);
    if (before) this.#proposals.end(source, before.id, { t });
    if (begins) this.#proposals.begin(source, { type: "choice", ...now, p: 1, action: "propose", t, reason });
  }
}
