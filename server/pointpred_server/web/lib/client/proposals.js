// The targets that the browser client proposes now, whether the service or the page has chosen them.

/**
 * A target is proposed when the first source chooses it, and retracted when the last one ends: a card that is predicted
 * and then gets the keyboard focus is proposed once, with the reason that came first.
 * @template {{id: unknown}} Choice
 */
export class Proposals {
  #emit;
  #choices = new Map(); // by the target's id, then by source

  /** @param {(choice: Choice) => void} emit is called after the state has changed */
  constructor(emit) {
    this.#emit = emit;
  }

  /** The id of the target that was proposed last and still is. @returns {Choice["id"]|null} */
  get newest() {
    return [...this.#choices.keys()].at(-1) ?? null;
  }

  /** Whether a target is proposed. @param {Choice["id"]} id */
  has(id) {
    return this.#choices.has(id);
  }

  /** The current choices of a source. @param {string} source @returns {Choice[]} */
  from(source) {
    return [...this.#choices.values()].flatMap((choices) => choices.get(source) ?? []);
  }

  /** A source chooses a target, or changes the probability of its choice. @param {string} source @param {Choice} choice */
  begin(source, choice) {
    const choices = this.#choices.get(choice.id) ?? new Map(),
      emitted = choices.size === 0 || choices.has(source);
    choices.set(source, choice);
    this.#choices.set(choice.id, choices);
    if (emitted) this.#emit(choice);
  }

  /** A source no longer chooses a target. @param {string} source @param {Choice["id"]} id @param {{p?: number, t?: number|null}} [fields] of the message */
  end(source, id, { p = 0, t = null } = {}) {
    const choices = this.#choices.get(id),
      choice = choices?.get(source);
    if (!choices?.delete(source) || choices.size > 0) return;
    this.#choices.delete(id);
    this.#emit({ ...choice, p, t, action: "retract", reason: null });
  }

  /** Retracts everything. */
  clear() {
    for (const choices of [...this.#choices.values()])
      for (const [source, { id }] of [...choices]) this.end(source, id);
  }
}
