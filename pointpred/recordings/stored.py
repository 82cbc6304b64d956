"""Recordings too long for memory: pointpred's own Parquet files, read some trials at a time."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.addresses import address_of, local_copy
from pointpred.recordings.arrow_tables import IntArray, parquet_file
from pointpred.recordings.own import EVENT_COLUMNS, KEY, REQUIRED, Header, described, events_of, parse_header
from pointpred.recordings.trials import assemble

ROWS_LEAST = 1 << 22
"""A file with fewer rows is read as a whole: some 200 MB."""
KEYS = ["user", "trial"]


class StoredPart(msgspec.Struct, frozen=True):
    """Successive trials of a stored recording: what is read at once."""

    samples: str
    trials: str
    name: str
    provenance: Provenance
    first_row: int
    stop_row: int
    first_trial: int
    stop_trial: int
    address: str = ""
    """Where the file was copied from: another machine copies it from there."""

    def read(self) -> Recording:
        """These trials as ``read`` of the whole file gives them; raises RecordingError."""
        path = Path(self.samples)
        if self.address and not path.exists():
            path = local_copy(self.address)
        beside = path.with_name(Path(self.trials).name)
        with parquet_file(path, read_dictionary=KEYS) as file:
            columns = [name for name in file.schema_arrow.names if name in (*KEYS, *EVENT_COLUMNS)]
            table = _rows(file, self.first_row, self.stop_row, columns)
        table.validate(full=True)
        starts, keys, _ = _runs(table)
        sizes = np.diff(starts, append=table.num_rows)
        header, every = _trials_file(str(beside), beside.stat().st_mtime_ns)
        rows = every.slice(self.first_trial, self.stop_trial - self.first_trial)
        about = described(beside, rows, header, self.name, keys, sizes)
        return assemble(
            self.name,
            events_of(table)[0],
            np.repeat(np.arange(len(keys)), sizes),
            about.trials,
            unusable=about.unusable,
            provenance=self.provenance,
            row_of=np.arange(self.first_row, self.stop_row),
        )


class StoredRecording(msgspec.Struct, frozen=True):
    """A recording whose trials stay in its file. Memory: 24 bytes a trial."""

    about: Recording
    """Without trials: name, provenance, what was skipped before the file was written, notes."""
    samples: str
    trials: str
    starts: IntArray
    """(trials + 1,): the row at which each trial begins, and the number of rows"""
    person: IntArray
    """(trials,): a number for each person, in the order of their first trials"""
    groups: IntArray
    """The row at which each row group of the file ends."""

    @property
    def name(self) -> str:
        """The recording's."""
        return self.about.name

    def parts(self, events: int, *, by_person: bool = False) -> list[StoredPart]:
        """All trials in order, in parts of about as many events, cut where row groups end where possible.

        ``by_person``: all trials of a person in one part; raises RecordingError where others' trials lie
        between them. A part is at most a row group and a trial (or person) longer than ``events``.
        """
        units = np.arange(len(self.person))
        if by_person:
            units = np.flatnonzero(np.diff(self.person, prepend=-1))
            if len(units) != len(np.unique(self.person)):
                message = (
                    f"{self.samples}: a predictor that learns its person needs each person's trials one "
                    "after the other in a file this long; sort it by user"
                )
                raise RecordingError(message, code="people_interleave")
        bounds, last = [0], 0
        for end in self.groups.tolist():
            if end - self.starts[last] < events // 2 and end < self.starts[-1]:
                continue
            while end - self.starts[last] > 2 * events:  # one long row group
                last = self._next_unit(units, int(self.starts[last]) + events)
                bounds.append(last)
            last = self._next_unit(units, end)
            bounds.append(last)
        bounds = sorted({*bounds, len(self.person)})
        return [
            StoredPart(
                self.samples,
                self.trials,
                self.about.name,
                self.about.provenance,
                int(self.starts[first]),
                int(self.starts[stop]),
                first,
                stop,
                address_of(Path(self.samples)) or "",
            )
            for first, stop in pairwise(bounds)
        ]

    def _next_unit(self, units: IntArray, row: int) -> int:
        """The first trial at or after a row at which a part may begin."""
        place = int(np.searchsorted(self.starts[units], row))
        return int(units[place]) if place < len(units) else len(self.person)


def stored(path: Path, beside: Path | None, rows_least: int = ROWS_LEAST) -> StoredRecording | None:
    """The recording in a long file that pointpred wrote, with its trials file; ``None`` for any other.

    Each trial's rows lie together, and both files have the trials in one order; otherwise, and where
    something is wrong with a file, it is to be read as a whole, which says so. Raises RecordingError where
    memory runs out.
    """
    if beside is None:
        return None
    try:
        with (
            parquet_file(path, read_dictionary=KEYS) as samples,
            parquet_file(beside, read_dictionary=KEYS) as trials,
        ):
            header, other = (_header(file, one) for file, one in ((path, samples), (beside, trials)))
            if header is None or other is None or not _fits(samples, header) or other.rows is None:
                return None
            if samples.metadata.num_rows < rows_least:
                return None
            found = _scan(samples)
            if found is None or not _same_order(trials, found[2]):
                return None
            starts, person, _ = found
            rows = [samples.metadata.row_group(i).num_rows for i in range(samples.num_row_groups)]
            empty = described(
                beside, trials.schema_arrow.empty_table(), other, header.name, [], np.zeros(0, int)
            )
    except MemoryError as error:
        raise arrow_tables.unreadable(path, error) from error
    except arrow_tables.UNREADABLE:
        return None
    about = Recording.of(
        header.name,
        [],
        [],
        [Skip(*skip) for skip in header.skipped],
        header.provenance or Provenance("parquet"),
        (*header.notes, *empty.notes),
    )
    return StoredRecording(about, str(path), str(beside), starts, person, np.cumsum(rows))


def _header(path: Path, file: Any) -> Header | None:
    encoded = (file.metadata.metadata or {}).get(KEY)
    return None if encoded is None else parse_header(path, encoded)


def _fits(file: Any, header: Header) -> bool:
    """Whether a samples file is as pointpred writes it."""
    schema = file.schema_arrow
    numeric = all(
        pa.types.is_float64(schema.field(name).type) for name in EVENT_COLUMNS if name in schema.names
    )
    return (
        header.provenance is not None
        and bool(header.name)
        and header.rows == file.metadata.num_rows
        and set(REQUIRED) <= set(schema.names) <= {"dataset", *KEYS, *EVENT_COLUMNS}
        and numeric
    )


def _scan(file: Any) -> tuple[IntArray, IntArray, IntArray] | None:
    """Where trials begin, whose they are, and a hash of each key; ``None`` where one comes again."""
    starts, hashes, person = [], [], []
    people: dict[str, int] = {}
    row, last = 0, ("", "")
    for i in range(file.num_row_groups):
        table = file.read_row_group(i, columns=KEYS, use_threads=False)
        if not table.num_rows:
            continue
        begins, keys, complete = _runs(table)
        if not complete:
            return None
        skip = int(row > 0 and keys[0] == last)  # the last trial of the group before goes on
        starts.append(begins[skip:] + row)
        hashes.append(np.array([hash(key) for key in keys[skip:]], dtype=np.int64))
        person.append(
            np.array([people.setdefault(user, len(people)) for user, _ in keys[skip:]], dtype=np.int64)
        )
        row, last = row + table.num_rows, keys[-1]
    if not starts:
        return None
    every = np.concatenate(hashes)
    if len(np.unique(every)) < len(every):
        return None
    return np.append(np.concatenate(starts), row), np.concatenate(person), every


def _runs(table: Any) -> tuple[IntArray, list[tuple[str, str]], bool]:
    """Where trials begin in a table, their (user, trial), and whether every row has both."""
    table = table.select(KEYS).unify_dictionaries()
    columns = [table[name].combine_chunks() for name in KEYS]
    codes = [arrow_tables.as_array(column.indices).astype(np.int64) for column in columns]
    words = [column.dictionary.to_pylist() for column in columns]
    joint = codes[0] * max(len(words[1]), 1) + codes[1]
    starts = np.flatnonzero(np.diff(joint, prepend=-1))
    keys = [(words[0][u], words[1][t]) for u, t in zip(*(c[starts].tolist() for c in codes), strict=True)]
    return starts, keys, not any(column.null_count for column in columns)


def _same_order(trials: Any, hashes: IntArray) -> bool:
    """Whether a trials file describes these trials in this order and no others."""
    if trials.metadata.num_rows != len(hashes):
        return False
    row = 0
    for i in range(trials.num_row_groups):
        batch = trials.read_row_group(i, columns=KEYS, use_threads=False)
        keys = zip(*(batch[name].to_pylist() for name in KEYS), strict=True)
        mine = np.array([hash(key) for key in keys], dtype=np.int64)
        if not np.array_equal(mine, hashes[row : row + len(mine)]):
            return False
        row += len(mine)
    return True


def _rows(file: Any, first: int, stop: int, columns: list[str]) -> Any:
    """Some rows of a file; the row groups that hold them are read."""
    sizes = [file.metadata.row_group(i).num_rows for i in range(file.num_row_groups)]
    ends = np.cumsum(sizes)
    groups = [i for i, end in enumerate(ends.tolist()) if end > first and end - sizes[i] < stop]
    table = file.read_row_groups(groups, columns=columns, use_threads=False)
    begin = int(ends[groups[0]]) - sizes[groups[0]] if groups else 0
    return table.slice(first - begin, stop - first)


@lru_cache(maxsize=1)
def _trials_file(path: str, changed: int) -> tuple[Header, Any]:
    """A trials file in Arrow's memory, some 100 bytes a trial; ``changed``: when the file was written."""
    with parquet_file(Path(path)) as file:
        table = file.read(use_threads=False).replace_schema_metadata(None)
        return _header(Path(path), file) or Header(), table
