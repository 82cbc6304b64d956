// The pointer events of the browser client: every coalesced sample of the primary pointer, in the order of its time.

const LAG_S = 0.002; // a dispatch that spans more comes from a page that lags behind

/** Hears the pointer events of an element and passes their rows on. */
export class PointerStream {
  /** What is to be added to positions in the viewport for those on the screen, px. */ offset = [0, 0];
  #onScreen; #passed; #last = [0, 0, 0]; #gathered = []; #clicks = new Map(); #turn = new MessageChannel();

  /**
   * @param {EventTarget} element
   * @param {{onScreen: boolean, passed: (rows: import("../pointpred.js").EventRow[]) => void, signal: AbortSignal}} told
   */
  constructor(element, { onScreen, passed, signal }) {
    [this.#onScreen, this.#passed] = [onScreen, passed];
    this.#turn.port1.onmessage = () => this.flush();
    signal.addEventListener("abort", () => this.#turn.port1.close());
    const settings = { signal, capture: true, passive: true };
    const moves = "onpointerrawupdate" in window ? "pointerrawupdate" : "pointermove";
    for (const name of [moves, "pointerdown", "pointerup"]) element.addEventListener(name, (event) => this.#pointed(event), settings);
    element.addEventListener("pointercancel", (event) => this.#cancelled(event), settings);
  }

  /**
   * Passes on what was gathered in the order of its times. After a stall of the page, the browser merges moves from before
   * a click with moves from after it, and delivers them before the click: so what it still holds is awaited first.
   */
  flush() {
    const rows = this.#gathered.splice(0), clicks = this.#clicks;
    if (rows.length === 0) return;
    const side = (row) => { // of a click at the same time: before it, the click itself, after it
      const click = clicks.get(row[0]);
      if (click === undefined || row === click) return click === undefined ? 0 : 1;
      return row[5] === click[5] ? 2 : 0;
    };
    if (rows.length > 1) rows.sort((one, other) => one[0] - other[0] || side(one) - side(other));
    clicks.clear();
    this.#passed(rows);
  }

  #pointed(event) {
    if (!event.isPrimary) return;
    this.offset = [event.screenX - event.clientX, event.screenY - event.clientY];
    const whole = event.getCoalescedEvents?.() ?? [];
    const rows = (whole.length ? whole : [event]).map((one) => [one.timeStamp / 1000,
      this.#onScreen ? one.screenX : one.clientX, this.#onScreen ? one.screenY : one.clientY, null, null, one.buttons]);
    this.#last = rows[rows.length - 1];
    const behind = this.#gathered.length > 0;
    this.#gathered.push(...rows);
    if (event.type === "pointerdown" || event.type === "pointerup") this.#clicks.set(this.#last[0], this.#last);
    if (!behind && this.#last[0] - rows[0][0] <= LAG_S) this.flush();
    else if (!behind) this.#turn.port2.postMessage(null);
  }

  /** A cancelled touch has no place: it ends where it was. */
  #cancelled(event) {
    if (!event.isPrimary) return;
    this.flush();
    const [t, x, y] = this.#last;
    this.#passed([[Math.max(t, event.timeStamp / 1000), x, y, null, null, 0]]);
  }
}
