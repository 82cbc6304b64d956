"""Balabit and SapiMouse logs: CSV streams of a user's desktop work, cut into trials from click to click."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recording import Provenance
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, Known
from pointpred.recordings.reading import AS_IS, Reading, user_of
from pointpred.records import FloatArray

TITLE = "Balabit or SapiMouse CSV"
SAPIMOUSE = ("client timestamp", "button", "state", "x", "y")
BALABIT = ("record timestamp", *SAPIMOUSE)
BUTTONS = {"Left": 1, "Right": 2, "Middle": 4}
MOVES = ("Move", "Drag")
CLICKS = ("Pressed", "Released")
NO_POSITION = 65535.0


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a Balabit or a SapiMouse log."""
    first = head.split(b"\n", 1)[0].decode("utf-8", "replace").lstrip("\ufeff").strip()
    return first in (",".join(BALABIT), ",".join(SAPIMOUSE))


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read one session; the user is the folder's name if that ends in a digit (``user7``).

    Assumes the client's clock: s with Balabit, ms with SapiMouse. Wheel rows have no motion: they are ignored
    and counted in a note. A position of 65535 means none: the trial is skipped. Buttons follow Pressed and
    Released (Drag counts as pressed). Raises RecordingError.
    """
    table, _ = arrow_tables.read_table(path, lambda column: column in ("button", "state"))
    names = table.column_names
    arrow_tables.need_columns(path, names, SAPIMOUSE, BALABIT)
    button, state = (_words(table[name]) for name in ("button", "state"))
    wheel = np.isin(button, ["Scroll"]) & np.isin(state, ["Up", "Down"])
    unknown = np.flatnonzero(~wheel & ~np.isin(state, MOVES + CLICKS))
    if len(unknown):
        row = int(unknown[0])
        raise RecordingError(
            f"{path}: row {row}: state {state[row]!r} of {button[row]!r}, "
            f"expected one of {', '.join(MOVES + CLICKS)}"
        )
    rows = np.flatnonzero(~wheel)
    kept = table.take(pa.array(rows))
    faults = {
        row: f"{name} is 65535, the logger had no position"
        for name in ("y", "x")
        for row in np.flatnonzero(arrow_tables.numbers(kept[name])[0] == NO_POSITION).tolist()
    }
    seconds = "record timestamp" in names
    columns = {name: kept[name] for name in ("client timestamp", "x", "y")}
    known = Known(
        fields={"t": "client timestamp", "x": "x", "y": "y", "buttons": "buttons"},
        time_unit="s" if seconds else "ms",
        provenance=Provenance(
            "balabit" if seconds else "sapimouse", clock=f"the client's clock, {'s' if seconds else 'ms'}"
        ),
        one_user=user_of(path),
        cut="clicks",
        faults=faults,
    )
    notes = (f"wheel rows left aside: {len(state) - len(rows)}",) if len(rows) < len(state) else ()
    buttons = {"buttons": _held(button[rows], state[rows])}
    return ColumnTable(columns | buttons, TITLE, notes, row_of=rows, known=known)


def _words(column: Any) -> Any:
    """A text column as a numpy array; empty cells are empty strings."""
    filled = pc.fill_null(pc.cast(column, pa.string()), "")
    return np.array(pc.utf8_trim_whitespace(filled).to_pylist(), dtype=np.str_)


def _held(button: Any, state: Any) -> FloatArray:
    """The buttons pressed after each row, as in W3C pointer events."""
    rows = np.arange(len(state))
    buttons = np.zeros(len(state))
    for name, bit in BUTTONS.items():
        mine = button == name
        pressed = mine & ((state == "Pressed") | (state == "Drag"))
        last = np.maximum.accumulate(np.where(pressed | (mine & (state == "Released")), rows, -1))
        buttons += bit * np.where(last >= 0, pressed[last], False)
    return buttons
