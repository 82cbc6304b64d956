"""Packed records of binary frames: an event takes 30 bytes, a prediction 57, little-endian, no padding."""

from __future__ import annotations

from collections.abc import Sequence
from struct import Struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointpred.columns import FloatArray

EVENT = np.dtype([("t", "<f8"), ("x", "<f8"), ("y", "<f8"), ("dx", "<i2"), ("dy", "<i2"), ("buttons", "<u2")])
"""A packed event; ``NO_COUNTS`` in dx or dy means no counts."""
PREDICTION = np.dtype([("numbers", "<f8", (7,)), ("phase", "u1")])
"""A packed prediction: t, x, y, sxx, sxy, syy, remaining_s, NaN where null; then the phase's code."""
NO_COUNTS = -32768

NONE = float("nan")
_one_event = Struct("<dddhhH")
_one_prediction = Struct("<dddddddB")


def _view(frame: bytes | bytearray, kind: str, first: int, width: int, record: int) -> NDArray[Any]:
    """Neighbouring fields of one kind in every record, where they lie."""
    item = np.dtype(kind).itemsize
    if not frame:
        return np.empty((0, width), kind)
    return np.ndarray((len(frame) // record, width), kind, frame, first, (record, item))


def unpack(frame: bytes) -> FloatArray:
    """The events of a frame as the table of ``EventColumns``; the frame holds whole records."""
    record = EVENT.itemsize
    counts = _view(frame, "<i2", 24, 2, record)
    table = np.empty((len(counts), 6))
    table[:, :3] = _view(frame, "<f8", 0, 3, record)
    table[:, 3:5] = counts
    table[:, 5:] = _view(frame, "<u2", 28, 1, record)
    none = counts == NO_COUNTS
    if none.any():
        table[none.any(axis=1), 3:5] = NONE
    return table


def unpack_one(frame: bytes) -> tuple[float, float, float, float, float, float]:
    """The only event of a frame, as a row of the same table."""
    t, x, y, dx, dy, buttons = _one_event.unpack(frame)
    if dx == NO_COUNTS or dy == NO_COUNTS:
        return t, x, y, NONE, NONE, float(buttons)
    return t, x, y, float(dx), float(dy), float(buttons)


def pack(table: FloatArray) -> bytes:
    """The rows of ``PredictionColumns`` as records."""
    record = PREDICTION.itemsize
    frame = bytearray(len(table) * record)
    numbers, phase = _view(frame, "<f8", 0, 7, record), _view(frame, "u1", 56, 1, record)
    numbers[:] = table[:, :7]
    phase[:] = table[:, 7:]
    none = np.isnan(table[:, 1])
    if none.any():
        numbers[none, 1:] = NONE
        phase[none] = 0
    return bytes(frame)


def pack_one(row: Sequence[float]) -> bytes:
    """One row of ``PredictionColumns`` as a record."""
    t, x, y, sxx, sxy, syy, remaining_s, phase = row
    if x != x:
        return _one_prediction.pack(t, NONE, NONE, NONE, NONE, NONE, NONE, 0)
    return _one_prediction.pack(t, x, y, sxx, sxy, syy, remaining_s, int(phase))
