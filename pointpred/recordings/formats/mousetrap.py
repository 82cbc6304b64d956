"""OpenSesame mousetrap: CSV with one trial per row and lists of times and positions in its cells."""

from __future__ import annotations

from pathlib import Path

from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.encodings import head_of, stem_of
from pointpred.recordings.formats.trial_rows import people_of, row_conditions
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.trials import Lists, split

TITLE = "OpenSesame mousetrap CSV"
TIMES, XS, YS = "timestamps_", "xpos_", "ypos_"
USERS = ("subject_nr", "subject", "participant")
SEPARATORS = (",", ";", "\t")


def recognises(head: bytes) -> bool:
    """Whether a file that begins with ``head`` is a mousetrap table."""
    first = head.split(b"\n", 1)[0]
    return all(word in first for word in (TIMES.encode(), XS.encode(), YS.encode()))


def read(path: Path, reading: Reading = AS_IS) -> Recording:
    """Read a table; a trial is ``<row>``, or ``<row> <item>`` if a row holds several tracks.

    Assumes ms and px from the centre of the screen, y down. Positions stay relative to that centre, as the
    provenance records. Cells are separated by commas, semicolons or tabs. Rows without a track are counted in
    a note; without a column of users, a file has one user. The other short cells of a row are conditions.
    Raises RecordingError.
    """
    first = head_of(path).split(b"\n", 1)[0].decode("utf-8", "replace")
    table, _ = arrow_tables.read_table(path, lambda column: True, max(SEPARATORS, key=first.count))
    names = table.column_names
    items = [name.removeprefix(TIMES) for name in names if name.startswith(TIMES)]
    required = [prefix + item for item in items or ["<item>"] for prefix in (TIMES, XS, YS)]
    arrow_tables.need_columns(path, names, required, names)
    rows = table.to_pylist()
    users, column, notes = people_of(path, rows, USERS)
    aside: set[str | None] = {*required, "item"}
    conditions, column_notes = row_conditions(rows, aside | {column})
    lists = Lists(reading.sort)
    empty = 0
    for row, (cells, user, condition) in enumerate(zip(rows, users, conditions, strict=True)):
        for item in items:
            series = [cells[prefix + item] for prefix in (TIMES, XS, YS)]
            trial = str(row) if len(items) == 1 else f"{row} {item}"
            if not any(series):
                empty += 1
            elif not all(series):
                lists.skip(Skip(trial, f"{item}: times or positions are missing", row))
            else:
                t, x, y = map(split, series)
                about = Trial(user, trial, condition=condition | {"item": item})
                lists.add(about, row, t, x, y, scale=0.001)
    if empty:
        lists.notes.append(f"{empty} cells hold no track")
    lists.notes += [*notes, *column_notes]
    provenance = Provenance(
        "mousetrap", origin="centre of the screen", clock="the experiment's clock, ms", dpi=reading.dpi
    )
    return lists.recording(stem_of(path), provenance)
