// The pointer over an element: every coalesced sample as a row [t, x, y, dx, dy, buttons] of the service.

/** @typedef {import("../../lib/index.d.ts").EventRow} Row */

/** A sample relative to a corner of the viewport; browsers report no device counts. @param {PointerEvent} event @param {number[]} corner @returns {Row} */
function row(event, [left, top]) {
  return [event.timeStamp / 1000, event.clientX - left, event.clientY - top, null, null, event.buttons];
}

/** The upper left corner of an element inside its border, where the drawing on a canvas begins. */
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
  let last = -Infinity;

  function samples(event) {
    const from = corner(frame);
    const coalesced = event.getCoalescedEvents?.() ?? [];
    const rows = (coalesced.length ? coalesced : [event]).map((each) => row(each, from));
    const fresh = rows.filter(([t]) => t >= last); // a press may be reported before the samples that led to it
    if (fresh.length) last = fresh[fresh.length - 1][0];
    return fresh;
  }

  function click(event, handle) {
    const rows = samples(event);
    if (!rows.length) rows.push([last, ...row(event, corner(frame)).slice(1)]);
    onMove(rows);
    handle?.(rows[rows.length - 1], event);
  }

  element.addEventListener("pointermove", (event) => {
    const rows = event.isPrimary ? samples(event) : [];
    if (rows.length) onMove(rows);
  });
  element.addEventListener("pointerdown", (event) => {
    if (!event.isPrimary) return;
    if (event.pointerType !== "mouse") /** @type {Element} */ (event.target).setPointerCapture(event.pointerId);
    click(event, onPress);
  });
  element.addEventListener("pointerup", (event) => event.isPrimary && click(event, onRelease));
}
