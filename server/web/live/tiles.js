// The row of tiles in the live picture: targets that light up by how likely the pointer is heading for them.

import { Ledger } from "../page/ledger.js";

const COUNT = 5;
const HEIGHT_PX = 44;
const EDGE_PX = 22;

/** The tiles of a picture so wide and high, side by side at its lower edge. @returns {import("/pointpred.js").Target[]} */
export function row(width, height) {
  const step = width / COUNT, wide = Math.round(0.62 * step);
  return Array.from({ length: COUNT }, (_, i) => ({
    id: `tile-${i + 1}`, x: Math.round((i + 0.5) * step - wide / 2), y: Math.round(height - HEIGHT_PX - EDGE_PX), width: wide, height: HEIGHT_PX,
  }));
}

/**
 * How strongly each tile is tinted: as likely as it is, and no longer than the prediction that says so is drawn.
 * @param {Object<string, number>} shares by id @param {import("./picture.js").Mark|null} mark
 */
export const tints = (shares, mark) => Object.fromEntries(Object.entries(shares).map(([id, p]) => [id, p * (mark?.opacity ?? 0)]));

/** Knows where the tiles are, how likely each is, and what came of the proposals. */
export class Tiles {
  ledger = new Ledger();
  /** @type {import("/pointpred.js").Target[]} */ list = [];
  /** How likely each is, by its id. @type {Object<string, number>} */ shares = {};
  /** @type {string|null} */ proposed = null;
  #over = null;
  #pressed = null; // where the last movement ended: until the pointer leaves it, it heads for nothing

  /** Lays them out anew where the picture has changed its size. @returns {boolean} whether it has */
  fit(width, height) {
    const list = row(width, height);
    if (JSON.stringify(list) === JSON.stringify(this.list)) return false;
    this.list = list;
    return true;
  }

  /** @param {import("/pointpred.js").Prediction} prediction */
  predicted({ targets }) {
    if (targets && this.#pressed === null) this.shares = Object.fromEntries(targets.map(({ id, p }) => [id, p]));
  }

  /** @param {import("/pointpred.js").Choice} choice */
  chosen(choice) {
    if (choice.reason === "entered") return; // the frame is for predictions
    if (choice.action === "propose") this.proposed = choice.id;
    else if (this.proposed === choice.id) this.proposed = null;
    if (this.#pressed === null) this.shares[choice.id] = choice.p;
    this.ledger.take(choice);
  }

  /** The tile at a place. @returns {string|null} */
  at(x, y) {
    return this.list.find((one) => x >= one.x && x <= one.x + one.width && y >= one.y && y <= one.y + one.height)?.id ?? null;
  }

  /** @param {number[][]} rows events [t, x, y, ...] */
  move(rows) {
    for (const [t, x, y] of rows) {
      const over = this.at(x, y);
      if (over !== null && over !== this.#over) this.ledger.enter(over, t);
      this.#over = over;
      if (this.#pressed !== null && (x !== this.#pressed[0] || y !== this.#pressed[1])) this.#pressed = null;
    }
  }

  /** A press ends a movement. @param {number[]} row @returns {{lead_s: number|null}|null} what is known of the tile under it */
  press([, x, y]) {
    const id = this.at(x, y);
    const lead = this.ledger.finish(id);
    [this.shares, this.#pressed] = [{}, [x, y]];
    return id === null ? null : { lead_s: lead };
  }

  /** Nothing is known any more. */
  clear() {
    [this.shares, this.proposed] = [{}, null];
  }
}
