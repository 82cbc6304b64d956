// Events and messages that wait until there is a connection, in their order.

const TARGETS_PER_UNIT = 64; // the service counts an event once more for every so many targets
const UNITS_FOR_PLACES = 7; // and so many times more where places are asked for
const FLUSH_SHARE = 0.75; // of what the service accepts in a second: the rest is left for new events

/** Holds a bounded number of items; the oldest are dropped first. */
export class EventQueue {
  /** Number of events dropped. */ dropped = 0;
  #items = [];
  #capacity;

  /** @param {number} capacity items */
  constructor(capacity) {
    this.#capacity = capacity;
  }

  get length() {
    return this.#items.length;
  }

  /** @param {(import("../index.d.ts").EventRow|object)[]} items rows of events, or messages */
  add(items) {
    for (const item of items) this.#items.push(item);
    const surplus = this.#items.splice(0, Math.max(0, this.#items.length - this.#capacity));
    this.dropped += surplus.filter(Array.isArray).length;
  }

  /** Drops the events that wait; messages stay. */
  dropEvents() {
    const messages = this.#items.filter((item) => !Array.isArray(item));
    this.dropped += this.#items.length - messages.length;
    this.#items = messages;
  }

  /**
   * Empties the queue into runs of events and single messages. It returns no more events than the service accepts at
   * once; the oldest are dropped.
   * @param {import("../index.d.ts").Limits} limits @param {number} [targets] registered at the service
   * @param {boolean} [places] whether places are asked for
   * @returns {{rows?: import("../index.d.ts").EventRow[], message?: object}[]}
   */
  drain({ max_events_per_s: limit }, targets = 0, places = false) {
    const items = this.#items.splice(0);
    const perSecond = limit / (1 + Math.floor(targets / TARGETS_PER_UNIT) + (places ? UNITS_FOR_PLACES : 0));
    let surplus = items.filter(Array.isArray).length - Math.max(1, Math.floor(FLUSH_SHARE * perSecond));
    const parts = [];
    for (const item of items) {
      if (!Array.isArray(item)) parts.push({ message: item });
      else if (surplus-- > 0) this.dropped += 1;
      else if (parts.at(-1)?.rows) parts.at(-1).rows.push(item);
      else parts.push({ rows: [item] });
    }
    return parts;
  }
}
