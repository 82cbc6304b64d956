// A sentence on how early the end of a movement was predicted, with the average of the last ten movements.

import { mean, number } from "../shell/numbers.js";
import { NEAR_PX } from "./movement.js";

const LAST = 10;
const TILES = "a tile";
const ms = (seconds) => number(1000 * seconds, 0, "ms");

/** The last ten leads of each predictor, and of the tiles that were clicked. */
export class RecentLeads {
  #leads = new Map();

  /** @param {string} name @param {number} lead s @returns {number|null} the average of the last ten, s; null for a single one */
  add(name, lead) {
    const leads = [...(this.#leads.get(name) ?? []), lead].slice(-LAST);
    this.#leads.set(name, leads);
    return leads.length < 2 ? null : mean(leads);
  }

  /** The number of movements in an average. */
  count(name) {
    return this.#leads.get(name)?.length ?? 0;
  }
}

/**
 * The sentence about a movement, and the numbers in it.
 * @param {import("./movement.js").Verdict} verdict @param {string[]} predictors chosen now
 * @param {{lead_s: number|null}|null} tile the tile that was clicked: how long before the pointer entered it it was proposed
 * @param {RecentLeads} recent @param {string} who "you", or what moved
 */
export function describe(verdict, predictors, tile, recent, who = "you") {
  const tileLead = tile === null ? null : (tile.lead_s ?? 0);
  const tileAverage = tileLead === null ? null : recent.add(TILES, tileLead);
  const each = predictors.map((chosen, i) => {
    const { name = chosen, lead_s = null } = verdict.predictors[i] ?? {};
    return { name, lead_s, average_s: lead_s === null ? null : recent.add(name, lead_s) };
  });
  const sentences = each.map((one) => {
    const end = endpointText(verdict, one, who) + averageText(one.average_s, recent.count(one.name));
    return `${each.length > 1 ? `Endpoint, ${one.name}` : "Endpoint"}: ${end}.`;
  });
  if (tile !== null)
    sentences.unshift(`${tileText(tile.lead_s, who)}${averageText(tileAverage, recent.count(TILES))}.`);
  return { text: sentences.join(" "), each, tile: tile === null ? null : { lead_s: tileLead, average_s: tileAverage } };
}

function endpointText({ arrival, reached }, { lead_s: lead }, who) {
  if (lead === null) return "no prediction during this movement";
  if (lead === 0) return `not predicted within ${NEAR_PX} px before the pointer itself was that near`;
  return `predicted within ${NEAR_PX} px ${ms(lead)} before ${who} arrived (the pointer itself was that near ${ms(arrival - reached)} before)`;
}

function tileText(lead, who) {
  const arrival = `${who} ${who === "you" ? "were" : "was"} there`;
  return lead !== null && lead > 0
    ? `Tile: proposed ${ms(lead)} before ${arrival}`
    : `Tile: not proposed before ${arrival}`;
}

const averageText = (average, count) =>
  !average ? "" : `; average of the last ${count === LAST ? "ten" : count}: ${ms(average)}`;
