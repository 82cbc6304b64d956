// The predicting side of a session in the page: events in, predictions out; as `server/pointpred_server/sessions/prediction_stream.py`.

import { build } from "./build.js";
import { ParameterError } from "./errors.js";
import { checkRows, ProtocolError } from "./messages.js";
import { isRefused, messageOf } from "./row.js";
import { PlaceTracker, TargetTracker } from "./target-tracker.js";
import { TrialBuffer } from "./trial.js";

/** @typedef {import("./messages.js").Message} Message */

/** What `build` takes besides parameters, and where in a hello it belongs. */
const ELSEWHERE = { cpi: "device.cpi", dpi: "screen.dpi", name: "predictor", person: "person" };

/** A pipeline as a client asked for it, the targets it decides among, and the trial that is marked. */
export class PredictionStream {
  /** The settings in force. */ hello;
  #send;
  #pipeline;
  /** @type {TargetTracker|null} */ #tracker = null;
  /** @type {number|null} */ #precision = null;
  #lastTime = -Infinity;
  #trial = new TrialBuffer();
  /** @type {PlaceTracker|null} */ #placeTracker = null;
  /** @type {[string, number, number]|null} */ #window = null;

  /**
   * Use `open`.
   * @param {Message} hello checked @param {import("./pipeline.js").Pipeline} pipeline @param {(message: object) => void} send
   */
  constructor(hello, pipeline, send) {
    this.hello = { ...hello, person: "" }; // the pipeline knows it, and learns on
    [this.#pipeline, this.#send] = [pipeline, send];
  }

  /** @param {Message} hello checked @param {(message: object) => void} send @returns {Promise<PredictionStream>} rejects with a ProtocolError */
  static async open(hello, send) {
    return new this(hello, await pipelineOf(hello), send);
  }

  /**
   * Predicts; events before the last one are dropped, the rest is used. Sends the choices, then the predictions. Throws a
   * ProtocolError or an EventError, nothing changed, where a number cannot be used.
   * @param {number[][]} rows t, x, y, dx, dy (NaN: no counts), buttons
   */
  feed(rows) {
    if (!this.isWatched) {
      const answers = this.#pipeline.advanceAll(rows);
      if (answers !== null) return this.#reply(rows, answers);
    }
    this.check(rows);
    const { used, dropped } = this.#inOrder(rows);
    if (used.length) this.#follow(used);
    if (dropped !== null) this.#send(dropped);
  }

  /** Whether something is to be done after each event: a target or a place chosen. */
  get isWatched() {
    return this.#tracker !== null || this.hello.places;
  }

  /** Throws a ProtocolError for a number that cannot be used. @param {number[][]} rows */
  check(rows) {
    checkRows(rows);
  }

  /** An event as it is used. @param {number[]} row @returns {number[]|null} null: it cannot be */
  move(row) {
    return row;
  }

  /** What the newest prediction changes: nothing, unless the cursor is assisted. @param {number[]} _answer */
  guide(_answer) {}

  /** Predicts from events in order, one by one, and decides after each. */
  #follow(rows) {
    if (this.#tracker === null && this.hello.places)
      this.#placeTracker ??= new PlaceTracker(this.#send, this.#pipeline, this.#precision);
    const moved = [],
      answers = [],
      likely = [],
      { aim } = this.#tracker?.chooser.pipeline ?? {};
    for (const row of rows) {
      const event = this.move(row),
        answer = event && this.#pipeline.advance(event);
      if (!answer || isRefused(answer)) throw new ProtocolError("bad_field", "the events cannot be used", "$.events");
      moved.push(event);
      answers.push(answer);
      this.guide(answer);
      (this.#tracker ?? this.#placeTracker)?.follow();
      if (aim) likely.push({ target: aim.target, targets: aim.likeliest() });
    }
    this.#reply(moved, answers, likely);
  }

  /** Records the events that were used, and sends the predictions; `likely`: what the targets make of each. */
  #reply(rows, answers, likely = []) {
    const since = this.hello.reply === "event" ? 0 : -1,
      isListed = this.hello.encoding === "json";
    this.#lastTime = rows.at(-1)[0];
    for (const row of rows) this.#trial.add(row);
    this.beforePredictions(this.#lastTime);
    const aims = likely.slice(since);
    answers
      .slice(since)
      .forEach((answer, i) => this.#send(messageOf(answer, aims[i]?.target, isListed ? aims[i]?.targets : undefined)));
  }

  /** Sends what goes before the predictions: nothing, unless the cursor is assisted. @param {number} _t of the newest event, s */
  beforePredictions(_t) {}

  send(message) {
    this.#send(message);
  }

  /** What the newest prediction knows beyond one law. @returns {import("./mixture.js").Mixture|null} */
  get mixture() {
    return this.#pipeline.mixture;
  }

  /** Another predictor or other parameters begin without memory; rejects with a ProtocolError, nothing changed. @param {Message} message checked */
  async configure(message) {
    this.checkAssist(message);
    const another = message.predictor != null,
      { hello } = this;
    const changed = {
      ...hello,
      predictor: message.predictor ?? hello.predictor,
      reply: message.reply ?? hello.reply,
      parameters: { ...(another ? {} : hello.parameters), ...message.parameters },
      assist: message.assist ?? hello.assist,
      places: message.places ?? hello.places,
    };
    if (another || Object.keys(message.parameters ?? {}).length) {
      const pipeline = this.#inWindow(await pipelineOf(changed));
      const [own, ofTargets] = this.#pipeline.person.split("+");
      if (pipeline.name === this.#pipeline.name && pipeline.portable) pipeline.restore(own);
      const { aim } = pipeline; // from now on it follows the cursor
      if (ofTargets) aim.restore(ofTargets);
      if (this.#tracker) pipeline.register(this.#tracker.targets);
      this.#goOnWith(pipeline);
    }
    this.hello = changed;
    if (!changed.places) {
      this.#placeTracker?.reset();
      this.#placeTracker = null;
    }
    this.#precision = message.precision ?? this.#precision;
    if (message.precision != null)
      for (const one of [this.#tracker, this.#placeTracker]) one?.configure(message.precision);
  }

  /** Throws a ProtocolError where assistance is changed that was never asked for. @param {Message} message */
  checkAssist({ assist }) {
    if (assist != null)
      throw new ProtocolError(
        "out_of_place",
        "expected assistance to be asked for in 'hello'; it may be changed afterwards",
        "$.assist",
      );
  }

  /** Replaces the targets; throws a ProtocolError, nothing changed. @param {import("../index.d.ts").Target[]} targets */
  replaceTargets(targets) {
    const tracker = this.#tracker ?? new TargetTracker(this.#send, this.#pipeline, this.#precision);
    tracker.replace(targets);
    this.#tracker = targets.length ? tracker : null;
    this.#placeTracker?.reset();
  }

  /** Forgets every event: the next one starts a movement. */
  reset() {
    this.#pipeline.reset();
    this.forget();
  }

  /** What is known of the person; with a replacement the session begins anew, knowing that. @param {string} [replacement] @returns {Promise<string>} */
  async person(replacement) {
    if (replacement != null) {
      const pipeline = this.#inWindow(await pipelineOf({ ...this.hello, person: replacement }));
      if (this.#tracker) pipeline.register(this.#tracker.targets);
      this.#goOnWith(pipeline);
    }
    return this.#pipeline.person;
  }

  /** Another pipeline begins without a movement. */
  #goOnWith(pipeline) {
    pipeline.reset();
    this.#pipeline = pipeline;
    for (const one of [this.#tracker, this.#placeTracker]) if (one) one.pipeline = pipeline;
    this.forget();
  }

  /** The next movement is in this window. @param {[string, number, number]} window its name and origin */
  enter(window) {
    this.#window = window;
    this.#inWindow(this.#pipeline);
  }

  /** Forgets the person and the movement; the window stays. @returns {string} what is then known of the person: "" */
  forgetPerson() {
    this.#pipeline.forget();
    this.#inWindow(this.#pipeline);
    this.forget();
    return this.#pipeline.person;
  }

  /** The pipeline, in the window that the client named last. */
  #inWindow(pipeline) {
    if (this.#window !== null) pipeline.enter(...this.#window);
    return pipeline;
  }

  /** A movement starts at the next event. Throws a ProtocolError. @param {{x: number, y: number}|null} goal @param {object} conditions what the trial is */
  startTrial(goal, conditions) {
    this.#trial.start(goal, conditions);
    this.reset();
  }

  /** Scores the trial; rejects with a ProtocolError where none was started. @param {{x: number, y: number}|null} goal @param {object} conditions @returns {Promise<object>} */
  async endTrial(goal, conditions) {
    if (!this.#trial.running)
      throw new ProtocolError("out_of_place", "expected 'trial' with action 'start' before 'end'", "$.action");
    this.#trial.describe(conditions);
    const outcome = this.#tracker?.finishTrial(goal ?? this.#trial.goal) ?? {},
      trial = this.#trial.end();
    const { scoreOf } = await import("./scoring.js");
    return { ...(await scoreOf(trial, this.#pipeline.fresh())), ...outcome };
  }

  /** Forgets what depends on the movement. */
  forget() {
    this.#lastTime = -Infinity;
    this.#tracker?.reset();
    this.#placeTracker?.reset();
  }

  /** The events that do not run backwards, and the error for those that do, null for none. @param {number[][]} rows */
  #inOrder(rows) {
    let latest = this.#lastTime,
      /** @type {{row: number, t: number, before: number}|null} */ first = null,
      late = 0;
    const used = rows.filter(([t], row) => {
      const backwards = t < latest;
      if (backwards) first ??= { row, t, before: latest };
      late += Number(backwards);
      latest = Math.max(latest, t);
      return !backwards;
    });
    if (first === null) return { used, dropped: null };
    const also = late > 1 ? ` (${late - 1} more in this frame)` : "",
      { row, t, before } = first;
    const sentence = `t must not run backwards: ${t} s after ${before} s; dropped${also}`;
    return {
      used,
      dropped: new ProtocolError("out_of_order", sentence, `$.events[${row}][0]`, { field: "t", value: t }).answer,
    };
  }
}

/** A fresh pipeline that knows the person of a hello; rejects with a ProtocolError. @param {Message} hello */
async function pipelineOf({ predictor, parameters, device, screen, person }) {
  for (const [name, place] of Object.entries(ELSEWHERE))
    if (Object.hasOwn(parameters, name)) {
      const sentence = `${name} is no parameter of a predictor; it belongs to ${place}`;
      throw new ProtocolError("bad_field", sentence, `$.parameters.${name}`, { field: name, value: parameters[name] });
    }
  try {
    return await build(predictor, { cpi: device?.cpi ?? null, dpi: screen?.dpi, person, ...parameters });
  } catch (error) {
    if (!(error instanceof ParameterError)) throw error;
    const code = error.code === "unknown_predictor" ? error.code : "bad_field";
    throw new ProtocolError(code, error.message, pathOf(error, parameters), error);
  }
}

/** Where in a message the parameter stands that an error is about: it may be a default that does not go with a given one. */
function pathOf({ code, field }, parameters) {
  if (code === "unknown_predictor") return "$.predictor";
  if (field === "person") return "$.person";
  if (Object.hasOwn(parameters, field)) return `$.parameters.${field}`;
  const names = Object.keys(parameters);
  return names.length === 1 ? `$.parameters.${names[0]}` : "$.parameters";
}
