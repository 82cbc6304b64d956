// The pointer over an element, every sample the browser knows: rows [t, x, y, dx, dy, buttons] as the service wants.

const PICTURE = "pointerrawupdate" in window ? "pointerrawupdate" : "pointermove";

/** One sample relative to a corner of the viewport; a page sees no device counts. */
function row(event, [left, top]) {
  return [event.timeStamp / 1000, event.clientX - left, event.clientY - top, null, null, event.buttons];
}

/** Where an element's inside begins: what is drawn on a canvas is drawn within its border. */
function corner(element) {
  const { left, top } = element.getBoundingClientRect();
  return [left + element.clientLeft, top + element.clientTop];
}

/**
 * Follows the pointer over an element; positions are relative to the upper left corner of its inside.
 * @param {HTMLElement} element
 * @param {{
 *   moved: (rows: number[][]) => void,
 *   pressed?: (row: number[], event: PointerEvent) => void,
 *   released?: (row: number[], event: PointerEvent) => void,
 * }} told `moved` hears of every sample, presses and releases included; the others after it
 * @returns {() => void} ends it
 */
export function follow(element, told) {
  const end = new AbortController();
  const listen = (kind, handle) => element.addEventListener(kind, handle, { signal: end.signal });
  let last = -Infinity;

  function samples(event) {
    const from = corner(element);
    const coalesced = event.getCoalescedEvents?.() ?? [];
    const rows = (coalesced.length ? coalesced : [event]).map((each) => row(each, from));
    const fresh = rows.filter(([t]) => t >= last); // a press may be reported before the samples that led to it
    if (fresh.length) last = fresh[fresh.length - 1][0];
    return fresh;
  }

  function click(event, callback) {
    const rows = samples(event);
    if (!rows.length) rows.push([last, ...row(event, corner(element)).slice(1)]);
    told.moved(rows);
    callback?.(rows[rows.length - 1], event);
  }

  listen(PICTURE, (event) => {
    const rows = event.isPrimary ? samples(event) : [];
    if (rows.length) told.moved(rows);
  });
  listen("pointerdown", (event) => {
    if (!event.isPrimary) return;
    if (event.pointerType !== "mouse") element.setPointerCapture(event.pointerId);
    click(event, told.pressed);
  });
  listen("pointerup", (event) => event.isPrimary && click(event, told.released));
  return () => end.abort();
}
