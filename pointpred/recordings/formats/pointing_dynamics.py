"""Pointing Dynamics Dataset (Mueller, Oulasvirta, Murray-Smith 2017): one-dimensional pointing at 500 Hz."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.recording import Provenance
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, Known, finite_numbers
from pointpred.recordings.reading import AS_IS, Reading, user_of
from pointpred.records import METRES_PER_INCH

TITLE = "Pointing Dynamics Dataset CSV"
NEEDED = ("time", "y", "target", "widthm")
ACROSS = {"t": "time", "x": "y", "y": "across", "trial": "trial", "target_x": "target", "target_w": "widthm"}


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` belongs to the Pointing Dynamics Dataset."""
    names = head.split(b"\n", 1)[0].decode("utf-8", "replace").replace('"', "").replace("\r", "").split(",")
    return set(NEEDED) <= {name.strip() for name in names}


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read one file ``P<user>/Data0,-1,<distance px>,<width px>.csv``; a change of target begins a trial.

    Assumes m and s. The movement's one axis becomes x, y is 0; metres become px by ``reading.dpi``. The
    columns ``sgv`` and ``sga`` look ahead in time and are ignored, like all other columns.
    Raises RecordingError.
    """
    table, _ = arrow_tables.read_table(path, lambda column: False)
    names = table.column_names
    arrow_tables.need_columns(path, names, NEEDED, names)
    times, target = (finite_numbers(table[name])[0] for name in ("time", "target"))
    changes = (np.diff(target) != 0) & ~(np.isnan(target[1:]) & np.isnan(target[:-1]))
    trial = np.cumsum(np.concatenate([[0], changes])) if len(target) else np.empty(0)
    begins = np.flatnonzero(np.diff(trial, prepend=-1))
    faults = {
        int(row): f"{name} is {table[name][row].as_py()!r}, expected a finite number"
        for name in ("widthm", "target")
        for row in np.flatnonzero(~np.isfinite(finite_numbers(table[name])[0]))
    }
    nothing = np.zeros(len(target))
    columns = {name: table[name] for name in NEEDED} | {
        "across": nothing,
        "target_y": nothing,
        "trial": trial.astype(np.int64),
        "file": np.full(len(target), path.name),
        "begins_s": np.repeat(times[begins], np.diff(begins, append=len(target))),
    }
    known = Known(
        fields=ACROSS | {"target_y": "target_y"},
        time_unit="s",
        provenance=Provenance(
            "pointing-dynamics", "m", "the axis' zero", "one axis", "the experiment's clock, s"
        ),
        gain=(reading.dpi / METRES_PER_INCH, 1.0),
        one_user=user_of(path),
        faults=faults,
    )
    unread = [name for name in names if name not in NEEDED]
    notes = (f"columns left aside: {', '.join(unread)}",) if unread else ()
    return ColumnTable(columns, TITLE, notes, known=known)
