// The targets of a circle in the session: how likely each is, and which one is proposed.

/** Registers the targets, and follows predictions and choices. */
export class CircleChoices {
  /** The probability of each target; 0 beyond the likeliest five. @type {number[]} */ probabilities = [];
  /** The index of the proposed target. @type {number|null} */ proposed = null;

  /** Registers the targets of a run. @param {import("../service/predictor-connection.js").PredictorConnection} connection @param {number[][]} places @param {number} width */
  register(connection, places, width) {
    this.clear();
    this.probabilities = places.map(() => 0);
    connection.setTargets(
      places.map(([x, y], i) => ({ id: String(i), x: x - width / 2, y: y - width / 2, width, height: width })),
    );
  }

  /** @param {import("../../lib/index.d.ts").Choice} choice */
  addChoice({ id, p, action, reason }) {
    if (this.probabilities[id] === undefined || reason === "entered") return; // only predictions are shown
    this.probabilities[id] = action === "propose" ? p : 0;
    if (action === "propose") this.proposed = Number(id);
    else if (this.proposed === Number(id)) this.proposed = null;
  }

  /** @param {import("../../lib/index.d.ts").Prediction} prediction */
  addPrediction({ targets }) {
    if (!targets) return;
    this.probabilities.fill(0);
    for (const { id, p } of targets) if (this.probabilities[id] !== undefined) this.probabilities[id] = p;
  }

  clear() {
    this.probabilities.fill(0);
    this.proposed = null;
  }
}
