// Which lines of a plot are coloured: the best three, unless the person has switched lines on or off.

const BEST = 3;

/** The predictor that every other is compared with: the endpoint is where the cursor is. */
export const BASELINE = "hold";

/** Gives each coloured line an index of a colour, which it keeps as long as it is coloured. */
export class Highlights {
  #names = []; #switched = new Map(); // the name at each index, or null; whether a line was switched on

  /** Sets the names, best first; lines that the person has switched stay as they are. @param {string[]} ranked */
  setNames(ranked) {
    const names = ranked.filter((name) => name !== BASELINE);
    const coloured = names.filter((name, rank) => this.#switched.get(name) ?? rank < BEST);
    this.#names = this.#names.map((name) => (coloured.includes(name) ? name : null));
    for (const name of coloured) if (!this.#names.includes(name)) this.#add(name);
  }

  /** The index of a line's colour, from 0; null for a grey line. @param {string} name @returns {number|null} */
  colourIndex(name) {
    const index = this.#names.indexOf(name);
    return index < 0 ? null : index;
  }

  /** Switches a line between grey and a colour. @param {string} name */
  toggle(name) {
    const index = this.colourIndex(name);
    this.#switched.set(name, index === null);
    if (index === null) this.#add(name);
    else this.#names[index] = null;
  }

  #add(name) {
    const free = this.#names.indexOf(null);
    if (free < 0) this.#names.push(name);
    else this.#names[free] = name;
  }
}
