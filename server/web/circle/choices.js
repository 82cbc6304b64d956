// The targets of a circle as the service knows them, and how likely it says that each one is.

/** Tells the service of the targets, and keeps what it proposes until it retracts it. */
export class CircleChoices {
  /** How likely each target is, 0 to 1; 0 beyond the likeliest five. @type {number[]} */ shares = [];
  /** The place of the target that is proposed. @type {number|null} */ proposed = null;

  /** Names the targets of a run. @param {import("/pointpred.js").Connection} connection @param {number[][]} places @param {number} width */
  offer(connection, places, width) {
    this.clear();
    this.shares = places.map(() => 0);
    connection.targets(places.map(([x, y], i) => ({ id: String(i), x: x - width / 2, y: y - width / 2, width, height: width })));
  }

  /** @param {import("/pointpred.js").Choice} choice */
  take({ id, p, action, reason }) {
    if (this.shares[id] === undefined || reason === "entered") return; // the ring is for predictions
    this.shares[id] = action === "propose" ? p : 0;
    if (action === "propose") this.proposed = Number(id);
    else if (this.proposed === Number(id)) this.proposed = null;
  }

  /** @param {import("/pointpred.js").Prediction} prediction */
  predicted({ targets }) {
    if (!targets) return;
    this.shares.fill(0);
    for (const { id, p } of targets) if (this.shares[id] !== undefined) this.shares[id] = p;
  }

  clear() {
    this.shares.fill(0);
    this.proposed = null;
  }
}
