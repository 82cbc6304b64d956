"""From what came over the wire to a message or a table of events; what is wrong with it, and where."""

from __future__ import annotations

from collections.abc import Sequence

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.events import LARGEST, LATEST_S
from pointpred.server.protocol.client_messages import ClientMessage, EventRow
from pointpred.server.protocol.records import EVENT, NONE, unpack
from pointpred.server.protocol.refusals import RefusedError, not_fitting, not_json

_decoder = msgspec.json.Decoder(ClientMessage)
_fields = ("t", "x", "y")
_most = (LATEST_S, LARGEST, LARGEST)


def decode_text(text: str) -> ClientMessage:
    """A message from JSON text; raises RefusedError with the path of what is wrong."""
    try:
        message: ClientMessage = _decoder.decode(text)
        return message
    except msgspec.ValidationError as error:
        raise not_fitting(text, str(error)) from None
    except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
        raise not_json(text, str(error)) from None


def row_of(row: EventRow) -> tuple[float, float, float, float, float, float]:
    """One event of an ``events`` message as a row of the table."""
    t, x, y, dx, dy, buttons = row
    return t, x, y, NONE if dx is None else dx, NONE if dy is None else dy, float(buttons)


def table_of_rows(rows: Sequence[EventRow]) -> FloatArray:
    """The table from the rows of an ``events`` message."""
    return np.array(rows, dtype=np.float64).reshape(-1, 6)  # null becomes NaN


def table_of_bytes(frame: bytes) -> FloatArray:
    """The table of a frame of packed events; raises RefusedError."""
    if len(frame) % EVENT.itemsize:
        words = f"a binary frame holds records of {EVENT.itemsize} bytes, received {len(frame)} bytes"
        raise RefusedError("bad_field", words, "$")
    return unpack(frame)


def check_numbers(table: FloatArray) -> None:
    """Refuse, naming the first, what a pipeline would: numbers out of range, one count without the other."""
    outside = ~(np.abs(table[:, :3]) <= _most)
    alone = np.isnan(table[:, 3:5])
    alone &= ~alone.all(axis=1, keepdims=True)
    wrong = np.argwhere(np.hstack([outside, alone]))
    if not len(wrong):
        return
    row, field = (int(i) for i in wrong[0])
    words = "dx and dy are both numbers or both null"
    if field < outside.shape[1]:
        value = float(table[row, field])
        most = _most[field]
        words = f"{_fields[field]} must lie in [{-most:g}, {most:g}], received {value!r}"
    raise RefusedError("bad_field", words, f"$.events[{row}][{field}]")
