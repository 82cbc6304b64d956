"""Cells of a table that hold a track as JSON, as ``[{"t": 0, "x": 1, "y": 2}, ...]``: columns of lists."""

from __future__ import annotations

import json
import re
from typing import Any

from pointpred.recordings.nested_records import records

TRACK = re.compile(r'\s*(\[\s*[\[{]|\{\s*"[^"]*"\s*:\s*\[)')
PROBE = 200
"""Rows among which the first nonempty cell decides the content of a column."""


def open_cells(columns: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """The columns, with tracks replaced by one column per field, as ``track.t``; notes on damaged cells."""
    opened: dict[str, Any] = {}
    notes: list[str] = []
    for name, column in columns.items():
        first = next((cell for cell in map(_text, column[:PROBE]) if cell), "")
        if not TRACK.match(first):
            opened[name] = column
            continue
        cells = [_text(cell) for cell in column]
        values = [_value(cell) for cell in cells]
        damaged = [row for row, cell in enumerate(cells) if cell and values[row] is None]
        if damaged:
            notes.append(
                f"cells of {name} that are no JSON: {len(damaged)}, the first in data row {damaged[0]}"
            )
        opened |= records([{} if value is None else {name: value} for value in values]).columns
    return opened, notes


def _text(cell: Any) -> str:
    """A cell, or an Arrow scalar, as text; empty if it is not text."""
    value = cell.as_py() if hasattr(cell, "as_py") else cell
    return value.strip() if isinstance(value, str) else ""


def _value(cell: str) -> Any:
    try:
        return json.loads(cell)
    except (ValueError, RecursionError):
        return None
