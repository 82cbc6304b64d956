// A differentiator and a predictor, joined, and the targets: events in, predictions out.

import { EVENT_FIELDS, MOTION_FIELDS } from "../laws/fields.js";
import { EVENT_FIELD, MOTION_FIELD, ORDER } from "../laws/records.js";
import { Aim } from "./aim.js";
import { EventError, ParameterError } from "./errors.js";
import { claimed, isRefused, PHASES, UNPREDICTED } from "./row.js";
import { SCREEN, sceneOf } from "./scene.js";
import { general, quoted } from "./words.js";

/**
 * @import { Place, PointerSample } from "../index.d.ts"
 * @typedef {import("./stage.js").Row} Row
 */

/** Where a movement will end, as seen at `t`. */
export class Prediction {
  /** @param {Row} row t, x, y, sxx, sxy, syy, remaining_s, phase, tail, remaining_spread; NaN: not claimed */
  constructor([t, x, y, sxx, sxy, syy, remaining, phase, tail, spread]) {
    /** s */ this.t = t;
    /** px */ this.x = x;
    /** px */ this.y = y;
    /** [sxx, sxy, syy] px^2: the scale matrix of the endpoint's law. @type {number[]|null} */
    this.scale = sxx === sxx ? [sxx, sxy, syy] : null;
    /** @type {"still"|"ballistic"|"corrective"} */ this.phase = PHASES[phase];
    /** s until arrival. @type {number|null} */ this.remaining_s = claimed(remaining);
    /** Degrees of freedom of a Student law; null: the law is normal. @type {number|null} */ this.tail = claimed(tail);
    /** Standard deviation of the logarithm of the time left. @type {number|null} */ this.remaining_spread =
      claimed(spread);
  }

  /** [sxx, sxy, syy] px^2 of the endpoint; null where no region is claimed, or its law has none (a tail up to 2). @returns {number[]|null} */
  get covariance() {
    if (this.scale === null || this.tail === null) return this.scale;
    if (!(this.tail > 2)) return null;
    const wider = 1 / (1 - 2 / this.tail);
    return this.scale.map((part) => wider * part);
  }

  /** The law as `regionOf` takes it. @returns {{sxx: number, sxy: number, syy: number, tail: number|null}|null} */
  get region() {
    if (this.scale === null) return null;
    const [sxx, sxy, syy] = this.scale;
    return { sxx, sxy, syy, tail: this.tail };
  }
}

/** The prediction of a row; null where it claims no endpoint. @param {Row} row @returns {Prediction|null} */
const predictionOf = (row) => (row[1] === row[1] ? new Prediction(row) : null);

/** Consumes events one by one. Where an event is refused, nothing has changed. */
export class Pipeline {
  #differentiator;
  #predictor;
  /** @type {Aim|null} */
  #aim = null;

  /**
   * Use `build`.
   * @param {string} name @param {import("./stage.js").Stage} differentiator @param {import("./stage.js").Stage} predictor
   */
  constructor(name, differentiator, predictor) {
    this.name = name;
    [this.#differentiator, this.#predictor] = [differentiator, predictor];
  }

  /**
   * Consumes one event; null where nothing is justified now. Throws an EventError for a time before the last
   * (`code` "time_backwards") and for a value that is not finite or out of range.
   * @param {PointerSample} event @returns {Prediction|null}
   */
  update(event) {
    const wrong = wrongKind(event);
    if (wrong !== null) throw wrong;
    const { t, x, y, dx, dy, buttons = 0 } = event;
    const row = [t, x, y, dx ?? NaN, dy ?? NaN, buttons],
      answer = this.advance(row);
    if (isRefused(answer)) throw refusal(row, answer);
    return predictionOf(answer);
  }

  /**
   * `update` in rows: t, x, y, dx, dy (NaN: no counts), buttons in; the ten numbers of a prediction out, x NaN where nothing
   * is justified. Of an event that is refused the first is NaN, and the next two say why.
   * @param {Row} row @returns {Row}
   */
  advance(row) {
    this.#differentiator.keep(); // it has moved on when the predictor refuses its motion
    let answer = UNPREDICTED;
    try {
      const motion = this.#differentiator.advance(row);
      answer = isRefused(motion) ? motion : this.#predictor.advance(motion);
    } finally {
      if (isRefused(answer)) this.#differentiator.recall();
    }
    return this.#aim === null || isRefused(answer) ? answer : this.#aim.given(row, answer);
  }

  /**
   * `advance` for rows in turn: all are taken in, or none. Null where one of them is refused.
   * @param {Row[]} rows @returns {Row[]|null}
   */
  advanceAll(rows) {
    if (rows.length === 1) {
      // most frames
      const answer = this.advance(rows[0]);
      return isRefused(answer) ? null : [answer];
    }
    const before = this.remembered,
      answers = [];
    try {
      for (const row of rows) {
        const answer = this.advance(row);
        if (isRefused(answer)) break;
        answers.push(answer);
      }
    } finally {
      if (answers.length < rows.length) this.remembered = before;
    }
    return answers.length < rows.length ? null : answers;
  }

  /** Copies of all memories; setting them goes on from there. */
  get remembered() {
    const stages = [this.#differentiator, this.#predictor, this.#aim].filter((one) => one !== null);
    return stages.map(({ remembered }) => remembered);
  }

  set remembered([ofDifferentiator, ofPredictor, ofTargets]) {
    this.#differentiator.remembered = ofDifferentiator;
    this.#predictor.remembered = ofPredictor;
    if (this.#aim) this.#aim.remembered = ofTargets;
  }

  /**
   * Takes these targets, in place of those before, as what can be pointed at; none: as if nobody had. From the next event on the
   * endpoint, its region and the time left are those of a movement to one of them or elsewhere. `reset` keeps them. At most 1000;
   * throws a ParameterError, nothing changed.
   * @param {readonly import("../index.d.ts").Target[]} targets
   */
  register(targets) {
    this.aim.register(targets);
  }

  /** The registered targets and what is known of them, for those that decide among them. @type {Aim} */
  get aim() {
    return (this.#aim ??= new Aim());
  }

  set aim(aim) {
    this.#aim = aim;
  }

  /** How likely the movement is for each registered target, by its id; null: for none of them. @returns {Map<unknown, number>} */
  get shares() {
    const shares = this.#aim?.shares ?? [1];
    return new Map([...(this.#aim?.ids ?? []), null].map((id, i) => [id, shares[i]]));
  }

  /**
   * What the last prediction knows beyond one law: the targets and places where it may end, and elsewhere. Null where nothing is
   * justified now, and where neither targets are registered nor the predictor learns places.
   * @returns {import("./mixture.js").Mixture|null}
   */
  get mixture() {
    const own = this.#predictor.mixture;
    return this.#aim === null || this.#aim.ids.length === 0 ? own : this.#aim.mixture(own);
  }

  /** Whether finished movements change what is said of the next: then only a new person starts fresh. */
  get learns() {
    return this.#predictor.learns || (this.#aim?.learns ?? false);
  }

  /** Whether what finished movements taught can be saved. */
  get portable() {
    return this.#predictor.portable;
  }

  /**
   * What finished movements taught of the person, for `build(name, { person })`: the string that Python's pipelines give. ""
   * while nobody is known, and always where nothing is learned or can be saved (`ktm`). `reset` finishes the current movement.
   * What is known of the targets that the person takes stands behind a `+`.
   * @returns {string}
   */
  get person() {
    const taken = this.#aim?.person ?? "";
    return taken ? `${this.#predictor.person}+${taken}` : this.#predictor.person;
  }

  /**
   * Where movements of this person ended before, the likeliest destination first; at most 64, those of the window that `enter`
   * named. Before a movement has begun `p` is `before`, for a movement from where the last one ended. Empty where no places are learned.
   * @returns {Place[]}
   */
  get places() {
    const places = this.#predictor.places.map(([x, y, p, before, visits, id, spread]) => ({
      x,
      y,
      p,
      before,
      visits,
      id,
      spread,
    }));
    return places.sort((one, other) => other.p - one.p);
  }

  /**
   * The next movement is in this window or page; one that goes on stays in the window it began in. Places are remembered for
   * each name and relative to the origin. Throws a ParameterError, nothing changed.
   * @param {string} key "" is the screen @param {number} [x] of the origin, px @param {number} [y]
   */
  enter(key, x = 0, y = 0) {
    this.#predictor.enter(sceneOf(key, x, y));
  }

  /** Forgets the person, the movement and the window. */
  forget() {
    [this.#differentiator, this.#predictor] = [this.#differentiator.fresh(), this.#predictor.fresh()];
    this.#predictor.enter(SCREEN);
    this.#aim = this.#aim?.fresh() ?? null;
  }

  /** Forgets every event: the next one starts a movement. What is known of the person stays. */
  reset() {
    this.#differentiator.reset();
    this.#predictor.reset();
    this.#aim?.reset();
  }

  /** A pipeline with the same parameters and targets and no memory, which knows nobody. @returns {Pipeline} */
  fresh() {
    const pipeline = new Pipeline(this.name, this.#differentiator.fresh(), this.#predictor.fresh());
    pipeline.#predictor.enter(SCREEN);
    pipeline.#aim = this.#aim?.fresh() ?? null;
    return pipeline;
  }

  /** Goes on with what is known of a person; for a pipeline without memory. Throws a ParameterError. @param {string} person */
  restore(person) {
    const at = typeof person === "string" ? person.indexOf("+") : -1;
    if (at >= 0 && at === person.length - 1)
      throw new ParameterError("person must not end with '+'; is it cut off?", { field: "person" });
    if (at >= 0) new Aim().restore(person.slice(at + 1)); // refused before anything is changed
    this.#predictor.restore(at < 0 ? person : person.slice(0, at));
    if (at >= 0) this.aim.restore(person.slice(at + 1));
  }
}

/** The error for an event that the laws refuse with this answer. @param {Row} row @param {Row} answer @returns {EventError} */
function refusal(row, [, code, compared]) {
  const [t, , , dx, dy] = row;
  if (code === ORDER) {
    const message = `t must not run backwards: received ${t} s after ${compared} s`;
    return new EventError(message, { code: "time_backwards", field: "t", value: t });
  }
  const ofMotion = code >= MOTION_FIELD,
    value = ofMotion ? compared : row[code - EVENT_FIELD];
  const { name, low, high, optional } = ofMotion
    ? MOTION_FIELDS[code - MOTION_FIELD]
    : EVENT_FIELDS[code - EVENT_FIELD];
  if (optional && value !== value)
    return new EventError(`dx and dy come together or not at all, received ${claimed(dx)} and ${claimed(dy)}`, {
      field: "dx",
      value: claimed(dx),
    });
  const expected = value >= low && value <= high ? "be a whole number" : `lie in [${general(low)}, ${general(high)}]`;
  return new EventError(`${name} must ${expected}, received ${value}`, { field: name, value });
}

/** The error for an event with a field that is no number, null for none. A count may be missing. */
function wrongKind(event) {
  if (event === null || typeof event !== "object")
    return new EventError(`an event must be an object, received ${quoted(event)}`);
  for (const name of ["t", "x", "y", "dx", "dy", "buttons"]) {
    const value = event[name] ?? null,
      missing = value === null && !["t", "x", "y"].includes(name);
    if (!missing && typeof value !== "number")
      return new EventError(`${name} must be a number, received ${quoted(value)}`, { field: name, value });
    if (value !== value) return new EventError(`${name} must be finite, received NaN`, { field: name, value });
  }
  return null;
}
