// Sessions whose cursor is moved here: counts in, the assisted cursor and predictions out; as `server/pointpred_server/sessions/assisted_stream.py`.

import { LARGEST } from "../laws/records.js";
import { as_normal as asNormal } from "../laws/regions.js";
import { END, SETTINGS, guarded_step as step, USUAL_GUARD } from "../laws/transfer/assistance.js";
import { CONSTANT, MACOS, SIGMOID, SLOTS } from "../laws/transfer/functions.js";
import { lay_out as layOut, USUAL_TIMES_S } from "../laws/transfer/pixels.js";
import { ProtocolError } from "./messages.js";
import { PredictionStream } from "./stream.js";

/**
 * Counts move the cursor, and the pipeline predicts from where the cursor then is. The first event of the session says where
 * the cursor stands before it; positions in later ones are not used. A reset leaves the cursor where it is.
 */
export class AssistedStream extends PredictionStream {
  #memory;
  /** @type {{place: number[]|null, added: number, guidance: number[]|null}} */
  #cursor = { place: null, added: 0, guidance: null };

  constructor(hello, pipeline, send) {
    super(hello, pipeline, send);
    this.#memory = memoryOf(hello, hello.assist);
  }

  static async open(hello, send) {
    memoryOf(hello, hello.assist); // refuses a hello without counts per inch before anything is loaded
    return super.open(hello, send);
  }

  get isWatched() {
    return true;
  }

  check(rows) {
    super.check(rows);
    const missing = rows.findIndex((row) => Number.isNaN(row[3]));
    if (missing < 0) return;
    const sentence = "assistance needs counts: dx and dy must be numbers";
    throw new ProtocolError("bad_field", sentence, `$.events[${missing}][3]`, { field: "dx", value: null });
  }

  async configure(message) {
    const memory = message.assist == null ? null : memoryOf(this.hello, message.assist);
    await super.configure(message);
    if (memory !== null) this.#memory = memory;
  }

  checkAssist() {}

  forget() {
    super.forget();
    this.#memory.fill(0, SETTINGS);
    this.#cursor = { ...this.#cursor, guidance: null };
  }

  beforePredictions(t) {
    const { place, added } = this.#cursor,
      [x, y] = /** @type {number[]} */ (place);
    this.send({ type: "cursor", t, x, y, added_px: added });
  }

  /** @param {number[]} row */
  move([t, x, y, dx, dy, buttons]) {
    const place = this.#step(t, this.#cursor.place ?? [x, y], dx, dy);
    return place && [t, ...place, dx, dy, buttons];
  }

  /**
   * Where one report brings the cursor, within the screen; null where it is refused.
   * @param {number} t @param {number[]} place @param {number} dx @param {number} dy
   */
  #step(t, [x, y], dx, dy) {
    const [toX, toY, ...spread] = this.#cursor.guidance ?? [];
    const guided = Math.abs(toX - x) <= LARGEST && Math.abs(toY - y) <= LARGEST;
    const way = guided ? [toX - x, toY - y, ...spread] : [NaN, NaN, NaN, NaN, NaN];
    const [accepted, right, down, addedX, addedY] = step(this.#memory, [t, dx, dy, ...way]);
    if (accepted !== accepted) return null;
    const { width_px: width, height_px: height } = this.hello.screen;
    const place = [within(x + right, width), within(y + down, height)];
    this.#cursor = { ...this.#cursor, place, added: this.#cursor.added + Math.hypot(addedX, addedY) };
    return place;
  }

  /** The newest prediction guides the next report. @param {number[]} answer */
  guide([, x, y, sxx, sxy, syy, , , tail]) {
    this.#cursor = { ...this.#cursor, guidance: x === x ? [x, y, ...asNormal(sxx, sxy, syy, tail)] : null };
  }
}

/** The memory of the transfer function that a client asks for, without states; throws a ProtocolError. */
function memoryOf({ device, screen }, { strength, rho, function: kind, gain }) {
  if (device?.cpi == null)
    throw new ProtocolError("bad_field", "assistance needs the counts per inch of the device", "$.device.cpi", {
      field: "cpi",
      value: null,
    });
  const slots = new Float64Array(SLOTS),
    memory = new Float64Array(END);
  slots.set(kind === "constant" ? [CONSTANT, gain] : [SIGMOID, ...MACOS]);
  layOut(memory, [rho, strength, ...USUAL_GUARD], [device.cpi, screen.dpi, ...USUAL_TIMES_S], slots);
  return memory;
}

/** A coordinate on a screen of a size; without one, within what a pipeline takes. */
const within = (place, size) =>
  size == null ? Math.min(Math.max(place, -LARGEST), LARGEST) : Math.min(Math.max(place, 0), Math.max(size - 1, 0));
