// The row of tiles in the live picture: targets that light up by how likely the pointer is heading for them.

import * as law from "../../lib/laws/targets/ledger.js";
import { keyOf } from "../../lib/prediction/blake2b.js";
import { Ledger } from "../../lib/prediction/ledger.js";
import { Account } from "../shell/account.js";

const COUNT = 5;
const HEIGHT_PX = 56;
const MOST_PX = 160; // wide
const EDGE_PX = 48; // below them stands what they are

/** The tiles of a picture of this size, side by side at its lower edge. @returns {import("../../lib/index.d.ts").NamedTarget[]} */
export function row(width, height) {
  const step = width / COUNT,
    tileWidth = Math.round(Math.min(MOST_PX, 0.8 * step));
  return Array.from({ length: COUNT }, (_, i) => ({
    id: `tile-${i + 1}`,
    x: Math.round((i + 0.5) * step - tileWidth / 2),
    y: Math.round(height - HEIGHT_PX - EDGE_PX),
    width: tileWidth,
    height: HEIGHT_PX,
  }));
}

/** Whether a point lies on a tile. @param {import("../../lib/index.d.ts").NamedTarget} tile */
export const contains = (tile, x, y) =>
  x >= tile.x && x <= tile.x + tile.width && y >= tile.y && y <= tile.y + tile.height;

/**
 * The opacity of each tile: its probability, faded with the prediction that it comes from.
 * @param {Object<string, number>} probabilities by id @param {import("./picture.js").Mark|null} mark
 */
export const opacitiesOf = (probabilities, mark) =>
  Object.fromEntries(Object.entries(probabilities).map(([id, p]) => [id, p * (mark?.opacity ?? 0)]));

/** The id of what is predicted after a choice, given what was before; null: none. @param {string|null} before @param {import("../../lib/index.d.ts").Choice} choice @returns {string|null} */
export function proposedAfter(before, { id, action, reason }) {
  if (reason === "entered") return before; // not a prediction
  if (action === "propose") return id;
  return before === id ? null : before;
}

/** Knows where the tiles are, how likely each is, and what became of the proposals. */
export class Tiles {
  /** Of the movements to tiles. */ account = new Account();
  /** @type {import("../../lib/index.d.ts").NamedTarget[]} */ list = [];
  /** By the tile's id. @type {Object<string, number>} */ probabilities = {};
  /** @type {string|null} */ proposed = null;
  #ledger = new Ledger();
  /** @type {string|null} */ #under = null;
  /** @type {number[]|null} */ #pressed = null; // where the last movement ended: until the pointer leaves that point, it heads for no tile

  /** Lays the tiles out again if the picture has changed its size. @returns {boolean} whether it has */
  layOut(width, height) {
    const list = row(width, height);
    if (JSON.stringify(list) === JSON.stringify(this.list)) return false;
    this.list = list;
    return true;
  }

  /** @param {import("../../lib/index.d.ts").Prediction} prediction */
  addPrediction({ targets }) {
    if (targets && this.#pressed === null) this.probabilities = Object.fromEntries(targets.map(({ id, p }) => [id, p]));
  }

  /** @param {import("../../lib/index.d.ts").Choice} choice */
  addChoice(choice) {
    if (choice.reason === "entered") return; // only predictions are highlighted
    const t = /** @type {number} */ (choice.t); // of an event: what is proposed has one
    this.proposed = proposedAfter(this.proposed, choice);
    if (this.#pressed === null) this.probabilities[choice.id] = choice.p;
    const { account } = this.#ledger,
      key = keyOf(choice.id);
    if (choice.action === "propose") law.note_proposal(account, this.#ledger.withRoom(1), t, key);
    else law.note_end(account, this.#ledger.withRoom(0), t, key, false);
  }

  /** The tile at a point. @returns {string|null} */
  at(x, y) {
    return this.list.find((tile) => contains(tile, x, y))?.id ?? null;
  }

  /** @param {number[][]} rows events [t, x, y, ...] */
  move(rows) {
    for (const [t, x, y] of rows) {
      const under = this.at(x, y);
      if (under !== null && under !== this.#under)
        law.note_entry(this.#ledger.account, this.#ledger.withRoom(1), t, keyOf(under));
      this.#under = under;
      if (this.#pressed !== null && (x !== this.#pressed[0] || y !== this.#pressed[1])) this.#pressed = null;
    }
  }

  /** A press ends the movement. @param {number[]} row @returns {{lead_s: number|null}|null} of the tile under it, if there is one */
  press([t, x, y]) {
    const id = this.at(x, y);
    [this.probabilities, this.#pressed] = [{}, [x, y]];
    if (id === null) {
      this.#ledger.drop();
      return null;
    }
    const movement = this.#ledger.close(t, keyOf(id));
    this.account.add(movement);
    return { lead_s: movement.lead_entry_s };
  }

  /** Forgets probabilities and proposals. */
  clear() {
    [this.probabilities, this.proposed] = [{}, null];
  }
}
