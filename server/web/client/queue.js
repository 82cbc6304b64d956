// What waits in the browser client while there is no connection: rows of events and messages, in their order.

const TARGETS_AN_EVENT = 64; // an event counts once more for each so many targets
const FLUSHED_SHARE = 0.75; // of a second's worth: the rest of it is for what the pointer does at once

/** Keeps a bounded number; the oldest give way, and events that do are counted. */
export class Queue {
  /** Events that gave way. */ dropped = 0;
  #items = []; #most;

  /** @param {number} most items kept */
  constructor(most) {
    this.#most = most;
  }

  /** How many wait. */
  get length() {
    return this.#items.length;
  }

  /** @param {(import("../pointpred.js").EventRow|object)[]} items */
  keep(items) {
    for (const item of items) this.#items.push(item);
    this.#drop(this.#items.splice(0, Math.max(0, this.#items.length - this.#most)));
  }

  /**
   * Empties it: runs of events and messages, no more events than the service lets in at once; the oldest give way.
   * @param {import("../pointpred.js").Limits} limits @param {number} targets how many the service holds
   * @returns {{rows?: import("../pointpred.js").EventRow[], message?: object}[]}
   */
  take({ max_events_per_s: most }, targets = 0) {
    const items = this.#items.splice(0);
    const perSecond = most / (1 + Math.floor(targets / TARGETS_AN_EVENT));
    let over = items.filter(Array.isArray).length - Math.max(1, Math.floor(FLUSHED_SHARE * perSecond));
    const parts = [];
    for (const item of items) {
      if (!Array.isArray(item)) parts.push({ message: item });
      else if (over-- > 0) this.dropped += 1;
      else if (parts.at(-1)?.rows) parts.at(-1).rows.push(item);
      else parts.push({ rows: [item] });
    }
    return parts;
  }

  #drop(items) {
    this.dropped += items.filter(Array.isArray).length;
  }
}
