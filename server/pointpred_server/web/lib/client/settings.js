// The settings of a session: sent in hello, changed by configure, sent again when a session is opened again.

/** Keeps the settings in force, and the changes that the service has not answered yet. */
export class Settings {
  #hello;
  #precision;
  #pending = [];

  /** @param {object} hello the first one */
  constructor(hello) {
    this.#hello = hello;
  }

  /** The hello of the next session, with more fields. @param {object} more @returns {string} */
  hello(more) {
    return JSON.stringify({ ...this.#hello, ...more });
  }

  /** @returns {string} */
  get predictor() {
    return this.#hello.predictor;
  }

  /** Whether places are asked for. */
  get places() {
    return this.#hello.places === true;
  }

  /** @returns {"binary"|"json"} */
  get encoding() {
    return this.#hello.encoding;
  }

  /** Takes the changes to request once a session is open: those that hello has no field for, and later ones. @returns {object[]} */
  takePending() {
    const pending = this.#pending.splice(0);
    return this.#precision === undefined ? pending : [{ precision: this.#precision }, ...pending];
  }

  /** Adds a change that was or will be sent to the service. @param {object} changes */
  request(changes) {
    this.#pending.push(changes);
  }

  /** The service has accepted the oldest pending change. */
  confirm() {
    this.apply(this.#pending.shift() ?? {});
  }

  /** The service has refused the oldest pending change. */
  reject() {
    const { precision } = this.#pending.shift() ?? {};
    if (precision !== undefined && precision === this.#precision) this.#precision = undefined;
  }

  /** No answer will come: pending changes go into the next hello. */
  applyPending() {
    for (const changes of this.#pending.splice(0)) this.apply(changes);
  }

  /** Puts a change into the next hello. */
  apply({ predictor, parameters, reply, precision, assist, places }) {
    const former = predictor ? {} : this.#hello.parameters;
    this.#hello = {
      ...this.#hello,
      predictor: predictor ?? this.#hello.predictor,
      parameters: { ...former, ...parameters },
      reply: reply ?? this.#hello.reply,
      assist: assist ?? this.#hello.assist,
      places: places ?? this.#hello.places,
    };
    this.#precision = precision ?? this.#precision;
  }
}
