"""Recordings of rrweb: the pointer's positions, of which each has its own offset from the event's time."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pointpred.errors import RecordingError
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.encodings import holds
from pointpred.recordings.formats import json_records
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "rrweb JSON"
MARKS = (b'"timestamp"', b'"type"', b'"data"')
OFFSET = b'"timeOffset"'
FARTHEST = 1 << 26
"""Bytes that are searched for the first position: a snapshot of the page lies before it."""
INCREMENT = 3
MOVES = (1, 6, 12)
"""Sources of positions: the mouse, a finger, dragging."""
INTERACTION, DOWN, UP = 2, (1, 7), (0, 9, 10)
"""Pressing and releasing, by the mouse or a finger."""


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` holds the positions of rrweb."""
    return json_records.recognises(head) and OFFSET in head and all(mark in head for mark in MARKS)


def recognises_further(path: Path, head: bytes) -> bool:
    """Whether events of rrweb that begin with ``head`` have their first position beyond it."""
    marked = json_records.recognises(head) and all(mark in head for mark in MARKS)
    return marked and holds(path, OFFSET, FARTHEST)


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """The columns t_ms (since 1970), x, y and buttons, in the order of time: positions are saved in batches.

    Which button was pressed is not saved; it counts as the primary one. Raises RecordingError.
    """
    document, notes = json_records.document_in(path)
    rows: list[tuple[Any, Any, Any, bool | None]] = []
    unread = 0
    for event in _events(document):
        data, time = event["data"], event["timestamp"]
        source = data.get("source")
        if source in MOVES and isinstance(data.get("positions"), list):
            places = [place for place in data["positions"] if _is_place(place)]
            rows += [(time + place.get("timeOffset", 0), place["x"], place["y"], None) for place in places]
            unread += len(data["positions"]) - len(places)
        elif source == INTERACTION and data.get("type") in (*DOWN, *UP):
            rows += [(time, data["x"], data["y"], data["type"] in DOWN)] * _is_place(data)
            unread += not _is_place(data)
    notes += [f"positions that are no numbers left aside: {unread}"] if unread else []
    if not rows:
        raise RecordingError(f"{path}: no positions of the pointer in it")
    rows.sort(key=lambda row: row[0])
    held, buttons = 0, []
    for row in rows:
        held = held if row[3] is None else int(row[3])
        buttons.append(held)
    t, x, y, _ = map(list, zip(*rows, strict=True))
    columns = {"t_ms": t, "x": x, "y": y} | ({"buttons": buttons} if any(buttons) else {})
    return ColumnTable(columns, TITLE, tuple(notes))


def _events(value: Any, depth: int = 0) -> Iterator[dict[str, Any]]:
    """The incremental events in a list, or in an object around it."""
    if isinstance(value, dict) and isinstance(value.get("data"), dict) and _is_number(value.get("timestamp")):
        if value.get("type") == INCREMENT:
            yield value
    elif isinstance(value, (dict, list)) and depth < 4:
        for inner in value.values() if isinstance(value, dict) else value:
            yield from _events(inner, depth + 1)


def _is_place(place: Any) -> bool:
    """Whether a position has numbers."""
    numbers = (
        (place.get("x"), place.get("y"), place.get("timeOffset", 0)) if isinstance(place, dict) else (None,)
    )
    return all(map(_is_number, numbers))


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
