"""Packed records of binary frames: an event takes 30 bytes, a prediction 65, little-endian, no padding."""

from __future__ import annotations

from collections.abc import Sequence
from struct import Struct

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.records import FloatArray, PredictionColumns

EVENT = np.dtype([("t", "<f8"), ("x", "<f8"), ("y", "<f8"), ("dx", "<i2"), ("dy", "<i2"), ("buttons", "<u2")])
"""A packed event; ``NO_COUNTS`` in dx or dy means no counts."""
PREDICTION = np.dtype([("numbers", "<f8", (7,)), ("phase", "u1"), ("tail", "<f8")])
"""A packed prediction: t, x, y, sxx, sxy, syy, remaining_s, NaN where null; the phase's code; tail, NaN where
the region's law is normal or there is no region."""
NO_COUNTS = -32768

NONE = float("nan")
RecordArray = NDArray[np.void]
EventFloats = tuple[float, float, float, float, float, float]
"""A row of the table of ``EventColumns``."""
_one_event = Struct("<dddhhH")
_one_prediction = Struct("<dddddddBd")


@law
def unpack_records(records: RecordArray, table: FloatArray) -> None:
    """The fields of each record into a row of the table."""
    for i in range(len(table)):
        record = records[i]
        table[i, 0] = record["t"]
        table[i, 1] = record["x"]
        table[i, 2] = record["y"]
        table[i, 3] = record["dx"]
        table[i, 4] = record["dy"]
        table[i, 5] = record["buttons"]
        if table[i, 3] == NO_COUNTS or table[i, 4] == NO_COUNTS:
            table[i, 3] = table[i, 4] = np.nan


def unpack_events(frame: bytes) -> FloatArray:
    """The events of a frame as the table of ``EventColumns``; the frame holds whole records."""
    records = np.frombuffer(frame, EVENT)
    table = np.empty((len(records), 6))
    unpack_records(records, table)
    return table


def unpack_event(frame: bytes) -> EventFloats:
    """The only event of a frame, as a row of the same table."""
    t, x, y, dx, dy, buttons = _one_event.unpack(frame)
    if dx == NO_COUNTS or dy == NO_COUNTS:
        return t, x, y, NONE, NONE, float(buttons)
    return t, x, y, float(dx), float(dy), float(buttons)


def pack_events(table: FloatArray) -> bytes:
    """Rows of ``EventColumns`` as records."""
    packed = np.empty(len(table), EVENT)
    none = np.isnan(table[:, 3:5]).any(axis=1)
    for column, name in enumerate(("t", "x", "y")):
        packed[name] = table[:, column]
    for column, name in enumerate(("dx", "dy"), start=3):
        packed[name] = np.where(none, NO_COUNTS, table[:, column])
    packed["buttons"] = table[:, 5]
    return packed.tobytes()


def pack_predictions(table: FloatArray) -> bytes:
    """The rows of ``PredictionColumns`` as records."""
    packed = np.empty(len(table), PREDICTION)
    none = np.isnan(table[:, 1])
    packed["numbers"] = table[:, :7]
    packed["phase"] = np.where(none, 0.0, table[:, 7])
    packed["numbers"][none, 1:] = NONE
    packed["tail"] = np.where(none | np.isnan(table[:, 3]), NONE, table[:, 8])
    return packed.tobytes()


def pack_prediction(row: Sequence[float]) -> bytes:
    """One row of ``PredictionColumns`` as a record."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, _ = row
    if x != x:
        return _one_prediction.pack(t, NONE, NONE, NONE, NONE, NONE, NONE, 0, NONE)
    return _one_prediction.pack(t, x, y, sxx, sxy, syy, remaining_s, int(phase), tail if sxx == sxx else NONE)


def unpack_predictions(frame: bytes) -> list[list[float]]:
    """The records of a frame as rows of ``PredictionColumns``."""
    packed = np.frombuffer(frame, PREDICTION)
    table = np.full((len(packed), len(PredictionColumns.names)), NONE)
    table[:, :7] = packed["numbers"]
    table[:, 7] = np.where(np.isnan(table[:, 1]), NONE, packed["phase"])
    table[:, 8] = packed["tail"]
    rows: list[list[float]] = table.tolist()
    return rows
