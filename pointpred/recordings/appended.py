"""Recordings written row by row, as by the service's recorder.

Their header says ``"append": true``: rows were appended one by one and the process may have been killed at
any time, so the last line may be incomplete. It is ignored, with a note.
"""

from __future__ import annotations

import csv
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import EVENT_COLUMNS, Header, IntArray, parse_header, says_appended
from pointpred.recordings.encodings import read_unpacked, stem_of
from pointpred.recordings.reading import AS_IS, Cut, Reading, row_name
from pointpred.recordings.samples import Samples, recording_of
from pointpred.recordings.trials import TARGET, assemble, condition_cells

FORMAT = "pointpred recorder"
LIVE = "pointpred live"
"""The header's name of the recorder of a device session."""
TITLE = "pointpred recorder CSV"
SAMPLES = ("user", "trial", *EVENT_COLUMNS)
TRIALS = ("user", "trial", *TARGET, "n_samples")
MOST_HEADER = 1 << 16
OUTSIDE = "outside the marked trials"
UNFINISHED = "the trial never ended"


def recognises(head: bytes) -> bool:
    """Whether the header of a file that begins with ``head`` marks it as appended to."""
    first = head.split(b"\n", 1)[0]
    return first.startswith(arrow_tables.MARK) and says_appended(first[len(arrow_tables.MARK) :])


def read(path: Path, trials: Path | None, reading: Reading = AS_IS) -> Recording:
    """Read an appended recording, with its table of trials if there is one.

    Rows of a marked trial name it. If no row does, the stream is cut according to ``reading``, by default at
    clicks, or at pauses for a live device without clicks. The marks of a live device are those of its
    contacts: each is cut at pauses by default. A trial without a row in ``trials`` had not ended;
    one that lost events has fewer samples than stated: both are skipped.
    Memory: the file, and about 150 bytes a row.
    Returns the recording; raises RecordingError.
    """
    table, header, notes = _table(path, SAMPLES)
    name = header.name or stem_of(path).removesuffix("_samples")
    provenance = header.provenance or Provenance(FORMAT)
    events = np.column_stack([arrow_tables.numbers(table[column])[0] for column in EVENT_COLUMNS])
    marks = table["trial"].combine_chunks()
    users = table["user"].drop_null()
    user = str(users[0].as_py()) if len(users) else name
    marked = marks.null_count < len(marks)
    if not marked or (provenance.format == LIVE and trials is None):
        how: Cut = reading.cut or "clicks"
        breaks = np.flatnonzero(np.diff(marks.dictionary_encode().indices.fill_null(-1))) + 1
        if reading.cut is None and marked:
            how = "bursts"
            notes.append(f"cut at pauses, and where a pen or finger was lifted: contacts {1 + len(breaks)}")
        elif reading.cut is None and provenance.format == LIVE and not (events[:, -1] > 0).any():
            how = "bursts"
            notes.append("no button was pressed: cut at pauses")
        samples = Samples(
            name=name,
            table=events,
            row_of=np.arange(len(events), dtype=np.int64),
            provenance=provenance,
            one_user=user,
            cut=how,
            parts=np.searchsorted(breaks, np.arange(len(events)), side="right"),
            notes=notes,
        )
        return recording_of(samples, reading)
    encoded = marks.dictionary_encode()
    group = arrow_tables.as_array(pc.fill_null(encoded.indices, -1)).astype(np.int64)
    names = encoded.dictionary.to_pylist()
    trials_there, unusable, empty, more = _read_trials(trials, user, names)
    sizes = np.bincount(group[group >= 0], minlength=len(names)).tolist()
    for index, size in enumerate(sizes):
        expected = unusable.pop(index, size)
        if expected is None:
            unusable[index] = UNFINISHED
        elif expected != size:
            unusable[index] = f"{size} samples, expected {expected:g} as the trials file says"
    rows = np.flatnonzero(group >= 0)
    return assemble(
        name,
        events[rows],
        group[rows],
        trials_there,
        skipped=(*_outside(group), *empty),
        unusable={index: str(reason) for index, reason in unusable.items()},
        provenance=provenance,
        notes=(*notes, *more),
        row_of=rows,
        sort=reading.sort,
    )


def _table(path: Path, columns: tuple[str, ...], *, more: bool = False) -> tuple[Any, Header, list[str]]:
    """The complete lines of a file as a table, its header, and a note about a last line that is cut short.

    ``more``: columns of text may come behind these.
    """
    data = read_unpacked(path)
    end = data.rstrip(b"\0").rfind(b"\n") + 1
    first, _, rest = data[:end].partition(b"\n")
    if not first.startswith(arrow_tables.MARK):
        raise RecordingError(f"{path}: not even the first line is complete, expected a header and rows")
    header = parse_header(path, first[len(arrow_tables.MARK) :])
    there = next(csv.reader([rest.partition(b"\n")[0].decode(errors="replace")]), [])
    if tuple(there[: len(columns) if more else None]) != columns:
        raise RecordingError(f"{path}: expected the columns {', '.join(columns)} below the header")
    words = {name: pa.string() for name in ("user", "trial", *there[len(columns) :])}
    types = {name: pa.float64() for name in columns} | words
    table = arrow_tables.parse_csv(path, BytesIO(rest), types)
    for name in columns if pa.types.is_string(table[columns[-1]].type) else ():
        wrong = {} if name in words else arrow_tables.numbers(table[name])[1]
        for row, cell in wrong.items():
            raise RecordingError(f"{path}: {row_name(row)}: {name} is {cell!r}, expected a number")
    cut = len(data) - end
    notes = [f"{path.name}: the last line is cut after {cut} bytes and left aside"] if cut else []
    return table, header, notes


def _read_trials(
    path: Path | None, user: str, names: list[str]
) -> tuple[list[Trial], dict[int, Any], list[Skip], list[str]]:
    """The trials, the number of samples of each (None: it never ended), those without samples, notes."""
    if path is None:
        return [Trial(user, name) for name in names], {}, [], ["no trials file: every target is unknown"]
    table, header, notes = _table(path, TRIALS, more=True)
    targets = np.column_stack([arrow_tables.numbers(table[column])[0] for column in TARGET]).tolist()
    counts = arrow_tables.numbers(table["n_samples"])[0].tolist()
    if table["trial"].null_count:
        raise RecordingError(f"{path}: row {pc.index(pc.is_null(table['trial']), True)} names no trial")
    named = table.column_names[len(TRIALS) :]
    columns = [condition_cells(table[name], text=name in header.text) for name in named]
    conditions = [
        {name: cell for name, cell in zip(named, cells, strict=True) if cell is not None}
        for cells in (zip(*columns, strict=True) if columns else [()] * len(counts))
    ]
    rows = zip(targets, counts, conditions, strict=True)
    by_name = dict(zip(table["trial"].to_pylist(), rows, strict=True))
    trials = []
    for name in names:
        place, _, condition = by_name.get(name, ((), None, {}))
        trials.append(Trial(user, name, **dict(zip(TARGET, place, strict=False)), condition=condition))
    sizes = {index: by_name[name][1] if name in by_name else None for index, name in enumerate(names)}
    empty = [Skip(name, "no samples", user=user) for name in by_name if name not in set(names)]
    return trials, sizes, empty, notes


def _outside(group: IntArray) -> list[Skip]:
    """The runs of rows outside trials."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], group < 0, [False]]).astype(np.int8)))
    return [
        Skip(f"rows {first} to {stop - 1}", OUTSIDE, first) for first, stop in edges.reshape(-1, 2).tolist()
    ]
