"""OpenSesame mousetrap: CSV with one trial per row and lists of times and positions in its cells."""

from __future__ import annotations

from pathlib import Path

from pointpred.recording import Provenance
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, Known
from pointpred.recordings.columns.list_cells import split
from pointpred.recordings.columns.names import user_column
from pointpred.recordings.encodings import head_of
from pointpred.recordings.nested_records import RecordTable
from pointpred.recordings.reading import AS_IS, Reading

TITLE = "OpenSesame mousetrap CSV"
TIMES, XS, YS = "timestamps_", "xpos_", "ypos_"
USERS = ("subject_nr", "subject", "participant")
SEPARATORS = (",", ";", "\t")


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a mousetrap table."""
    first = head.split(b"\n", 1)[0]
    return all(word in first for word in (TIMES.encode(), XS.encode(), YS.encode()))


def read(path: Path, reading: Reading = AS_IS) -> ColumnTable:
    """Read a table; a trial is ``<row>``, or ``<row> <item>`` if a row holds several tracks.

    Assumes ms and px from the centre of the screen, y down. Positions stay relative to that centre, as the
    provenance records. Cells are separated by commas, semicolons or tabs. Without a column of users, a file
    has one user. The other short cells of a row are conditions. Raises RecordingError.
    """
    first = head_of(path).split(b"\n", 1)[0].decode("utf-8", "replace")
    table, _ = arrow_tables.read_table(path, lambda column: True, max(SEPARATORS, key=first.count))
    names = table.column_names
    items = [name.removeprefix(TIMES) for name in names if name.startswith(TIMES)]
    required = [prefix + item for item in items or ["<item>"] for prefix in (TIMES, XS, YS)]
    arrow_tables.need_columns(path, names, required, names)
    tracks = RecordTable()
    rows = []
    for row, cells in enumerate(table.to_pylist()):
        about = {name: cell for name, cell in cells.items() if name not in required}
        for item in items:
            series = {prefix: split(cells[prefix + item]) for prefix in (TIMES, XS, YS)}
            name = str(row) if len(items) == 1 else f"{row} {item}"
            tracks.add(about | series | {"item": item, "trial of mousetrap": name})
            rows.append(row)
    fields = {"t": TIMES, "x": XS, "y": YS, "trial": "trial of mousetrap"} | user_column(names, USERS)
    columns = tracks.finish().columns or {name: [] for name in fields.values()}
    provenance = Provenance("mousetrap", origin="centre of the screen", clock="the experiment's clock, ms")
    known = Known(fields=fields, time_unit="ms", provenance=provenance)
    return ColumnTable(columns, TITLE, row_of=rows, known=known)
