"""Pointing Dynamics Dataset (Mueller, Oulasvirta, Murray-Smith 2017): one-dimensional pointing at 500 Hz."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from pointpred.recording import Provenance, Recording, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.encodings import stem_of
from pointpred.recordings.reading import AS_IS, Reading, user_of
from pointpred.recordings.trials import assemble
from pointpred.records import METRES_PER_INCH

TITLE = "Pointing Dynamics Dataset CSV"
NEEDED = ("time", "y", "target", "widthm")


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` belongs to the Pointing Dynamics Dataset."""
    names = head.split(b"\n", 1)[0].decode("utf-8", "replace").replace('"', "").replace("\r", "").split(",")
    return set(NEEDED) <= {name.strip() for name in names}


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read one file ``P<user>/Data0,-1,<distance px>,<width px>.csv``; a change of target begins a trial.

    Assumes m and s. The movement's one axis becomes x, y is 0; metres become px by ``reading.dpi``. The
    columns ``sgv`` and ``sga`` look ahead in time and are ignored, like all other columns.
    Raises RecordingError.
    """
    table, _ = arrow_tables.read_table(path, lambda column: False)
    names = table.column_names
    arrow_tables.need_columns(path, names, NEEDED, names)
    faults: dict[int, str] = {}
    columns = {}
    for name in NEEDED:
        columns[name], wrong = arrow_tables.finite_numbers(table[name])
        faults |= {row: f"{name} is {cell!r}, expected a number" for row, cell in wrong.items()}
    target, width = columns["target"], columns["widthm"]
    for name in ("target", "widthm"):
        odd = np.flatnonzero(~np.isfinite(columns[name]))
        faults |= {int(row): f"{name} is {columns[name][row]}, expected a finite number" for row in odd}
    changes = np.flatnonzero((np.diff(target) != 0) & ~(np.isnan(target[1:]) & np.isnan(target[:-1]))) + 1
    begins = np.concatenate([[0], changes]).astype(np.int64) if len(target) else np.empty(0, np.int64)
    sizes = np.diff(begins, append=len(target))
    px = reading.dpi / METRES_PER_INCH
    events = np.full((len(target), 6), np.nan)
    events[:, 0] = columns["time"] - np.repeat(columns["time"][begins], sizes)
    events[:, 1] = columns["y"] * px
    events[:, 2] = events[:, 5] = 0.0
    user = user_of(path)
    trials = [
        Trial(
            user,
            str(index),
            float(target[row]) * px,
            0.0,
            float(width[row]) * px,
            condition={"file": path.name, "begins_s": float(columns["time"][row])},
        )
        for index, row in enumerate(begins.tolist())
    ]
    unread = [name for name in names if name not in NEEDED]
    return assemble(
        stem_of(path),
        events,
        np.repeat(np.arange(len(begins), dtype=np.int64), sizes),
        trials,
        faults=faults,
        sort=reading.sort,
        provenance=Provenance(
            "pointing-dynamics", "m", "the axis' zero", "one axis", "the experiment's clock, s", reading.dpi
        ),
        notes=[f"columns left aside: {', '.join(unread)}"] if unread else [],
    )
