"""What goes over the wire, from the client's side: events into frames, frames into rows of predictions."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from urllib.parse import urlsplit, urlunsplit

import numpy as np

from pointpred.columns import EventColumns, FloatArray, PredictionColumns
from pointpred.errors import EventError, ParameterError
from pointpred.events import PHASES, PointerEvent
from pointpred.server.protocol.client_messages import Encoding
from pointpred.server.protocol.records import EVENT, NO_COUNTS, PREDICTION
from pointpred.server.protocol.records import NONE as NAN
from pointpred.server.protocol.server_messages import Limits, PredictionMessage
from pointpred.server.protocol.server_messages import encode as encode

Frame = str | bytes
Row = Sequence[float | None]
"""t, x, y and then, where they are known, dx, dy, buttons."""


def address(url: str) -> str:
    """The stream's address: ``http`` becomes ``ws``, a bare address gets the usual path.

    >>> address("http://127.0.0.1:8765/")
    'ws://127.0.0.1:8765/v1/stream'
    """
    parts = urlsplit(url)
    scheme = {"http": "ws", "https": "wss"}.get(parts.scheme, parts.scheme)
    if scheme not in ("ws", "wss") or not parts.netloc:
        raise ParameterError(f"the address must be ws://HOST:PORT or http://HOST:PORT, received {url!r}")
    path = parts.path if parts.path not in ("", "/") else "/v1/stream"
    return urlunsplit((scheme, parts.netloc, path, parts.query, ""))


def authorization(token: str | None) -> dict[str, str]:
    """The header that shows a token."""
    return {} if token is None else {"Authorization": f"Bearer {token}"}


def columns_of(events: EventColumns | Iterable[PointerEvent | Row]) -> EventColumns:
    """Events as a table, from records or from rows; raises EventError."""
    if isinstance(events, EventColumns):
        return events
    table = [_numbers(event) for event in events]
    return EventColumns(np.array(table, dtype=np.float64).reshape(-1, 6))


def _numbers(event: PointerEvent | Row) -> list[float]:
    if isinstance(event, PointerEvent):
        row: Row = (event.t, event.x, event.y, event.dx, event.dy, event.buttons)
    elif 3 <= len(event) <= 6:
        row = (*event, *(None, None, 0)[len(event) - 3 :])
    else:
        raise EventError(f"an event is t, x, y[, dx, dy, buttons], received {len(event)} values")
    return [NAN if value is None else float(value) for value in row]


def packable(events: EventColumns) -> bool:
    """Whether binary records can hold these events exactly: counts must be whole and within 32767."""
    counts = events.table[:, 3:5]
    there = counts[~np.isnan(counts).any(axis=1)]
    return bool(np.all((there == np.round(there)) & (np.abs(there) < -NO_COUNTS)))


def frames(events: EventColumns, encoding: Encoding, limits: Limits) -> Iterator[tuple[Frame, EventColumns]]:
    """Events as frames within the limits, each with the events it holds; raises EventError."""
    if encoding == "binary":
        if not packable(events):
            raise EventError("binary records hold whole counts within 32767; use encoding 'json' for others")
        room = max(1, min(limits.max_events_per_frame, limits.max_frame_bytes // EVENT.itemsize))
        for first in range(0, len(events), room):
            part = events.rows(first, first + room)
            yield pack_events(part.table), part
        return
    yield from _texts(events, limits)


def pack_events(table: FloatArray) -> bytes:
    """Rows of events as packed records of 30 bytes."""
    packed = np.empty(len(table), EVENT)
    none = np.isnan(table[:, 3:5]).any(axis=1)
    for column, name in enumerate(("t", "x", "y")):
        packed[name] = table[:, column]
    for column, name in enumerate(("dx", "dy"), start=3):
        packed[name] = np.where(none, NO_COUNTS, table[:, column])
    packed["buttons"] = table[:, 5]
    return bytes(packed.tobytes())


def _texts(events: EventColumns, limits: Limits) -> Iterator[tuple[Frame, EventColumns]]:
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


def unpack_predictions(frame: bytes) -> list[list[float]]:
    """Rows as in PredictionColumns from packed records."""
    packed = np.frombuffer(frame, PREDICTION)
    table = np.full((len(packed), len(PredictionColumns.names)), NAN)
    table[:, :7] = packed["numbers"]
    table[:, 7] = np.where(np.isnan(table[:, 1]), NAN, packed["phase"])
    table[:, 8] = packed["tail"]
    rows: list[list[float]] = table.tolist()
    return rows


def row_of(message: PredictionMessage) -> list[float]:
    """A row as in PredictionColumns from a message."""
    scale = message.scale
    claimed = (NAN, NAN, NAN) if scale is None else (scale.sxx, scale.sxy, scale.syy)
    phase = NAN if message.phase is None else float(PHASES.index(message.phase))
    numbers = (message.x, message.y, *claimed, message.remaining_s, phase, scale.tail if scale else None)
    return [message.t, *(NAN if value is None else value for value in numbers), NAN]
