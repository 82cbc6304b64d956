// What the browser client is asked for: said in hello, changed by configure, said again in a session opened again.

/** Remembers what holds, and what was asked for and is not yet answered. */
export class Wishes {
  #hello; #precision; #asked = [];

  /** @param {object} hello the first one */
  constructor(hello) {
    this.#hello = hello;
  }

  /** How a session begins: what held last, and what else is to be said. @param {object} more @returns {string} */
  hello(more) {
    return JSON.stringify({ ...this.#hello, ...more });
  }

  /** What predicts, as far as it is known. @returns {string} */
  get predictor() {
    return this.#hello.predictor;
  }

  /** @returns {"binary"|"json"} */
  get encoding() {
    return this.#hello.encoding;
  }

  /** What is to be asked for once a session is greeted: what hello cannot say, and what came after it. */
  get late() {
    const asked = this.#asked.splice(0);
    return this.#precision === undefined ? asked : [{ precision: this.#precision }, ...asked];
  }

  /** A change that the service has been asked for, or will be. @param {object} changes */
  ask(changes) {
    this.#asked.push(changes);
  }

  /** The oldest change is answered: it holds. */
  granted() {
    this.hold(this.#asked.shift() ?? {});
  }

  /** The oldest change is answered: it does not hold. */
  refused() {
    const { precision } = this.#asked.shift() ?? {};
    if (precision !== undefined && precision === this.#precision) this.#precision = undefined;
  }

  /** No answer will come: what was asked for is said in the next hello. */
  lost() {
    for (const changes of this.#asked.splice(0)) this.hold(changes);
  }

  /** A change holds from the next hello on. */
  hold({ predictor, parameters, reply, precision, assist }) {
    const kept = predictor ? {} : this.#hello.parameters;
    this.#hello = { ...this.#hello, predictor: predictor ?? this.#hello.predictor,
      parameters: { ...kept, ...parameters }, reply: reply ?? this.#hello.reply, assist: assist ?? this.#hello.assist };
    this.#precision = precision ?? this.#precision;
  }
}
