// How early the end of each movement was known, in words, with the average of the last ten.

import { NEAR_PX } from "./movement.js";
import { number } from "../page/elements.js";

const LAST = 10;
const ms = (seconds) => number(1000 * seconds, 0, "ms");

/** Remembers the last ten leads of each predictor, and of the tiles that were clicked. */
export class Earliness {
  #leads = new Map();

  /** @param {string} of @param {number} lead s @returns {number|null} average of the last ten, s; null of a single one */
  add(of, lead) {
    const leads = [...(this.#leads.get(of) ?? []), lead].slice(-LAST);
    this.#leads.set(of, leads);
    return leads.length < 2 ? null : leads.reduce((sum, one) => sum + one, 0) / leads.length;
  }

  /** How many movements an average is over. */
  count(of) {
    return this.#leads.get(of)?.length ?? 0;
  }
}

/**
 * What is said of a movement, and the numbers in it.
 * @param {import("./movement.js").Verdict} verdict @param {string[]} predictors those that are chosen now
 * @param {{lead_s: number|null}|null} tile the clicked one: by how much it was proposed before the pointer was there
 * @param {Earliness} earliness @param {string} who "you", or what moves
 */
export function sentence(verdict, predictors, tile, earliness, who = "you") {
  const tileLead = tile === null ? null : tile.lead_s ?? 0;
  const tileAverage = tile === null ? null : earliness.add("a tile", tileLead);
  const each = predictors.map((chosen, i) => {
    const { name = chosen, lead_s = null } = verdict.spoke[i] ?? {};
    return { name, lead_s, average_s: lead_s === null ? null : earliness.add(name, lead_s) };
  });
  const words = each.map((one) => {
    const said = end(verdict, one, who) + mean(one.average_s, earliness.count(one.name));
    return `${each.length > 1 ? `Endpoint, ${one.name}` : "Endpoint"}: ${said}.`;
  });
  if (tile !== null) words.unshift(`${proposed(tile.lead_s, who)}${mean(tileAverage, earliness.count("a tile"))}.`);
  return { words: words.join(" "), each, tile: tile === null ? null : { lead_s: tileLead, average_s: tileAverage } };
}

function end({ arrival, reached }, { lead_s: lead }, who) {
  if (lead === null) return "no prediction during this movement";
  if (lead === 0) return `not known within ${NEAR_PX} px before the pointer itself was that near`;
  return `known within ${NEAR_PX} px ${ms(lead)} before ${who} arrived (the pointer itself was that near ${ms(arrival - reached)} before)`;
}

function proposed(lead, who) {
  if (lead !== null && lead > 0) return `Tile: proposed ${ms(lead)} before ${who} ${who === "you" ? "were" : "was"} there`;
  return `Tile: not proposed before ${who} ${who === "you" ? "were" : "was"} there`;
}

const mean = (average, count) => (!average ? "" : `; average of the last ${count === LAST ? "ten" : count}: ${ms(average)}`);
