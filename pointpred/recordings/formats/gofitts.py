"""GoFitts ``.sd3`` traces: three lines a trial, ``t=`` in ms, ``x=`` and ``y=`` in px."""

from __future__ import annotations

from pathlib import Path

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Skip
from pointpred.recordings.arrow_tables import ColumnTable, Known
from pointpred.recordings.encodings import read_text
from pointpred.recordings.nested_records import RecordTable
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "GoFitts .sd3"
FIRST = "TRACE DATA"
PREFIX = (
    "App,Participant,Condition,Session,Group,TaskType,SelectionMethod,Block,Sequence,A,W,Trial,from_x,from_y,"
    "to_x,to_y"
)
NAMES = PREFIX.split(",")
FIELDS = {"t": "t=", "x": "x=", "y": "y=", "user": "Participant", "trial": "trial of GoFitts"}
TARGETS = {"target_x": "to_x", "target_y": "to_y", "target_w": "W"}


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a GoFitts trace."""
    return head.lstrip(b"\xef\xbb\xbf").startswith(FIRST.encode())


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read a trace; target centre and width are known, A, from and the other columns become conditions.

    A trial whose three lines do not match is skipped; ``row`` is the line of its ``t=``, counted from the
    first below the header. Raises RecordingError.
    """
    lines = read_text(path).splitlines()
    if len(lines) < 2 or lines[0].strip() != FIRST or not lines[1].startswith(PREFIX):
        raise RecordingError(f"{path}: line 2 is not the header of a trace, expected {PREFIX},{{t_x_y}}")
    rows = [(row, line.split(",")) for row, line in enumerate(lines[2:]) if line.strip()]
    traces, places, skipped = RecordTable(), [], []
    at = 0
    while at < len(rows):
        row, cells = rows[at]
        key = cells[: len(NAMES)]
        three = [other for _, other in rows[at : at + 3]]
        letters = [other[len(NAMES)] if len(other) > len(NAMES) else "" for other in three]
        if letters != ["t=", "x=", "y="] or any(other[: len(NAMES)] != key for other in three):
            named = " ".join(key[7:12:4]) if len(key) > 11 else f"row {row}"
            skipped.append(Skip(named, "its lines t=, x= and y= do not follow each other", row))
            at += 1
            while at < len(rows) and rows[at][1][: len(NAMES)] == key:
                at += 1
            continue
        at += 3
        about = dict(zip(NAMES, key, strict=True))
        name = " ".join(about[word] for word in ("Session", "Block", "Sequence", "Trial"))
        series = {
            letter: [cell for cell in other[len(NAMES) + 1 :] if cell.strip()]
            for letter, other in zip(letters, three, strict=True)
        }
        traces.add(about | series | {FIELDS["trial"]: name})
        places.append(row)
    provenance = Provenance("gofitts", clock="milliseconds from the trial's start")
    known = Known(fields=FIELDS | TARGETS, time_unit="ms", provenance=provenance)
    columns = traces.finish().columns or {name: [] for name in (*FIELDS.values(), *TARGETS.values())}
    return ColumnTable(columns, TITLE, (), tuple(skipped), places, known=known)
