// A session in the page: it answers the messages of `pointpred.v1` as the service does, without a service.

import { VERSION } from "../laws/fields.js";
import { MOST_TARGETS } from "../laws/targets/rectangles.js";
import { EventError } from "./errors.js";
import { checked, ProtocolError } from "./messages.js";
import { PredictionStream } from "./stream.js";

/** The limits of a session. The page serves one session, so most of them are off. @type {import("../index.d.ts").Limits} */
const LIMITS = Object.freeze({
  max_frame_bytes: Infinity,
  max_events_per_frame: Infinity,
  max_events_per_s: Infinity,
  max_targets: MOST_TARGETS,
  max_sessions: 1,
  idle_s: Infinity,
});

/** One session. A message that is to be waited for is answered by a promise; no other may be sent before it is resolved. */
export class PageSession {
  /** Why the session has ended; null while it goes on. @type {string|null} */ ended = null;
  #send;
  /** @type {PredictionStream|null} */ #stream = null;

  /** @param {(message: object) => void} send is called with each answer, an object as the service sends it as JSON */
  constructor(send) {
    this.#send = send;
  }

  /** What the newest prediction knows beyond one law; null before the first. @returns {import("./mixture.js").Mixture|null} */
  get mixture() {
    return this.#stream?.mixture ?? null;
  }

  /** Takes in events: t, x, y, dx, dy (null: no counts), buttons. @param {import("../index.d.ts").EventRow[]} rows */
  receiveRows(rows) {
    if (this.ended !== null) return;
    try {
      if (this.#stream === null) throw outOfPlace("expected 'hello' first, received 'events'");
      if (rows.length)
        this.#stream.feed(rows.map(([t, x, y, dx, dy, buttons]) => [t, x, y, dx ?? NaN, dy ?? NaN, buttons]));
    } catch (error) {
      this.#refuse(error);
    }
  }

  /** Takes in a message. @param {import("./messages.js").Message} message @returns {Promise<void>|void} */
  receive(message) {
    if (message?.type === "events" && Array.isArray(message.events)) return this.receiveRows(message.events);
    return this.ended === null ? this.#answer(message) : undefined;
  }

  async #answer(message) {
    try {
      const asked = checked(message),
        { type } = asked;
      if (type === "bye") return this.#end(asked.reason || "bye");
      if (type === "hello" && this.#stream !== null) throw outOfPlace("expected 'hello' once");
      if (type !== "hello" && this.#stream === null) throw outOfPlace(`expected 'hello' first, received '${type}'`);
      const reply = await this.#handlers[type](asked, /** @type {PredictionStream} */ (this.#stream));
      if (reply !== undefined) this.#send(reply);
    } catch (error) {
      this.#refuse(error);
    }
  }

  /**
   * What is done at each message; the answer is sent.
   * @type {Object<string, (message: import("./messages.js").Message, stream: PredictionStream) => unknown>}
   */
  #handlers = {
    hello: async (hello) => {
      if (hello.version < 1 || hello.version > VERSION)
        throw new ProtocolError("bad_field", `version must be 1 to ${VERSION}, received ${hello.version}`, "$.version");
      const kind = hello.assist == null ? PredictionStream : (await import("./assisted-stream.js")).AssistedStream;
      this.#stream = await kind.open(hello, this.#send);
      return welcomeTo(this.#stream);
    },
    configure: async (message, stream) => {
      await stream.configure(message);
      return welcomeTo(stream);
    },
    targets: ({ targets }, stream) => {
      this.#checkTargets(targets);
      stream.replaceTargets(targets);
      return { type: "targets", count: targets.length };
    },
    trial: ({ action, target = null, conditions = {} }, stream) =>
      stream[action === "start" ? "startTrial" : "endTrial"](target, conditions),
    enter: ({ key, x = 0, y = 0 }, stream) => stream.enter([key, x, y]),
    forget: (_, stream) => ({ type: "person", person: stream.forgetPerson() }),
    reset: (_, stream) => stream.reset(),
    person: async ({ person }, stream) => ({ type: "person", person: await stream.person(person) }),
  };

  #checkTargets(targets) {
    if (targets.length > MOST_TARGETS)
      throw new ProtocolError("too_many", `at most ${MOST_TARGETS} targets, received ${targets.length}`, "$.targets");
    const ids = new Set();
    targets.forEach(({ id }, place) => {
      if (ids.has(id))
        throw new ProtocolError("bad_field", `id '${id}' occurs twice`, `$.targets[${place}].id`, {
          field: "id",
          value: id,
        });
      ids.add(id);
    });
  }

  /** Sends why something was not used. An internal error, or a file that cannot be fetched, ends the session. */
  #refuse(error) {
    if (error instanceof ProtocolError) return this.#send(error.answer);
    if (error instanceof EventError)
      return this.#send(new ProtocolError("bad_field", error.message, "$.events", error).answer);
    console.error(error);
    this.#send(
      new ProtocolError("internal", `the prediction failed: ${error.message}`, null, { recoverable: false }).answer,
    );
    this.#end(error.message);
  }

  #end(reason) {
    this.ended = reason;
    this.#stream = null;
  }
}

/** @param {PredictionStream} stream */
const welcomeTo = ({ hello: { version, predictor } }) => ({
  type: "welcome",
  version,
  session: "page",
  predictor,
  limits: LIMITS,
});

const outOfPlace = (sentence) => new ProtocolError("out_of_place", sentence);
