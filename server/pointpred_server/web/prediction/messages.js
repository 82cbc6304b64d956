// What a client may say to a session in the page: the messages of `pointpred.v1` and their bounds, as in `pointpred/protocol`.

import { LARGEST, LATEST_S } from "../laws/records.js";
import { RECOMMENDED } from "../laws/registry.js";
import { SMALLEST_PX } from "../laws/targets/rectangles.js";
import { general, quoted } from "./words.js";


/** A message is refused: `answer` is the message that says so. */
export class ProtocolError extends Error {
  /** @param {string} code @param {string} message @param {string|null} [path] @param {{field?: string, value?: unknown, recoverable?: boolean}} [more] */
  constructor(code, message, path = null, { field, value, recoverable = true } = {}) {
    super(message);
    this.answer = { type: "error", code, message, path, recoverable };
    if (field) this.answer.field = field;
    if (field && (value === null || ["string", "boolean"].includes(typeof value) || Number.isFinite(value))) this.answer.value = value;
  }
}

function refuse(expected, value, path) {
  throw new ProtocolError("bad_field", `expected ${expected}, received ${quoted(value)}`, path);
}

/** @typedef {(value: unknown, path: string) => void} Check throws a ProtocolError */

/** A number within closed bounds. @returns {Check} */
const number = (low, high) => (value, path) => {
  if (typeof value !== "number" || !(value >= low && value <= high)) refuse(`a number in [${general(low)}, ${general(high)}]`, value, path);
};
const positive = (value, path) => {
  if (!(typeof value === "number" && value > 0 && value <= LARGEST)) refuse(`a number above 0, at most ${general(LARGEST)}`, value, path);
};
const text = (least, most) => (value, path) => {
  if (typeof value !== "string" || value.length < least || value.length > most) refuse(`a text of ${least} to ${most} characters`, value, path);
};
const oneOf = (...words) => (value, path) => words.includes(value) || refuse(`one of ${words.join(", ")}`, value, path);
const truth = (value, path) => typeof value === "boolean" || refuse("true or false", value, path);
const orNull = (check) => (value, path) => value === null || check(value, path);
const listOf = (check) => (value, path) => {
  if (!Array.isArray(value)) refuse("a list", value, path);
  value.forEach((one, i) => check(one, `${path}[${i}]`));
};
const anything = () => {};

/** An object with these fields and no others; fields that are undefined count as missing. @returns {Check} */
const fields = (checks, ...required) => (value, path) => {
  if (value === null || typeof value !== "object" || Array.isArray(value)) refuse("an object", value, path);
  for (const name of Object.keys(value))
    if (!Object.hasOwn(checks, name)) throw new ProtocolError("bad_field", `unknown field ${quoted(name)}`, `${path}.${name}`);
  for (const name of required)
    if (value[name] === undefined) throw new ProtocolError("bad_field", `the field ${quoted(name)} is missing`, `${path}.${name}`);
  for (const [name, one] of Object.entries(value)) if (one !== undefined) checks[name](one, `${path}.${name}`);
};

const setting = (value, path) => {
  const plain = ["boolean", "string"].includes(typeof value) || Number.isFinite(value);
  if (!plain && !(Array.isArray(value) && value.every(Number.isFinite))) refuse("a number, a text, true, false or a list of numbers", value, path);
};
const parameters = (value, path) => {
  if (value === null || typeof value !== "object") refuse("an object", value, path);
  for (const [name, one] of Object.entries(value)) setting(one, `${path}.${name}`);
};
const device = fields({ cpi: orNull(number(1, 1e6)), rate_hz: orNull(positive) });
const screen = fields({ width_px: orNull(positive), height_px: orNull(positive), dpi: number(1, 1e5) });
const assist = fields({ strength: number(0, 1), rho: number(0, 1e4), function: oneOf("constant", "sigmoid"), gain: number(0, 1e3) });
const place = number(-LARGEST, LARGEST), extent = number(SMALLEST_PX, LARGEST);
const target = fields({ id: text(1, 128), x: place, y: place, width: extent, height: extent, weight: number(0, LARGEST) },
  "id", "x", "y", "width", "height");
const goal = fields({ x: place, y: place, width: positive }, "x", "y", "width");
const person = text(0, 16384), reply = oneOf("frame", "event"), type = anything;

const MESSAGES = {
  hello: fields({ type, version: number(-LARGEST, LARGEST), predictor: text(0, LARGEST), parameters, device: orNull(device), screen: orNull(screen),
    reply, encoding: oneOf("json", "binary"), assist: orNull(assist), person, places: truth }, "version"),
  events: fields({ type, events: listOf(anything) }, "events"),
  targets: fields({ type, targets: listOf(target) }, "targets"),
  trial: fields({ type, action: oneOf("start", "end"), target: orNull(goal) }, "action"),
  configure: fields({ type, predictor: orNull(text(0, LARGEST)), parameters, reply: orNull(reply), precision: orNull(number(0, 1)), assist: orNull(assist), places: orNull(truth) }),
  enter: fields({ type, key: text(0, 1024), x: place, y: place }, "key"),
  forget: fields({ type }),
  reset: fields({ type }),
  person: fields({ type, person: orNull(person) }),
  bye: fields({ type, reason: text(0, LARGEST) }),
};

/** A message with the fields that it leaves out; throws a ProtocolError. @param {object} message @returns {object} */
export function checked(message) {
  const kind = message?.type;
  if (typeof kind !== "string" || !Object.hasOwn(MESSAGES, kind)) {
    const known = Object.keys(MESSAGES).join(", ");
    throw new ProtocolError(["string", "undefined"].includes(typeof kind) ? "unknown_type" : "bad_field", `unknown message ${quoted(kind)}; known: ${known}`, "$.type",
      { field: "type", value: kind });
  }
  MESSAGES[kind](message, "$");
  return kind === "hello" ? { ...HELLO, ...message, screen: screenOf(message.screen), assist: assistOf(message.assist) }
    : kind === "configure" ? { ...message, assist: assistOf(message.assist) } : message;
}

const HELLO = { predictor: RECOMMENDED, parameters: {}, device: null, reply: "frame", encoding: "json", person: "", places: false };
const assistOf = (given) => given && { strength: 0.5, rho: 8, function: "constant", gain: 4, ...given };
const screenOf = (given) => ({ width_px: null, height_px: null, dpi: 96, ...given });

const BOUNDS = [["t", LATEST_S], ["x", LARGEST], ["y", LARGEST], ["dx", LARGEST], ["dy", LARGEST], ["buttons", LARGEST]];

/** Throws a ProtocolError for the first number of an event that is out of range, or a count without the other. @param {number[][]} rows */
export function checkRows(rows) {
  rows.forEach((row, i) => BOUNDS.forEach(([name, most], k) => {
    const refuse = (message, value) => {
      throw new ProtocolError("bad_field", message, `$.events[${i}][${k}]`, { field: name, value });
    };
    const count = k === 3 || k === 4, value = row[k];
    if (count && Number.isNaN(value) && Number.isNaN(row[7 - k])) return;
    if (count && Number.isNaN(value)) refuse("dx and dy are both numbers or both null", null);
    if (!(Math.abs(value) <= most)) refuse(`${name} must lie in [${general(-most)}, ${general(most)}], received ${value}`, value);
    if (name === "buttons" && !(Number.isInteger(value) && value >= 0)) refuse(`buttons must be a whole number, received ${value}`, value);
  }));
}
