// The choices of the service, passed on as far as they are about now.

/**
 * A choice about the past, from events that waited for a connection or before the pointer left, is announced once a later
 * event confirms it.
 */
export class ServiceChoices {
  #proposals; #entry; #past = -Infinity; #unconfirmed = new Map();

  /** @param {import("./proposals.js").Proposals} proposals @param {import("./entry.js").Entry} entry */
  constructor(proposals, entry) {
    [this.#proposals, this.#entry] = [proposals, entry];
  }

  /** What the service proposes now. @returns {import("../pointpred.js").Choice[]} */
  get standing() {
    return this.#proposals.by("service");
  }

  /** @param {import("../pointpred.js").Choice} choice */
  take(choice) {
    const { id, t, action } = choice;
    if (t !== null && t <= this.#past) {
      if (action === "propose") this.#unconfirmed.set(id, choice);
      else this.#unconfirmed.delete(id);
    } else if (action === "propose") this.#proposals.begin("service", choice);
    else if (!this.#unconfirmed.delete(id)) this.#end(id, choice);
  }

  /** What is not retracted by an event is confirmed by it. @param {number} t of its prediction, s */
  confirm(t) {
    if (t <= this.#past) return;
    for (const choice of this.#unconfirmed.values()) this.#proposals.begin("service", choice);
    this.#unconfirmed.clear();
  }

  /** Events up to this time are of the past. @param {number} t s */
  past(t) {
    this.#past = t;
  }

  /** The service cannot know what happens after its newest event: until the next one the page itself says what is entered. @param {number} t s */
  wait(t) {
    this.#past = t;
    this.#entry.alone = true;
    for (const choice of this.standing) {
      this.#unconfirmed.set(choice.id, choice);
      this.#end(choice.id, { t: performance.now() / 1000 });
    }
  }

  /** The session is lost: its choices with it. */
  lose() {
    [this.#past, this.#entry.alone] = [-Infinity, true];
    this.#unconfirmed.clear();
    for (const { id } of this.standing) this.#end(id);
  }

  /** A target that the pointer is in stays proposed until the pointer leaves it. */
  #end(id, when) {
    this.#entry.look();
    this.#proposals.end("service", id, when);
  }
}
