"""From what came over the wire to a message or a table of events; what is wrong with it, and where."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from math import isfinite

import msgspec
import numpy as np

from pointpred.columns import EventColumns, FloatArray, PredictionColumns
from pointpred.server.messages import KNOWN, ClientMessage, Code, ErrorMessage

EVENT = np.dtype([("t", "<f8"), ("x", "<f8"), ("y", "<f8"), ("dx", "<i2"), ("dy", "<i2"), ("buttons", "<u2")])
"""A packed event: 30 bytes; -32768 in dx or dy means no counts."""
PREDICTION = np.dtype([("numbers", "<f8", (7,)), ("phase", "u1")])
"""A packed prediction: t, x, y, sxx, sxy, syy, remaining_s, then the phase: 57 bytes."""
NO_COUNTS = -32768
LARGEST = 1e9

_decoder = msgspec.json.Decoder(ClientMessage)
_place = re.compile(r" - at `(?P<path>.+)`$")
_fields = ("t", "x", "y")


class RefusedError(Exception):
    """What came cannot be used; ``answer`` says so, ``close`` is the close code where the session ends."""

    def __init__(
        self, code: Code, message: str, path: str | None = None, *, close: int | None = None
    ) -> None:
        super().__init__(message)
        self.answer = ErrorMessage(code, message, path, recoverable=close is None)
        self.close = close


def decode_text(text: str) -> ClientMessage:
    """A message from JSON text; raises RefusedError with the path of what is wrong."""
    try:
        message: ClientMessage = _decoder.decode(text)
        return message
    except msgspec.ValidationError as error:
        words = str(error)
        found = _place.search(words)
        path = found["path"] if found else "$"
        words = _place.sub("", words)
        if path == "$.type" or "`type`" in words:
            raise RefusedError("unknown_type", f"{words}; known: {', '.join(KNOWN)}", path) from None
        raise RefusedError("bad_field", words, path) from None
    except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
        raise _not_json(text, str(error)) from None


def _not_json(text: str, reason: str) -> RefusedError:
    """Many encoders write NaN, which JSON does not know: then the place of the number helps more."""
    try:
        path = _not_finite(json.loads(text), "$")
    except (ValueError, RecursionError):
        path = None
    if path is None:
        return RefusedError("bad_json", reason)
    return RefusedError("bad_field", "expected a finite number, received NaN or an infinity", path)


def _not_finite(value: object, path: str) -> str | None:
    """The path of the first number that is not finite."""
    if isinstance(value, float):
        return None if isfinite(value) else path
    inside: Iterable[tuple[str, object]] = ()
    if isinstance(value, dict):
        inside = ((f"{path}.{key}", item) for key, item in value.items())
    elif isinstance(value, list):
        inside = ((f"{path}[{place}]", item) for place, item in enumerate(value))
    return next((found for where, item in inside if (found := _not_finite(item, where))), None)


def events_of_rows(
    rows: Sequence[tuple[float, float, float, float | None, float | None, int]],
) -> EventColumns:
    """A table from the rows of an ``events`` message."""
    none = float("nan")
    table = [
        (t, x, y, none if dx is None else dx, none if dy is None else dy, buttons)
        for t, x, y, dx, dy, buttons in rows
    ]
    return EventColumns(np.array(table, dtype=np.float64).reshape(-1, 6))


def events_of_bytes(frame: bytes) -> EventColumns:
    """A table from a frame of packed events; raises RefusedError."""
    if len(frame) % EVENT.itemsize:
        raise RefusedError(
            "bad_field",
            f"a binary frame holds records of {EVENT.itemsize} bytes, received {len(frame)} bytes",
            "$",
        )
    packed = np.frombuffer(frame, EVENT)
    table = np.empty((len(packed), 6))
    for column, name in enumerate(EVENT.names or ()):
        table[:, column] = packed[name]
    none = (packed["dx"] == NO_COUNTS) | (packed["dy"] == NO_COUNTS)
    table[none, 3:5] = np.nan
    check_range(table)
    return EventColumns(table)


def check_range(table: FloatArray) -> None:
    """Refuse times and places that are not finite or beyond 1e9, naming the first."""
    wrong = ~(np.abs(table[:, :3]) <= LARGEST)
    if wrong.any():
        row, field = (int(i) for i in np.argwhere(wrong)[0])
        value = float(table[row, field])
        raise RefusedError(
            "bad_field",
            f"{_fields[field]} must lie in [{-LARGEST:g}, {LARGEST:g}], received {value!r}",
            f"$.events[{row}][{field}]",
        )


def pack(predictions: PredictionColumns) -> bytes:
    """Predictions as packed records."""
    table = predictions.table
    packed = np.empty(len(table), PREDICTION)
    packed["numbers"] = table[:, :7]
    # A row without a prediction is NaN but for t; its phase byte is 0.
    packed["phase"] = np.where(np.isnan(table[:, 1]), 0.0, table[:, 7]).astype(np.uint8)
    packed["numbers"][np.isnan(table[:, 1]), 1:] = np.nan
    return packed.tobytes()
