// The errors of prediction: as in Python, a program reads `code`, `field` and `value`, and the sentence is for people.

/** A value that cannot be used. `code`: a short word that stays the same between versions; `field`: what is wrong; `value`: as received. */
class ValueError extends RangeError {
  /** @param {string} message @param {{code: string, field?: string, value?: unknown}} details */
  constructor(message, { code, field = "", value = null }) {
    super(message);
    this.code = code;
    this.field = field;
    this.value = value;
  }
}

/** A parameter, target or person is unknown, of the wrong kind or out of bounds. Nothing has changed. */
export class ParameterError extends ValueError {
  name = "ParameterError";

  /** @param {string} message @param {{code?: string, field?: string, value?: unknown}} [details] */
  constructor(message, { code = "bad_parameter", ...details } = {}) {
    super(message, { code, ...details });
  }
}

/** An event cannot be used: a value is not finite or out of range, or its time is before the last. Nothing has changed. */
export class EventError extends ValueError {
  name = "EventError";

  /** @param {string} message @param {{code?: "bad_event"|"time_backwards", field?: string, value?: unknown}} [details] */
  constructor(message, { code = "bad_event", ...details } = {}) {
    super(message, { code, ...details });
  }
}
