// Choices that the page makes itself, with or without a service: keyboard focus, touch, and the mouse over an element.

const MOST_FINGERS = 16; // beyond that the oldest is forgotten: its end may never have been reported

/**
 * What the page chooses.
 * @template Id
 * @typedef {{type: "choice", id: Id, element: Element, p: number, action: "propose", t: number, reason: "entered"|"focus"|"touch"}} PageChoice
 */

/**
 * What takes the choices.
 * @template Id
 * @typedef {{has: (id: Id) => boolean, begin: (source: string, choice: PageChoice<Id>) => void,
 *   end: (source: string, id: Id, fields: {t: number}) => void}} Taker
 */

/**
 * The innermost observed element that contains one.
 * @template Id
 * @param {Element|null} element @param {(element: Element) => Id|undefined} idOf the id of an observed element
 * @returns {{id: Id, element: Element}|null}
 */
export function closest(element, idOf) {
  for (
    let one = element;
    one instanceof Element;
    one = one.parentElement ?? /** @type {ShadowRoot} */ (one.getRootNode()).host
  ) {
    const id = idOf(one);
    if (id !== undefined) return { id, element: one };
  }
  return null;
}

/**
 * Proposes an observed element when it gets the keyboard focus or is touched. It also proposes one that the mouse enters,
 * but only while the service does not, or when the mouse comes from outside the page. An element that is proposed while the mouse is in it stays
 * proposed until the mouse leaves. Of nested elements the innermost counts.
 * @template Id
 */
export class PageChoices {
  #idOf;
  #proposals;
  #detectsEntry = true;
  /** @type {Element|null} */ #under = null;
  /** @type {Element|null} */ #focused = null;
  #fingers = new Map();
  #current = new Map();

  /**
   * @param {EventTarget} element whose events are listened to
   * @param {{pointer: boolean, idOf: (element: Element) => Id|undefined, onLeave: () => void,
   *   proposals: Taker<Id>, signal: AbortSignal}} options `idOf`: the id of an observed element;
   *   `onLeave`: the mouse goes where its moves are not reported, or the window loses the focus; `pointer` false: only focus counts
   */
  constructor(element, { pointer, idOf, onLeave, proposals, signal }) {
    [this.#idOf, this.#proposals] = [idOf, proposals];
    const listen = (name, handle) =>
      element.addEventListener(name, (event) => handle(event.composedPath()[0], event), {
        signal,
        capture: true,
        passive: true,
      });
    listen("focusin", (target, { timeStamp }) =>
      this.#update(timeStamp, {
        focused: target instanceof Element && target.matches(":focus-visible") ? target : null,
      }),
    );
    listen(
      "focusout",
      (_, { timeStamp, relatedTarget }) => relatedTarget || this.#update(timeStamp, { focused: null }),
    );
    if (!pointer) return;
    const isTouch = ({ pointerType }) => pointerType === "touch";
    const isInside = (other) => other !== null && (!(element instanceof Node) || element.contains(other));
    const enter = (event, under, leaves) => {
      if (isTouch(event)) return;
      this.#update(event.timeStamp, { under });
      if (leaves) onLeave();
    };
    listen("pointerover", (target, event) => enter(event, target, "contentWindow" in target)); // moves over a frame are reported inside it only
    listen("pointerout", (_, event) => isInside(event.relatedTarget) || enter(event, null, true));
    window.addEventListener("blur", onLeave, { signal });
    listen("pointerdown", (target, event) => isTouch(event) && this.#touch(event, target));
    for (const end of ["pointerup", "pointercancel"])
      listen(end, (_, event) => isTouch(event) && this.#touch(event, null));
  }

  /** Whether the page proposes what the mouse enters, because the service does not. @param {boolean} detects */
  set detectsEntry(detects) {
    this.#detectsEntry = detects;
    this.update();
  }

  /** Updates the choices after an element has been observed or unobserved. */
  update() {
    this.#update(performance.now(), {});
  }

  #update(timeStamp, { under = this.#under, focused = this.#focused }) {
    const arrives = this.#under === null && under !== null; // for the service, the first event of a pointer enters nothing
    [this.#under, this.#focused] = [under, focused];
    this.#choose("entered", under, timeStamp, this.#detectsEntry || arrives);
    this.#choose("focus", focused, timeStamp);
    for (const [finger, element] of [...this.#fingers]) this.#choose(`touch ${finger}`, element, timeStamp);
  }

  /** A finger touches an element, or is lifted (null); it counts for the element it came down on until then. */
  #touch({ pointerId, timeStamp }, element) {
    const oldest =
      this.#fingers.size === MOST_FINGERS && element && !this.#fingers.has(pointerId)
        ? this.#fingers.keys().next().value
        : pointerId;
    for (const [finger, touched] of [
      [oldest, null],
      [pointerId, element],
    ]) {
      if (touched) this.#fingers.set(finger, touched);
      else this.#fingers.delete(finger);
      this.#choose(`touch ${finger}`, touched, timeStamp);
    }
  }

  /** Sets the element of a source, such as "touch 2"; `begins` false: only if its target is already proposed. */
  #choose(source, element, timeStamp, begins = true) {
    const target = closest(element, this.#idOf),
      before = this.#current.get(source),
      [reason] = /** @type {["entered"|"focus"|"touch"]} */ (source.split(" ")),
      t = timeStamp / 1000;
    if (before?.id === target?.id) return;
    this.#current.delete(source);
    const chosen = target !== null && (begins || this.#proposals.has(target.id));
    if (chosen) this.#current.set(source, target);
    if (before) this.#proposals.end(source, before.id, { t });
    if (chosen) this.#proposals.begin(source, { type: "choice", ...target, p: 1, action: "propose", t, reason });
  }
}
