// Which lines of a plot are drawn in colour: the best three, unless somebody has switched one on or off.

const BEST = 3;
export const FLOOR = "hold";

/** Gives each name in colour a place of its own, which it keeps as long as it is in colour. */
export class Highlights {
  #places = []; #wishes = new Map();

  /** Names, the best first; what was switched by hand before stays so. @param {string[]} ranked */
  offer(ranked) {
    const names = ranked.filter((name) => name !== FLOOR);
    const wanted = names.filter((name, rank) => this.#wishes.get(name) ?? rank < BEST);
    this.#places = this.#places.map((name) => (wanted.includes(name) ? name : null));
    for (const name of wanted) if (!this.#places.includes(name)) this.#add(name);
  }

  /** The place of a name's colour, from 0; null: it is grey. @param {string} name @returns {number|null} */
  place(name) {
    const at = this.#places.indexOf(name);
    return at < 0 ? null : at;
  }

  /** Switches a name from grey to colour or back. @param {string} name */
  toggle(name) {
    const at = this.place(name);
    this.#wishes.set(name, at === null);
    if (at === null) this.#add(name);
    else this.#places[at] = null;
  }

  #add(name) {
    const free = this.#places.indexOf(null);
    if (free < 0) this.#places.push(name);
    else this.#places[free] = name;
  }
}
