// The pointer over an element of the page.

import { PointerStream } from "../../lib/client/pointer-stream.js";

/** @typedef {import("../../lib/index.d.ts").EventRow} Row */

/** The upper left corner of an element inside its border, where the drawing on a canvas begins. @param {HTMLElement} element */
function corner(element) {
  const { left, top } = element.getBoundingClientRect();
  return [left + element.clientLeft, top + element.clientTop];
}

/**
 * Listens to the pointer over an element.
 * @param {HTMLElement} element
 * @param {{
 *   onMove: (rows: Row[]) => void,
 *   onPress?: (row: Row, event: PointerEvent) => void,
 *   onRelease?: (row: Row, event: PointerEvent) => void,
 * }} handlers `onMove` is called with every sample, presses and releases included; the others are called after it
 * @param {HTMLElement} frame positions are relative to the upper left corner inside its border
 */
export function listenToPointer(element, { onMove, onPress, onRelease }, frame = element) {
  /** @param {Row[]} rows @returns {Row[]} */
  const placed = (rows) => {
    const [left, top] = corner(frame);
    return rows.map(([t, x, y, ...others]) => [t, x - left, y - top, ...others]);
  };
  const stream = new PointerStream(element, {
    raw: false,
    onRows: (rows) => onMove(placed(rows)),
    signal: new AbortController().signal,
  });
  /** @param {PointerEvent} event @param {((row: Row, event: PointerEvent) => void)|undefined} handle */
  function click(event, handle) {
    if (!event.isPrimary) return;
    stream.flush();
    const { timeStamp, clientX, clientY, buttons } = event;
    handle?.(placed([[timeStamp / 1000, clientX, clientY, null, null, buttons]])[0], event);
  }
  element.addEventListener("pointerdown", (event) => {
    if (event.isPrimary && event.pointerType !== "mouse")
      /** @type {Element} */ (event.target).setPointerCapture(event.pointerId);
    click(event, onPress);
  });
  element.addEventListener("pointerup", (event) => click(event, onRelease));
}
