// Encodes events and targets as messages within the service's limits, and decodes packed predictions.

import { PHASES } from "../prediction/row.js";

const EVENT_BYTES = 30;
const PREDICTION_BYTES = 65;
const NO_COUNTS = -32768;
const GRID = 64; // steps per px: the browser's layout has no finer ones
const BYTES = new TextEncoder();

/**
 * Splits events into messages that the limits allow, each with its number of events and the time of the last one.
 * @param {import("../pointpred.js").EventRow[]} rows @param {"binary"|"json"} encoding
 * @param {import("../pointpred.js").Limits} limits
 * @returns {Generator<{frame: string|ArrayBuffer, last: number, count: number}>}
 */
export const frames = (rows, encoding, limits) => (encoding === "binary" ? binaryFrames(rows, limits) : textFrames(rows, limits));

/**
 * An event as the row that is sent; throws a RangeError where a value cannot be sent.
 * @param {import("../pointpred.js").EventRow|import("../pointpred.js").EventRecord} event
 * @returns {import("../pointpred.js").EventRow}
 */
export function row(event) {
  const [t, x, y, dx = null, dy = null, buttons = 0] = Array.isArray(event) ? event
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
 * @param {import("../pointpred.js").Target[]} targets @param {import("../pointpred.js").Limits} [limits]
 * @returns {{text: string, count: number, omitted: number}}
 */
export function targetsFrame(targets, { max_targets: most, max_frame_bytes: bytes } = {}) {
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
  const room = Math.max(1, Math.min(most, Math.floor(bytes / EVENT_BYTES)));
  for (let first = 0; first < rows.length; first += room) {
    const part = rows.slice(first, first + room);
    const view = new DataView(new ArrayBuffer(EVENT_BYTES * part.length));
    part.forEach(([t, x, y, dx, dy, buttons], i) => {
      const at = EVENT_BYTES * i;
      [t, x, y].forEach((value, k) => view.setFloat64(at + 8 * k, value, true));
      view.setInt16(at + 24, dx === null || dy === null ? NO_COUNTS : dx, true);
      view.setInt16(at + 26, dx === null || dy === null ? NO_COUNTS : dy, true);
      view.setUint16(at + 28, buttons, true);
    });
    yield { frame: view.buffer, last: part[part.length - 1][0], count: part.length };
  }
}

/** JSON messages. */
function* textFrames(rows, { max_events_per_frame: most, max_frame_bytes: bytes }) {
  const [head, tail] = ['{"type":"events","events":[', "]}"];
  let part = [], size = head.length + tail.length, last = 0;
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

/** Packed predictions as the same objects that JSON gives. @returns {Generator<import("../pointpred.js").Prediction>} */
export function* decode(buffer) {
  const view = new DataView(buffer);
  for (let at = 0; at + PREDICTION_BYTES <= buffer.byteLength; at += PREDICTION_BYTES) {
    const [t, x, y, sxx, sxy, syy, remaining] = Array.from({ length: 7 }, (_, k) => view.getFloat64(at + 8 * k, true));
    const tail = view.getFloat64(at + 57, true), predicted = !Number.isNaN(x);
    yield { type: "prediction", t, x: predicted ? x : null, y: predicted ? y : null,
      region: Number.isNaN(sxx) ? null : { sxx, sxy, syy, tail: Number.isNaN(tail) ? null : tail },
      phase: predicted ? PHASES[view.getUint8(at + 56)] : null,
      remaining_s: Number.isNaN(remaining) ? null : remaining };
  }
}
