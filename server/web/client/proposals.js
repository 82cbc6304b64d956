// What the browser client proposes now: by the service, and by what the page itself sees.

/**
 * A target is proposed when the first reason for it begins, and retracted when the last one has ended: a card that is
 * predicted and then has the keyboard's focus is proposed once, with the reason that came first.
 */
export class Proposals {
  #emit; #standing = new Map();

  /** @param {(choice: import("../pointpred.js").Choice) => void} emit hears every choice once what stands has changed */
  constructor(emit) {
    this.#emit = emit;
  }

  /** The id of the target that was proposed last and still is. @returns {string|null} */
  get newest() {
    return [...this.#standing.keys()].at(-1) ?? null;
  }

  /** Whether a target is proposed. @param {string} id */
  stands(id) {
    return this.#standing.has(id);
  }

  /** The choices that a source has made and that still stand. @param {string} source */
  by(source) {
    return [...this.#standing.values()].flatMap((choices) => choices.get(source) ?? []);
  }

  /** A source that says it again has changed its mind about the share. @param {string} source @param {import("../pointpred.js").Choice} choice */
  begin(source, choice) {
    const choices = this.#standing.get(choice.id) ?? new Map(), heard = choices.size === 0 || choices.has(source);
    choices.set(source, choice);
    this.#standing.set(choice.id, choices);
    if (heard) this.#emit(choice);
  }

  /** @param {string} source @param {string} id @param {{p?: number, t?: number|null}} [when] */
  end(source, id, { p = 0, t = null } = {}) {
    const choices = this.#standing.get(id), choice = choices?.get(source);
    if (!choices?.delete(source) || choices.size > 0) return;
    this.#standing.delete(id);
    this.#emit({ ...choice, p, t, action: "retract", reason: null });
  }

  /** Ends everything. */
  clear() {
    for (const choices of [...this.#standing.values()]) for (const [source, { id }] of [...choices]) this.end(source, id);
  }
}
