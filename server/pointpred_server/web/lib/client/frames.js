// Encodes events and targets as messages within the service's limits, and decodes packed predictions.

import { EVENT_FIELDS, NO_COUNTS, PREDICTED } from "../laws/fields.js";
import { messageOf } from "../prediction/row.js";

const KINDS = { "<f8": ["Float64", 8], "<i2": ["Int16", 2], "<u2": ["Uint16", 2], "<u1": ["Uint8", 1] };

/** How a record is packed: the bytes, and for each field its place and the methods of a DataView. */
function layoutOf(fields) {
  let bytes = 0;
  const layout = fields.map(({ packed, optional }) => {
    const [kind, size] = KINDS[packed],
      at = bytes;
    bytes += size;
    return { at, get: `get${kind}`, set: `set${kind}`, optional };
  });
  return { bytes, layout };
}

const EVENT = layoutOf(EVENT_FIELDS),
  PREDICTION = layoutOf(PREDICTED);
const GRID = 64; // steps per px: the browser's layout has no finer ones
const BYTES = new TextEncoder();

/**
 * Splits events into messages that the limits allow, each with its number of events and the time of the last one.
 * @param {import("../index.d.ts").EventRow[]} rows @param {"binary"|"json"} encoding
 * @param {import("../index.d.ts").Limits} limits
 * @returns {Generator<{frame: string|ArrayBuffer, last: number, count: number}>}
 */
export const frames = (rows, encoding, limits) =>
  encoding === "binary" ? binaryFrames(rows, limits) : textFrames(rows, limits);

/**
 * An event as the row that is sent; throws a RangeError where a value cannot be sent.
 * @param {import("../index.d.ts").EventRow|import("../index.d.ts").PointerSample} event
 * @returns {import("../index.d.ts").EventRow}
 */
export function row(event) {
  const [t, x, y, dx = null, dy = null, buttons = 0] = Array.isArray(event)
    ? event
    : [event.t, event.x, event.y, event.dx, event.dy, event.buttons];
  if (![t, x, y].every(Number.isFinite)) throw new RangeError(`t, x and y must be finite, received ${[t, x, y]}`);
  for (const count of [dx, dy])
    if (count !== null && !(Number.isInteger(count) && Math.abs(count) < -NO_COUNTS))
      throw new RangeError(`counts must be whole numbers within 32767, received ${count}`);
  return [t, x, y, dx, dy, buttons];
}

const onGrid = (px) => Math.round(GRID * px) / GRID;

/**
 * The message with all targets; the last ones are left out where the limits allow fewer.
 * @param {import("../index.d.ts").NamedTarget[]} targets @param {Partial<import("../index.d.ts").Limits>} [limits]
 * @returns {{text: string, count: number, omitted: number}}
 */
export function targetsFrame(targets, { max_targets: most, max_frame_bytes: bytes = Infinity } = {}) {
  const [head, tail] = ['{"type":"targets","targets":[', "]}"];
  const parts = [];
  let size = head.length + tail.length;
  for (const target of targets.slice(0, most)) {
    const { x, y, width, height } = target;
    const [right, high] = [width, height].map((side) => (side > 0 ? Math.max(1 / GRID, onGrid(side)) : side));
    const text = JSON.stringify({ ...target, x: onGrid(x), y: onGrid(y), width: right, height: high });
    size += BYTES.encode(text).length + 1;
    if (size > bytes) break;
    parts.push(text);
  }
  return { text: head + parts.join(",") + tail, count: parts.length, omitted: targets.length - parts.length };
}

/** Packed records. */
function* binaryFrames(rows, { max_events_per_frame: most, max_frame_bytes: bytes }) {
  const room = Math.max(1, Math.min(most, Math.floor(bytes / EVENT.bytes)));
  for (let first = 0; first < rows.length; first += room) {
    const part = rows.slice(first, first + room);
    const view = new DataView(new ArrayBuffer(EVENT.bytes * part.length));
    part.forEach((one, i) => {
      const without = one.includes(null);
      EVENT.layout.forEach(({ at, set, optional }, k) =>
        view[set](EVENT.bytes * i + at, optional && without ? NO_COUNTS : one[k], true),
      );
    });
    yield { frame: view.buffer, last: part[part.length - 1][0], count: part.length };
  }
}

/** JSON messages. */
function* textFrames(rows, { max_events_per_frame: most, max_frame_bytes: bytes }) {
  const [head, tail] = ['{"type":"events","events":[', "]}"];
  let part = [],
    size = head.length + tail.length,
    last = 0;
  for (const one of rows) {
    const text = JSON.stringify(one);
    if (part.length && (part.length === most || size + text.length + 1 > bytes)) {
      yield { frame: head + part.join(",") + tail, last, count: part.length };
      [part, size] = [[], head.length + tail.length];
    }
    part.push(text);
    size += text.length + 1;
    last = one[0];
  }
  yield { frame: head + part.join(",") + tail, last, count: part.length };
}

/**
 * Packed predictions as the same objects that JSON gives.
 * @param {ArrayBuffer} buffer @param {string[]} ids of the targets that the service has, in the order sent
 * @returns {Generator<import("../index.d.ts").Prediction>}
 */
export function* decode(buffer, ids) {
  const view = new DataView(buffer);
  for (let first = 0; first + PREDICTION.bytes <= buffer.byteLength; first += PREDICTION.bytes) {
    const row = PREDICTION.layout.map(({ at, get }) => view[get](first + at, true)),
      place = row.pop();
    yield messageOf(row, ids.length ? (ids[place] ?? null) : undefined);
  }
}
