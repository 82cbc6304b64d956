"""From what came over the wire to a message or a table of events; what is wrong with it, and where."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from math import isfinite
from typing import Any

import msgspec
import numpy as np

from pointpred.columns import EventColumns, FloatArray
from pointpred.server.messages import KNOWN, ClientMessage, Code, ErrorMessage, EventRow, Setting
from pointpred.server.records import EVENT as EVENT
from pointpred.server.records import NO_COUNTS as NO_COUNTS
from pointpred.server.records import NONE, unpack
from pointpred.server.records import PREDICTION as PREDICTION

LARGEST = 1e9
WORDS_MOST = 1000
"""What an error quotes of a client's frame is no longer than this."""

_decoder = msgspec.json.Decoder(ClientMessage)
_place = re.compile(r" - at `(?P<path>\$.*)`$", re.DOTALL)
_fields = ("t", "x", "y")


class RefusedError(Exception):
    """What came cannot be used; ``answer`` says so, ``close`` is the close code where the session ends."""

    def __init__(
        self, code: Code, message: str, path: str | None = None, *, close: int | None = None
    ) -> None:
        super().__init__(message)
        self.answer = ErrorMessage(code, short(message), path and short(path), recoverable=close is None)
        self.close = close


def short(words: str) -> str:
    """Words that a client may have chosen, of bounded length."""
    return words if len(words) <= WORDS_MOST else f"{words[:WORDS_MOST]}..."


def decode_text(text: str) -> ClientMessage:
    """A message from JSON text; raises RefusedError with the path of what is wrong."""
    try:
        message: ClientMessage = _decoder.decode(text)
        return message
    except msgspec.ValidationError as error:
        raise _not_fitting(text, str(error)) from None
    except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
        raise _not_json(text, str(error)) from None


def _not_fitting(text: str, words: str) -> RefusedError:
    """JSON, but no message: the decoder says where, only not which parameter."""
    found = _place.search(words)
    path = found["path"] if found else "$"
    words = _place.sub("", words)
    if path == "$.type" or (path == "$" and words.endswith("required field `type`")):
        return RefusedError("unknown_type", f"{words}; known: {', '.join(KNOWN)}", path)
    if path.startswith("$.parameters["):
        path = _wrong_parameter(text)
    return RefusedError("bad_field", words, path)


def _wrong_parameter(text: str) -> str:
    """The path of the first parameter whose value is of no type a parameter has."""
    for name, value in _parameters(text).items():
        try:
            msgspec.convert(value, Setting)
        except msgspec.ValidationError:
            return f"$.parameters.{name}"
    return "$.parameters"


def _parameters(text: str) -> dict[str, Any]:
    found: dict[str, Any] = msgspec.json.decode(text)["parameters"]
    return found


def _not_json(text: str, reason: str) -> RefusedError:
    """Many encoders write NaN, which JSON does not know: then the place of the number helps more."""
    try:
        path = _not_finite(json.loads(text), "$")
    except (ValueError, RecursionError):
        path = None
    if path is None:
        return RefusedError("bad_json", f"expected JSON: {reason}")
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


def row_of(row: EventRow) -> tuple[float, float, float, float, float, float]:
    """One event of an ``events`` message as a row of the table."""
    t, x, y, dx, dy, buttons = row
    return t, x, y, NONE if dx is None else dx, NONE if dy is None else dy, float(buttons)


def events_of_rows(rows: Sequence[EventRow]) -> EventColumns:
    """A table from the rows of an ``events`` message."""
    return EventColumns(np.array(rows, dtype=np.float64).reshape(-1, 6))  # null becomes NaN


def events_of_bytes(frame: bytes) -> EventColumns:
    """A table from a frame of packed events; raises RefusedError."""
    if len(frame) % EVENT.itemsize:
        words = f"a binary frame holds records of {EVENT.itemsize} bytes, received {len(frame)} bytes"
        raise RefusedError("bad_field", words, "$")
    return EventColumns(unpack(frame))


def check_numbers(table: FloatArray) -> None:
    """Refuse, naming the first, what a pipeline would: numbers out of range, one count without the other."""
    outside = ~(np.abs(table[:, :3]) <= LARGEST)
    alone = np.isnan(table[:, 3:5])
    alone &= ~alone.all(axis=1, keepdims=True)
    wrong = np.argwhere(np.hstack([outside, alone]))
    if not len(wrong):
        return
    row, field = (int(i) for i in wrong[0])
    words = "dx and dy are both numbers or both null"
    if field < outside.shape[1]:
        value = float(table[row, field])
        words = f"{_fields[field]} must lie in [{-LARGEST:g}, {LARGEST:g}], received {value!r}"
    raise RefusedError("bad_field", words, f"$.events[{row}][{field}]")
