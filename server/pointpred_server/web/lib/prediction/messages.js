// What a client may say to a session in the page: the messages of `pointpred.v1` and their bounds, as in `pointpred/protocol`.

import { EVENT_FIELDS } from "../laws/fields.js";
import { CLIENT_MESSAGES } from "../laws/messages.js";
import { general, quoted } from "./words.js";

/** A message is refused: `answer` is the message that says so. */
export class ProtocolError extends Error {
  /** @param {string} code @param {string} message @param {string|null} [path] @param {{field?: string, value?: unknown, recoverable?: boolean}} [more] */
  constructor(code, message, path = null, { field, value, recoverable = true } = {}) {
    super(message);
    /** @type {import("../index.d.ts").ErrorMessage & {value?: unknown}} */
    this.answer = { type: "error", code, message, path, recoverable };
    if (field) this.answer.field = field;
    if (field && (value === null || ["string", "boolean"].includes(typeof value) || Number.isFinite(value)))
      this.answer.value = value;
  }
}

/**
 * @typedef {Record<string, any>} Schema a JSON schema, as `laws/messages.js` holds them
 * @typedef {{type: string, [field: string]: any}} Message of a client: what a schema allows
 */

function refuse(expected, value, path) {
  throw new ProtocolError("bad_field", `expected ${expected}, received ${quoted(value)}`, path);
}

/** The kind of a value, as schemas name it. */
const kindOf = (value) => (value === null ? "null" : Array.isArray(value) ? "array" : typeof value);

/** Whether a value is of the kind that a schema asks for. @param {Schema} schema */
const isOf = (schema, value) =>
  schema.enum !== undefined ||
  schema.type === undefined ||
  (schema.type === "integer" ? Number.isInteger(value) : kindOf(value) === schema.type);

/** Throws a ProtocolError for a value that a schema does not allow. @param {Schema} schema @param {unknown} value @param {string} path */
function check(schema, value, path) {
  if (schema.anyOf !== undefined) {
    const fitting = schema.anyOf.find((one) => isOf(one, value));
    if (fitting === undefined) refuse(schema.anyOf.map((one) => one.type).join(" or "), value, path);
    return check(fitting, value, path);
  }
  if (!isOf(schema, value)) refuse(schema.type, value, path);
  if (schema.enum !== undefined && !schema.enum.includes(value))
    refuse(`one of ${schema.enum.join(", ")}`, value, path);
  if (typeof value === "number") checkNumber(schema, value, path);
  if (
    typeof value === "string" &&
    (value.length < (schema.minLength ?? 0) || value.length > (schema.maxLength ?? Infinity))
  )
    refuse(`a text of ${schema.minLength ?? 0} to ${schema.maxLength} characters`, value, path);
  if (typeof value === "string" && schema.pattern !== undefined && !new RegExp(schema.pattern, "u").test(value))
    refuse(`a text like ${schema.pattern}`, value, path);
  if (Array.isArray(value)) value.forEach((one, i) => check(schema.items, one, `${path}[${i}]`));
  else if (kindOf(value) === "object") checkFields(schema, /** @type {object} */ (value), path);
}

function checkNumber(schema, value, path) {
  const { minimum = -Infinity, maximum = Infinity, exclusiveMinimum = -Infinity } = schema;
  if (!Number.isFinite(value)) refuse("a finite number", value, path);
  if (!(value > exclusiveMinimum)) refuse(`a number above ${general(exclusiveMinimum)}`, value, path);
  if (!(value >= minimum && value <= maximum))
    refuse(`a number in [${general(minimum)}, ${general(maximum)}]`, value, path);
}

/**
 * An object with the fields of a schema and no others; fields that are undefined count as missing.
 * @param {Schema} schema @param {object} value @param {string} path
 */
function checkFields(
  { properties = {}, required = [], additionalProperties = true, propertyNames, maxProperties = Infinity },
  value,
  path,
) {
  if (Object.keys(value).length > maxProperties)
    refuse(`at most ${maxProperties} entries`, Object.keys(value).length, path);
  if (propertyNames !== undefined) for (const name of Object.keys(value)) check(propertyNames, name, path);
  for (const name of Object.keys(value))
    if (additionalProperties === false && !Object.hasOwn(properties, name))
      throw new ProtocolError("bad_field", `unknown field ${quoted(name)}`, `${path}.${name}`);
  for (const name of required)
    if (value[name] === undefined)
      throw new ProtocolError("bad_field", `the field ${quoted(name)} is missing`, `${path}.${name}`);
  for (const [name, one] of Object.entries(value))
    if (one !== undefined) check(properties[name] ?? additionalProperties, one, `${path}.${name}`);
}

/**
 * The fields that are given, and the defaults of the others.
 * @template {object} Given
 * @param {Schema} schema @param {Given} given @returns {Given}
 */
const filled = ({ properties }, given) => ({
  ...Object.fromEntries(
    Object.entries(properties)
      .filter(([, one]) => "default" in one)
      .map(([name, one]) => [name, one.default]),
  ),
  ...given,
});
/** The schema of an object that may be null. */
const objectIn = ({ anyOf }) => anyOf.find((one) => one.type === "object");
const { assist: ASSIST, screen: SCREEN } = CLIENT_MESSAGES.hello.properties;

/** A message with the fields that it leaves out; throws a ProtocolError. @param {Message} message @returns {Message} */
export function checked(message) {
  const kind = message?.type;
  if (typeof kind !== "string" || !Object.hasOwn(CLIENT_MESSAGES, kind)) {
    const known = Object.keys(CLIENT_MESSAGES).join(", ");
    throw new ProtocolError(
      ["string", "undefined"].includes(typeof kind) ? "unknown_type" : "bad_field",
      `unknown message ${quoted(kind)}; known: ${known}`,
      "$.type",
      { field: "type", value: kind },
    );
  }
  check(CLIENT_MESSAGES[kind], message, "$");
  if (kind !== "hello" && kind !== "configure") return message;
  const assist = message.assist && filled(objectIn(ASSIST), message.assist);
  if (kind === "configure") return { ...message, assist };
  return { ...filled(CLIENT_MESSAGES.hello, message), screen: filled(objectIn(SCREEN), message.screen), assist };
}

/** Throws a ProtocolError for the first number of an event that is out of range, or a count without the other. @param {number[][]} rows */
export function checkRows(rows) {
  const counts = EVENT_FIELDS.flatMap(({ optional }, k) => (optional ? [k] : []));
  rows.forEach((row, i) =>
    EVENT_FIELDS.forEach(({ name, low, high, whole, optional }, k) => {
      const refuse = (message, value) => {
        throw new ProtocolError("bad_field", message, `$.events[${i}][${k}]`, { field: name, value });
      };
      const value = row[k];
      if (optional && Number.isNaN(value)) {
        if (counts.every((one) => Number.isNaN(row[one]))) return;
        refuse("dx and dy are both numbers or both null", null);
      }
      if (!(value >= low && value <= high))
        refuse(`${name} must lie in [${general(low)}, ${general(high)}], received ${value}`, value);
      if (whole && !Number.isInteger(value)) refuse(`${name} must be a whole number, received ${value}`, value);
    }),
  );
}
