// The string that describes what the service has learned of the person: for the page, and for the next session.

const REFRESH_MS = 5000; // while the pointer moves, the newest string is requested this often

/** Holds the newest string; requests to the service are answered in order. */
export class Person {
  /** It is part of the next hello of the same predictor. @type {string} */ description;
  #predictor;
  #send;
  #onChange;
  #requests = [];
  #inHello = "";
  #sent = 0;
  #requestedAt = -Infinity;

  /**
   * @param {string} description to begin with @param {string} predictor that learned it
   * @param {{send: (message: object) => void, onChange: (person: string) => void}} callbacks
   */
  constructor(description, predictor, { send, onChange }) {
    [this.description, this.#predictor, this.#send, this.#onChange] = [description, predictor, send, onChange];
  }

  /** The field of hello for a predictor: what another one learned is of no use to it. @returns {{person?: string}} */
  hello(predictor) {
    if (predictor !== this.#predictor) this.store("", predictor);
    this.#inHello = this.description;
    return this.description ? { person: this.description } : {};
  }

  /** A session has begun: sends what the page has set since hello. */
  beginSession() {
    if (this.description !== this.#inHello) this.request(this.description).catch(() => {}); // an error message tells why
  }

  /** Requests the newest string, or sets it. @param {string} [person] to set @returns {Promise<string>} */
  request(person) {
    return this.#ask(person, person === undefined ? { type: "person" } : { type: "person", person });
  }

  /** Has the person forgotten. @returns {Promise<string>} "" */
  forget() {
    return this.#ask("", { type: "forget" });
  }

  #ask(person, message) {
    this.#requestedAt = performance.now();
    const answer = new Promise((resolve, reject) => this.#requests.push({ person, resolve, reject }));
    this.#send(message);
    return answer;
  }

  /** Requests the newest string if it is time to. @param {number} sent events sent so far */
  refresh(sent) {
    if (sent === this.#sent || this.#requests.length || performance.now() - this.#requestedAt < REFRESH_MS) return;
    this.#sent = sent;
    this.request();
  }

  /** Sets the string for the next hello. @param {string} person @param {string} [predictor] that learned it */
  store(person, predictor = this.#predictor) {
    this.#predictor = predictor;
    if (person === this.description) return;
    this.description = person;
    this.#onChange(person);
  }

  /** The service has answered the oldest request. @param {string} person @param {string} predictor that learned it */
  receive(person, predictor) {
    const oldest = this.#requests.shift();
    this.store(person, predictor);
    oldest?.resolve(person);
  }

  /** The service has refused the string that was set, and keeps its own. @param {string} message */
  reject(message) {
    this.#requests.shift()?.reject(new RangeError(message));
  }

  /** No answer will come: strings that were set go into the next hello. */
  endSession() {
    for (const { person, resolve } of this.#requests.splice(0)) {
      if (person !== undefined) this.store(person);
      resolve(this.description);
    }
  }
}
