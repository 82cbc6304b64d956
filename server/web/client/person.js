// What the service knows of the person, as the browser client keeps it: for the page, and for the next session.

const ASK_MS = 5000; // while the pointer moves the newest is asked for so often

/** Asks in order, and gives each answer to who asked. */
export class Person {
  /** The newest string; it goes out with the next hello of the same predictor. @type {string} */ known;
  #predictor; #say; #changed; #asked = []; #greeting = ""; #sent = 0; #askedAt = -Infinity;

  /**
   * @param {string} known what the page begins with @param {string} predictor whose it is
   * @param {{say: (message: object) => void, changed: (person: string) => void}} told
   */
  constructor(known, predictor, { say, changed }) {
    [this.known, this.#predictor, this.#say, this.#changed] = [known, predictor, say, changed];
  }

  /** What the hello of a predictor says: another one's person is not its own. @returns {{person?: string}} */
  hello(predictor) {
    if (predictor !== this.#predictor) this.hold("", predictor);
    this.#greeting = this.known;
    return this.known ? { person: this.known } : {};
  }

  /** The session has begun; what the page set after hello is still to be said. */
  greeted() {
    if (this.known !== this.#greeting) this.ask(this.known).catch(() => {}); // an error says why
  }

  /** @param {string} [known] sets it, instead of asking @returns {Promise<string>} */
  ask(known) {
    this.#askedAt = performance.now();
    const answer = new Promise((resolve, reject) => this.#asked.push({ known, resolve, reject }));
    this.#say(known === undefined ? { type: "person" } : { type: "person", person: known });
    return answer;
  }

  /** Asks for the newest now and then. @param {number} sent events of the page so far */
  refresh(sent) {
    if (sent === this.#sent || this.#asked.length || performance.now() - this.#askedAt < ASK_MS) return;
    this.#sent = sent;
    this.ask();
  }

  /** What the next hello says. @param {string} person @param {string} [predictor] whose it is */
  hold(person, predictor = this.#predictor) {
    this.#predictor = predictor;
    if (person === this.known) return;
    this.known = person;
    this.#changed(person);
  }

  /** The oldest question is answered. @param {string} person @param {string} predictor whose it is */
  heard(person, predictor) {
    const asked = this.#asked.shift();
    this.hold(person, predictor);
    asked?.resolve(person);
  }

  /** The service does not take what was set; what it knew before it still knows. @param {string} words */
  refused(words) {
    this.#asked.shift()?.reject(new RangeError(words));
  }

  /** No answer will come. */
  lost() {
    for (const { known, resolve } of this.#asked.splice(0)) {
      if (known !== undefined) this.hold(known);
      resolve(this.known);
    }
  }
}
