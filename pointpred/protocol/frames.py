"""Frames on the wire: events to the service, predictions back, as JSON text or as packed records.

A packed event takes 30 bytes, a prediction 65, little-endian, no padding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from struct import Struct

import numpy as np
from msgspec import UNSET, UnsetType

from pointpred.errors import EventError
from pointpred.protocol.client_messages import Encoding
from pointpred.protocol.server_messages import EndpointLaw, Likely, Limits, PredictionMessage, encode
from pointpred.records import (
    EVENT_FIELDS,
    PHASES,
    EventColumns,
    FloatArray,
    PredictionColumns,
    Row,
)

EVENT = np.dtype([(field.name, field.packed) for field in EVENT_FIELDS])
"""A packed event; ``NO_COUNTS`` in dx or dy means no counts."""
PREDICTION = np.dtype([("numbers", "<f8", (7,)), ("phase", "u1"), ("tail", "<f8")])
"""A packed prediction: t, x, y, sxx, sxy, syy, remaining_s, NaN where null; the phase's code; tail, NaN where
the region's law is normal or there is no region."""
NO_COUNTS = -32768

NONE = float("nan")
_one_event = Struct("<" + "".join(np.dtype(field.packed).char for field in EVENT_FIELDS))
_one_prediction = Struct("<dddddddBd")

Frame = str | bytes


def unpack_events(frame: bytes) -> list[Row]:
    """The events of a frame as rows of ``EventColumns``; the frame holds whole records."""
    return [
        (t, x, y, NONE, NONE, buttons) if dx == NO_COUNTS or dy == NO_COUNTS else (t, x, y, dx, dy, buttons)
        for t, x, y, dx, dy, buttons in _one_event.iter_unpack(frame)
    ]


def pack_events(table: FloatArray) -> bytes:
    """Rows of ``EventColumns`` as records."""
    packed = np.empty(len(table), EVENT)
    none = np.isnan(table[:, 3:5]).any(axis=1)
    for column, field in enumerate(EVENT_FIELDS):
        values = table[:, column]
        packed[field.name] = np.where(none, NO_COUNTS, values) if field.optional else values
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


def event_frames(
    events: EventColumns, encoding: Encoding, limits: Limits
) -> Iterator[tuple[Frame, EventColumns]]:
    """Events as frames within the limits, each with the events it holds; raises EventError."""
    if encoding == "json":
        yield from _event_texts(events, limits)
        return
    if not packable(events):
        raise EventError("binary records hold whole counts within 32767; use encoding 'json' for others")
    most = max(1, min(limits.max_events_per_frame, limits.max_frame_bytes // EVENT.itemsize))
    for first in range(0, len(events), most):
        part = events.rows(first, first + most)
        yield pack_events(part.table), part


def packable(events: EventColumns) -> bool:
    """Whether binary records can hold these events exactly: counts must be whole and within 32767."""
    counts = events.table[:, 3:5]
    there = counts[~np.isnan(counts).any(axis=1)]
    return bool(np.all((there == np.round(there)) & (np.abs(there) < -NO_COUNTS)))


def _event_texts(events: EventColumns, limits: Limits) -> Iterator[tuple[Frame, EventColumns]]:
    head, tail = '{"type":"events","events":[', "]}"
    part: list[str] = []
    first, size = 0, len(head) + len(tail)
    for place, row in enumerate(events.table.tolist()):
        values = [None if math.isnan(value) else value for value in row[:5]]
        text = encode([*values, int(row[5])]).decode()
        if part and (len(part) == limits.max_events_per_frame or size + len(text) >= limits.max_frame_bytes):
            yield head + ",".join(part) + tail, events.rows(first, place)
            first, part, size = place, [], len(head) + len(tail)
        part.append(text)
        size += len(text) + 1
    if part:
        yield head + ",".join(part) + tail, events.rows(first, len(events))


def prediction_frames(
    predictions: FloatArray, *, binary: bool, each: bool, likely: Sequence[list[Likely]] | None = None
) -> tuple[list[Frame], int]:
    """The frames that answer events with these rows of predictions, and how many predictions they hold.

    Binary: one frame of packed records. JSON: one text a prediction. ``each``: one prediction an event,
    otherwise the newest one only. ``likely``: the likeliest targets of each prediction, for which a packed
    record has no room.
    """
    rows = predictions if each else predictions[-1:]
    if likely is not None and not binary:
        return [prediction_text(row, some) for row, some in zip(rows.tolist(), likely, strict=True)], len(
            rows
        )
    if len(rows) == 1 or not binary:
        encode_row = row_encoder(binary=binary)
        return [encode_row(row) for row in rows.tolist()], len(rows)
    return [pack_predictions(rows)], len(rows)


def row_encoder(*, binary: bool) -> Callable[[Sequence[float]], Frame]:
    """The function that makes a frame of one row of predictions."""
    return pack_prediction if binary else prediction_text


def prediction_text(row: Sequence[float], likely: list[Likely] | UnsetType = UNSET) -> str:
    """One row of predictions as JSON text."""
    return encode(message_of(row, likely)).decode()


def message_of(row: Sequence[float], likely: list[Likely] | UnsetType = UNSET) -> PredictionMessage:
    """A row of ``PredictionColumns`` as a message, with the likeliest targets where there are any."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, _ = row
    if x != x:
        return PredictionMessage(t, targets=likely)
    return PredictionMessage(
        t,
        x,
        y,
        EndpointLaw(sxx, sxy, syy, tail if tail == tail else None) if sxx == sxx else None,
        PHASES[int(phase)],
        remaining_s if remaining_s == remaining_s else None,
        likely,
    )


def row_of_prediction(message: PredictionMessage) -> list[float]:
    """A message as a row of ``PredictionColumns``; the spread of the time left is not sent."""
    scale = message.scale
    claimed = (NONE, NONE, NONE) if scale is None else (scale.sxx, scale.sxy, scale.syy)
    phase = NONE if message.phase is None else float(PHASES.index(message.phase))
    numbers = (message.x, message.y, *claimed, message.remaining_s, phase, scale.tail if scale else None)
    return [message.t, *(NONE if value is None else value for value in numbers), NONE]
