// Predictions of two sessions for the same events, paired by their times.

/** How far the predictions of two sessions are apart. */
export class Pairs {
  /** Events that both have answered. */ count = 0;
  /** The largest distance of their endpoints, px; Infinity where only one of them has an endpoint. */ largestPx = 0;
  #waiting = [[], []];

  /** Adds a prediction; those of a session come in the order of its events. @param {0|1} which session @param {import("../../lib/pointpred.js").Prediction} prediction */
  add(which, prediction) {
    this.#waiting[which].push(prediction);
    const [first, second] = this.#waiting;
    while (first.length && second.length) {
      const { t: before } = first[0],
        { t: after } = second[0];
      if (before === after) this.#compare(first.shift(), second.shift());
      else (before < after ? first : second).shift(); // one session has dropped this event
    }
  }

  #compare(one, other) {
    this.count += 1;
    if (one.x === null && other.x === null) return;
    const px = one.x === null || other.x === null ? Infinity : Math.hypot(one.x - other.x, one.y - other.y);
    this.largestPx = Math.max(this.largestPx, px);
  }
}
