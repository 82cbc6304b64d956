"""Frames on the wire: events to the service, predictions back, as JSON text or as packed records.

Packed records hold the fields of ``records`` in their order, little-endian, no padding: an event takes 30
bytes, a prediction 65 in version 1 and 75 in version 2.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from struct import Struct
from typing import NamedTuple

import numpy as np

from pointpred.errors import EventError
from pointpred.protocol.client_messages import VERSION, VERSIONS, Encoding
from pointpred.protocol.server_messages import EndpointLaw, Likely, Limits, PredictionMessage, encode
from pointpred.records import (
    EVENT_FIELDS,
    PHASES,
    PREDICTION_FIELDS,
    EventColumns,
    Field,
    FloatArray,
    PredictionColumns,
    Row,
)
from pointpred.targets.rectangles import NOBODY

EVENT = np.dtype([(field.name, field.packed) for field in EVENT_FIELDS])
"""A packed event; ``NO_COUNTS`` in dx or dy means no counts."""
TARGET = Field("", NOBODY, packed="<i2", since=2, name="target")
PREDICTED = (*PREDICTION_FIELDS, TARGET)
"""What a packed prediction holds: the numbers of its row, NaN where null, and the place of ``target`` among
the registered targets, NOBODY where none of them is the likeliest."""


def _runs_of(fields: Sequence[Field]) -> list[tuple[str, slice]]:
    """Fields of one type that follow each other, which are copied together: the name of the first, where."""
    starts = [i for i in range(len(fields)) if i == 0 or fields[i].packed != fields[i - 1].packed]
    return [(fields[start].name, slice(start, stop)) for start, stop in pairwise([*starts, len(fields)])]


def _dtype_of(fields: Sequence[Field]) -> np.dtype[np.void]:
    """The packed record of these fields, by runs of one type."""
    runs = _runs_of(fields)
    return np.dtype([(name, fields[run.start].packed, (run.stop - run.start,)) for name, run in runs])


_sent = {version: [field for field in PREDICTED if field.since <= version] for version in VERSIONS}
_runs = {version: _runs_of(fields) for version, fields in _sent.items()}
PREDICTION = {version: _dtype_of(fields) for version, fields in _sent.items()}
"""A packed prediction by the version of the wire; each begins with the one before."""
NO_COUNTS = -32768

NONE = float("nan")
X, SXX, PHASE, TAIL = (PredictionColumns.names.index(name) for name in ("x", "sxx", "phase", "tail"))
# Each is faster than what it stands for: ``int``, ``PHASES`` by place, a method of bytes.
_code_of = {float(code): code for code in range(len(PHASES))}
_text = bytes.decode
_phase_of = dict(zip(_code_of, PHASES, strict=True))


def _struct_of(fields: Sequence[Field]) -> Struct:
    return Struct("<" + "".join(np.dtype(field.packed).char for field in fields))


_one_event = _struct_of(EVENT_FIELDS)
_pack_prediction = _struct_of(PREDICTED).pack

Frame = str | bytes


class Likeliest(NamedTuple):
    """What the registered targets make of a prediction.

    ``place`` of the one that is likeliest of all among them, NOBODY where none of them is; ``likely``: the
    likeliest targets, best first.
    """

    place: int
    likely: list[Likely]

    @property
    def target(self) -> str | None:
        """The id of the likeliest of all; ``None`` where it is none of the targets."""
        return None if self.place == NOBODY else self.likely[0].id


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


def pack_predictions(
    table: FloatArray, aims: Sequence[Likeliest] | None = None, *, version: int = VERSION
) -> bytes:
    """The rows of ``PredictionColumns`` as records; ``aims``: that of each, in a session with targets."""
    none, alone = np.isnan(table[:, X]), np.isnan(table[:, SXX]) & ~np.isnan(table[:, TAIL])
    if none.any() or alone.any():
        table = table.copy()
        table[none, X:] = NONE
        table[none, PHASE] = 0.0
        table[alone, TAIL] = NONE
    packed = np.empty(len(table), PREDICTION[version])
    for name, run in _runs[version]:
        if name == TARGET.name:
            packed[name][:, 0] = NOBODY if aims is None else [aim.place for aim in aims]
        else:
            packed[name] = table[:, run]
    return packed.tobytes()


def pack_prediction(row: Sequence[float], place: int = NOBODY) -> bytes:
    """One row of ``PredictionColumns`` as a record of the newest version; ``place``: that of its target."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, spread = row
    if x != x:
        return _pack_prediction(t, NONE, NONE, NONE, NONE, NONE, NONE, 0, NONE, NONE, place)
    if sxx != sxx:
        tail = NONE
    return _pack_prediction(t, x, y, sxx, sxy, syy, remaining_s, _code_of[phase], tail, spread, place)


def unpack_predictions(frame: bytes, version: int = VERSION) -> tuple[list[list[float]], list[int]]:
    """The records of a frame as rows of ``PredictionColumns``, and the place of each one's target."""
    packed = np.frombuffer(frame, PREDICTION[version])
    values = np.full((len(packed), len(PREDICTED)), NONE)
    values[:, -1] = NOBODY
    for name, run in _runs[version]:
        values[:, run] = packed[name]
    values[np.isnan(values[:, X]), PHASE] = NONE
    return values[:, :-1].tolist(), values[:, -1].astype(int).tolist()


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
    predictions: FloatArray,
    *,
    binary: bool,
    each: bool,
    version: int = VERSION,
    aims: Sequence[Likeliest] | None = None,
) -> tuple[list[Frame], int]:
    """The frames that answer events with these rows of predictions, and how many predictions they hold.

    Binary: one frame of packed records. JSON: one text a prediction. ``each``: one prediction an event,
    otherwise the newest one only. ``aims``: that of each prediction, in a session with targets.
    """
    rows = predictions if each else predictions[-1:]
    if binary and len(rows) > 1:
        return [pack_predictions(rows, aims, version=version)], len(rows)
    if aims is None:
        encode_row = row_encoder(binary=binary, version=version)
        return [encode_row(row) for row in rows.tolist()], len(rows)
    pairs, size = zip(rows.tolist(), aims, strict=True), PREDICTION[version].itemsize
    if binary:
        return [pack_prediction(row, aim.place)[:size] for row, aim in pairs], len(rows)
    return [aimed_text(row, aim) for row, aim in pairs], len(rows)


def row_encoder(*, binary: bool, version: int = VERSION) -> Callable[[Sequence[float]], Frame]:
    """The function that makes a frame of one row of predictions, in a session without targets."""
    if not binary:
        return prediction_text
    size = PREDICTION[version].itemsize
    return pack_prediction if version == VERSION else lambda row: pack_prediction(row)[:size]


def prediction_text(row: Sequence[float]) -> str:
    """One row of predictions as JSON text, in a session without targets."""
    return _text(encode(message_of(row)))


def aimed_text(row: Sequence[float], aim: Likeliest) -> str:
    """One row of predictions as JSON text, with its aim among the targets."""
    message = message_of(row)
    message.target, message.targets = aim.target, aim.likely
    return encode(message).decode()


def message_of(row: Sequence[float]) -> PredictionMessage:
    """A row of ``PredictionColumns`` as a message."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, spread = row
    if x != x:
        return PredictionMessage(t)
    return PredictionMessage(
        t,
        x,
        y,
        EndpointLaw(sxx, sxy, syy, tail if tail == tail else None) if sxx == sxx else None,
        _phase_of[phase],
        remaining_s if remaining_s == remaining_s else None,
        spread if spread == spread else None,
    )


def row_of_prediction(message: PredictionMessage) -> list[float]:
    """A message as a row of ``PredictionColumns``."""
    law = message.scale or EndpointLaw(NONE, NONE, NONE)
    phase = None if message.phase is None else PHASES.index(message.phase)
    left = message.remaining_s, phase, law.tail, message.remaining_spread
    numbers = (message.t, message.x, message.y, law.sxx, law.sxy, law.syy, *left)
    return [NONE if value is None else float(value) for value in numbers]
