// The service of a study, behind the participant's link: what is sent is sent again until it is stored.

const ADDRESS = `../v1/study/${window.location.pathname.split("/").pop()}`;
const AGAIN_MS = 500;

/**
 * @typedef {{stored: number, next: [number, number]|null, agreed: boolean, questions: ("before"|"after")[]}} State how far the participant is
 */

/** An answer of the service that sending again does not change. */
export class Refused extends Error {
  /** @param {number} status @param {string} message */
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

async function answerOf(response) {
  const body = await response.json().catch(() => ({}));
  if (response.ok) return body;
  const message = body.message ?? `the service answered with status ${response.status}`;
  if (response.status < 500) throw new Refused(response.status, message);
  throw new Error(message);
}

/** What the study is, and how far the participant is. */
export const read = async () => answerOf(await fetch(ADDRESS));

/** Sends messages one after the other, each until it is stored. */
export class Sender {
  /** Messages that are not stored yet. */ waiting = 0;
  #last = Promise.resolve();
  #onTrouble;

  /** @param {(message: string|null) => void} onTrouble is called when a message could not be stored, and with null when it was */
  constructor(onTrouble) {
    this.#onTrouble = onTrouble;
  }

  /** Rejects with `Refused` where the service does not take it. @param {object} message @returns {Promise<State>} */
  send(message) {
    this.waiting += 1;
    const body = JSON.stringify(message); // a page may go on with its arrays
    const sent = this.#last.then(() => this.#deliver(body));
    this.#last = sent.then(
      () => {},
      () => {},
    );
    return sent;
  }

  async #deliver(body) {
    const headers = { "Content-Type": "application/json" };
    for (let troubled = false; ; troubled = true) {
      try {
        const state = await answerOf(await fetch(ADDRESS, { method: "POST", headers, body }));
        if (troubled) this.#onTrouble(null);
        this.waiting -= 1;
        return state;
      } catch (error) {
        if (error instanceof Refused) {
          this.waiting -= 1;
          throw error;
        }
        this.#onTrouble(error instanceof TypeError ? "the service cannot be reached" : String(error));
        await new Promise((resolve) => setTimeout(resolve, AGAIN_MS));
      }
    }
  }
}
