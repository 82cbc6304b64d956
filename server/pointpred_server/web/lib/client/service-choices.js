// The choices of the service, announced only while they are about the present.

/**
 * A choice can be about the past: it follows from events that were queued without a connection, or the pointer has left
 * since. Such a choice is announced once a later event confirms it.
 */
export class ServiceChoices {
  #proposals;
  #page;
  #pastUntil = -Infinity;
  #unconfirmed = new Map();

  /**
   * @param {import("./proposals.js").Proposals<import("../index.d.ts").Choice>} proposals
   * @param {import("./page-choices.js").PageChoices<string>} page
   */
  constructor(proposals, page) {
    [this.#proposals, this.#page] = [proposals, page];
  }

  /** What the service proposes now. @returns {import("../index.d.ts").Choice[]} */
  get current() {
    return this.#proposals.from("service");
  }

  /** @param {import("../index.d.ts").Choice} choice from the service */
  receive(choice) {
    const { id, t, action } = choice;
    if (t !== null && t <= this.#pastUntil) {
      if (action === "propose") this.#unconfirmed.set(id, choice);
      else this.#unconfirmed.delete(id);
    } else if (action === "propose") this.#proposals.begin("service", choice);
    else if (!this.#unconfirmed.delete(id)) this.#end(id, choice);
  }

  /** A prediction for a later event has come: what was not retracted by then is confirmed. @param {number} t of the prediction, s */
  confirm(t) {
    if (t <= this.#pastUntil) return;
    for (const choice of this.#unconfirmed.values()) this.#proposals.begin("service", choice);
    this.#unconfirmed.clear();
  }

  /** Treats events up to this time as past. @param {number} t s */
  setPast(t) {
    this.#pastUntil = t;
  }

  /**
   * Withdraws what the service proposes until the next event: the service cannot know what happens after the newest one.
   * Meanwhile the page detects entries itself. @param {number} t of the newest event, s
   */
  pause(t) {
    this.#pastUntil = t;
    this.#page.detectsEntry = true;
    for (const choice of this.current) {
      this.#unconfirmed.set(choice.id, choice);
      this.#end(choice.id, { t: performance.now() / 1000 });
    }
  }

  /** The session is lost, and its choices with it. */
  endSession() {
    [this.#pastUntil, this.#page.detectsEntry] = [-Infinity, true];
    this.#unconfirmed.clear();
    for (const { id } of this.current) this.#end(id);
  }

  /** A target that the pointer is in stays proposed until the pointer leaves it. */
  #end(id, fields) {
    this.#page.update();
    this.#proposals.end("service", id, fields);
  }
}
