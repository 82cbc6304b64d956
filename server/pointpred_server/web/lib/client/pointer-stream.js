// The pointer events of an element: every coalesced sample of the primary pointer, in the order of time.

const AHEAD_MS = 10_000; // an event stamped so much later than now has a clock of its own
const LAG_S = 0.002; // a dispatch that spans more comes from a page that lags behind

/** Listens to pointer events and passes them on as rows. */
export class PointerStream {
  /** What turns positions in the viewport into positions on the screen, px. */ offset = [0, 0];
  #onScreen;
  #accepts;
  #onRows;
  #last = [0, 0, 0];
  #pending = [];
  #clicks = new Map();
  #turn = new MessageChannel();

  /**
   * @param {EventTarget} element
   * @param {{onScreen?: boolean, raw?: boolean, accepts?: (event: PointerEvent) => boolean, onRows: (rows: import("../index.d.ts").EventRow[]) => void,
   *   signal: AbortSignal}} options `onScreen`: positions on the screen instead of the viewport; `raw` false: samples come once a frame
   *   instead of at once, which costs less; `accepts`: which events count
   */
  constructor(element, { onScreen = false, raw = true, accepts = () => true, onRows, signal }) {
    [this.#onScreen, this.#accepts, this.#onRows] = [onScreen, accepts, onRows];
    this.#turn.port1.onmessage = () => this.flush();
    signal.addEventListener("abort", () => this.#turn.port1.close());
    const settings = { signal, capture: true, passive: true };
    const moves = raw && "onpointerrawupdate" in window ? "pointerrawupdate" : "pointermove";
    for (const name of [moves, "pointerdown", "pointerup"])
      element.addEventListener(name, (event) => this.#add(event), settings);
    element.addEventListener("pointercancel", (event) => this.#cancel(event), settings);
  }

  /**
   * Passes the pending rows on, sorted by time. After a stall of the page, the browser merges moves from before a click
   * with moves from after it and delivers them before the click. So rows wait until the events in the queue are delivered.
   */
  flush() {
    const rows = this.#pending.splice(0),
      clicks = this.#clicks;
    if (rows.length === 0) return;
    const side = (row) => {
      // at the time of a click: 0 before it, 1 the click itself, 2 after it
      const click = clicks.get(row[0]);
      if (click === undefined || row === click) return click === undefined ? 0 : 1;
      return row[5] === click[5] ? 2 : 0;
    };
    if (rows.length > 1) rows.sort((one, other) => one[0] - other[0] || side(one) - side(other));
    clicks.clear();
    this.#onRows(rows);
  }

  #add(event) {
    if (!event.isPrimary || !this.#accepts(event)) return;
    this.offset = [event.screenX - event.clientX, event.screenY - event.clientY];
    const coalesced = event.getCoalescedEvents?.() ?? [],
      now = performance.now();
    const rows = (coalesced.length ? coalesced : [event]).map((one) => [
      (one.timeStamp > now + AHEAD_MS ? now : one.timeStamp) / 1000,
      this.#onScreen ? one.screenX : one.clientX,
      this.#onScreen ? one.screenY : one.clientY,
      null,
      null,
      one.buttons,
    ]);
    this.#last = rows[rows.length - 1];
    const waiting = this.#pending.length > 0;
    this.#pending.push(...rows);
    if (event.type === "pointerdown" || event.type === "pointerup") this.#clicks.set(this.#last[0], this.#last);
    if (!waiting && this.#last[0] - rows[0][0] <= LAG_S) this.flush();
    else if (!waiting) this.#turn.port2.postMessage(null);
  }

  /** A cancelled touch has no position: it ends where it was. */
  #cancel(event) {
    if (!event.isPrimary || !this.#accepts(event)) return;
    this.flush();
    const [t, x, y] = this.#last;
    this.#onRows([[Math.max(t, event.timeStamp / 1000), x, y, null, null, 0]]);
  }
}
