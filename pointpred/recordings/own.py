"""Pointpred's own recordings: ``<set>_samples`` and ``<set>_trials``, both Parquet or both CSV.

A file to which a recorder appended rows says ``"append": true`` in its header. Its process may have been
killed at any time, so the last line may be incomplete: that is left aside, with a note.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import Any, BinaryIO

import msgspec
import numpy as np
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import PARQUET_MAGIC, UNREADABLE, IntArray
from pointpred.recordings.columns import clocks
from pointpred.recordings.encodings import UTF_8, head_of, is_ended, open_utf8, read_unpacked, stem_of
from pointpred.recordings.reading import AS_IS, Cut, Reading, row_name
from pointpred.recordings.samples import Samples, recording_of
from pointpred.recordings.trials import (
    TARGET,
    TRIAL_COLUMNS,
    assemble,
    codes_of,
    condition_cells,
    keys_of,
    questions,
)
from pointpred.records import CPI, DPI, EVENT_FIELDS, FloatArray

MARK, KEY = b"# pointpred:", b"pointpred"
"""What is before the header in the first line of a CSV file; the name of the header in a Parquet file."""
EVENT_COLUMNS = tuple(field.column for field in EVENT_FIELDS)
"""The columns of an event."""
KEYS = ("dataset", "user", "trial")
REQUIRED = ("user", "trial", *EVENT_COLUMNS[:3])
KNOWN = (*KEYS, *EVENT_COLUMNS, "t_raw_s")
RECORDED = ("user", "trial", *EVENT_COLUMNS)
RECORDED_TRIALS = ("user", "trial", *TARGET, "n_samples")
"""The columns of files that are appended to; conditions come behind those of trials."""
RECORDER, LIVE = "pointpred recorder", "pointpred live"
"""Formats of the provenance of what the service, and a session of a device, recorded."""
SAMPLES, TRIALS, PREDICTIONS = "_samples", "_trials", "_predictions"
EXTENSIONS = (".parquet", ".csv")
READ = (*EXTENSIONS, ".csv.gz")
SLOW_S = 1.0
"""Largest plausible median interval, s; with a longer one a note asks about the unit of time."""
FLAGS = {"true": True, "1": True, "false": False, "0": False}
NEAR = 0.75
"""difflib ratio from which a condition may be a misspelt column of ours."""
UNENDED = "the last line has no end: the file may be cut"
OUTSIDE, UNFINISHED = "outside the marked trials", "the trial never ended"


class Header(msgspec.Struct, frozen=True):
    """The header of a file; a foreign file has these defaults.

    ``rows``: the number of rows in the file; ``text`` names conditions that are text; ``skipped`` trials that
    were left out before the file was written, each (trial, reason, row, user); ``append``: a recorder's.
    """

    version: Any = None
    name: str = ""
    rows: int | None = None
    text: tuple[str, ...] = ()
    provenance: Provenance | None = None
    skipped: tuple[tuple[str, str, int | None, str | None], ...] = ()
    notes: tuple[str, ...] = ()
    append: bool = False


def parse_header(path: Path, encoded: bytes | None) -> Header:
    """The header in ``encoded``; raises RecordingError if it is not JSON or not in our format."""
    if encoded is None:
        return Header(version=1)
    try:
        header = msgspec.json.decode(encoded, type=Header)
    except msgspec.ValidationError as error:
        raise RecordingError(f"{path}: the pointpred header is not as expected: {error}") from error
    except (msgspec.DecodeError, UnicodeError, RecursionError) as error:
        raise RecordingError(f"{path}: the pointpred header is not JSON: {error}") from error
    if header.version != 1:
        raise RecordingError(f"{path}: pointpred header version {header.version!r:.40}, expected 1")
    said = header.provenance or Provenance("")
    for name, value, (low, high) in (("cpi", said.cpi, CPI), ("dpi", said.dpi, DPI)):
        if value is not None and not low <= value <= high:
            raise RecordingError(
                f"{path}: {name} of the pointpred header must lie in [{low:g}, {high:g}], received {value!r}"
            )
    return header


def recognises(head: bytes) -> bool:
    """Whether a text that begins with ``head`` is one of pointpred's own."""
    first = head.split(b"\n", 1)[0]
    return first.startswith(MARK) or _has_our_names(
        first.decode("utf-8", "replace").replace('"', "").replace("\r", "").split(",")
    )


def recognises_further(path: Path, head: bytes) -> bool:
    """Whether a file is pointpred's own Parquet, whose header is at its end."""
    if not head.startswith(PARQUET_MAGIC):
        return False
    try:
        with arrow_tables.parquet_file(path) as file:
            return KEY in (file.metadata.metadata or {}) or _has_our_names(file.schema_arrow.names)
    except MemoryError as error:
        raise arrow_tables.unreadable(path, error) from error
    except UNREADABLE:
        return False


def recognises_recorder(head: bytes) -> bool:
    """Whether the header of a file that begins with ``head`` says that a recorder appended to it."""
    first, ended, _ = head.partition(b"\n")
    try:
        return bool(ended) and first.startswith(MARK) and parse_header(Path(), first[len(MARK) :]).append
    except RecordingError:
        return False


def _has_our_names(names: Sequence[str]) -> bool:
    """Whether these columns identify our samples or trials without a mark."""
    return {*REQUIRED} <= {*names} or {"user", "trial", "n_samples"} <= {*names}


def is_samples(path: Path) -> bool:
    """Whether a file has the name of one of pointpred's own samples files."""
    return stem_of(path).endswith(SAMPLES)


def trials_names(path: Path) -> list[Path]:
    """The files that may hold the trials of a samples file."""
    stem = stem_of(path).removesuffix(SAMPLES)
    return [path.with_name(f"{stem}{TRIALS}{end}") for end in dict.fromkeys((path.suffix, *READ))]


def trials_beside(path: Path) -> Path | None:
    """The trials file beside a samples file, if there is one."""
    return next((file for file in trials_names(path) if file.exists() and file != path), None)


def samples_beside(path: Path) -> bool:
    """Whether ``path`` holds the trials or predictions of a samples file beside it."""
    if not stem_of(path).endswith((TRIALS, PREDICTIONS)):
        return False
    stem = stem_of(path).removesuffix(TRIALS).removesuffix(PREDICTIONS)
    names = (SAMPLES, "") if stem_of(path).endswith(TRIALS) else (SAMPLES,)
    return any(path.with_name(f"{stem}{name}{end}").exists() for name in names for end in READ)


def read(path: str | Path, trials: str | Path | None = None, reading: Reading = AS_IS) -> Recording:
    """Read a samples file together with its trials file.

    Assumes the columns ``user, trial, t_s, x_px, y_px`` and optionally ``dataset, dx_counts, dy_counts,
    buttons``; any other column is an error (``t_raw_s`` is ignored, with a note). The rows of a trial must be
    in the order of time. ``reading.time_unit`` names another unit of ``t_s`` for a file not written by
    pointpred; time then starts at 0 in each trial. The trials file is ``trials`` or the sibling
    ``<set>_trials``; without one every target is unknown. Its columns beyond the target and ``clean`` become
    conditions; ``n_samples`` is compared with the samples. Only a stream that a recorder appended to is cut
    into trials, according to ``reading``. A trial that cannot be used is in ``Recording.skipped`` with the
    reason and the row.
    Memory: about 200 bytes a row while reading, 48 afterwards.
    Raises RecordingError naming the file, the row and the expected content.
    """
    path = Path(path)
    beside = trials_beside(path) if trials is None else Path(trials)
    words = (*KEYS, *(() if reading.time_unit is None else ("t_s",)))
    table, header = _read_table(path, lambda column: column in words)
    if header.append:
        return _of_recorder(path, beside, table, header, reading)
    names = table.column_names
    if "n_samples" in names and "t_s" not in names:
        raise RecordingError(f"{path}: this is a table of trials, expected the {SAMPLES} file beside it")
    arrow_tables.need_columns(path, names, REQUIRED, KNOWN)
    if header.rows is None:
        arrow_tables.unbroken(path, table, KEYS)
    name = header.name or _dataset(path, table)
    events, faults = events_of(table)
    group, keys = _keys(path, table)
    if reading.time_unit is not None and header.provenance is None:
        events[:, 0] = _seconds(table["t_s"], reading.time_unit, group)
    notes = ["column t_raw_s is left aside"] if "t_raw_s" in names else []
    if reading.time_unit is not None and header.provenance is not None:
        notes.append("time_unit has no effect: the file says itself that t_s is in seconds")
    notes += [] if len(group) or header.rows == 0 else ["no rows below the header"]
    del table
    if beside is None:
        about_trials = TrialsTable([Trial(*key) for key in keys])
    else:
        rows, about = _read_table(beside, lambda column: True)
        about_trials = described(beside, rows, about, name, keys, np.bincount(group))
    if not _is_whole(path):
        notes.append(UNENDED)
        about_trials.unusable |= {int(index): UNENDED for index in group[-1:]}
    recording = assemble(
        name,
        events,
        group,
        about_trials.trials,
        skipped=(*(Skip(*skip) for skip in header.skipped), *about_trials.empty),
        faults=faults,
        unusable=about_trials.unusable,
        provenance=header.provenance or Provenance("parquet" if path.suffix == ".parquet" else "csv"),
        notes=(*header.notes, *notes, *about_trials.notes),
        sort=reading.sort,
    )
    slow = [] if header.provenance or reading.time_unit else _too_slow(recording)
    asked = [] if header.provenance else questions(recording)
    return msgspec.structs.replace(recording, notes=(*recording.notes, *slow, *asked))


def _of_recorder(path: Path, beside: Path | None, table: Any, header: Header, reading: Reading) -> Recording:
    """The recording in a file to which rows were appended.

    Rows that name a trial are its samples, rows without a trial are skipped. If no row names one, the stream
    is cut according to ``reading``, by default at clicks, or at pauses for a live device without clicks. The
    marks of a live device are those of its contacts: each is cut at pauses by default. A trial without a row
    in its trials file had not ended; one that lost events has fewer samples than stated: both are skipped.
    """
    arrow_tables.need_columns(path, table.column_names, RECORDED, RECORDED)
    name = header.name or stem_of(path).removesuffix(SAMPLES)
    provenance = header.provenance or Provenance(RECORDER)
    events, faults = events_of(table)
    for row, fault in faults.items():
        raise RecordingError(f"{path}: {row_name(row)}: {fault}")
    marks = table["trial"].combine_chunks().dictionary_encode()
    users = table["user"].drop_null()
    user = str(users[0].as_py()) if len(users) else name
    notes = list(header.notes)
    marked = marks.null_count < len(marks)
    if not marked or (provenance.format == LIVE and beside is None):
        how: Cut = reading.cut or "clicks"
        breaks = np.flatnonzero(np.diff(marks.indices.fill_null(-1))) + 1
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
    group = arrow_tables.as_array(pc.fill_null(marks.indices, -1)).astype(np.int64)
    keys = [(user, trial) for trial in marks.dictionary.to_pylist()]
    rows = np.flatnonzero(group >= 0)
    if beside is None:
        about_trials = TrialsTable([Trial(*key) for key in keys])
        notes.append("no trials file: every target is unknown")
    else:
        trials, about = _read_table(beside, lambda column: True)
        arrow_tables.need_columns(beside, trials.column_names, RECORDED_TRIALS, trials.column_names)
        about_trials = described(beside, trials, about, name, keys, np.bincount(group[rows]))
        notes += about.notes
    edges = np.flatnonzero(np.diff(np.concatenate([[False], group < 0, [False]]).astype(np.int8)))
    outside = [
        Skip(f"rows {first} to {stop - 1}", OUTSIDE, first) for first, stop in edges.reshape(-1, 2).tolist()
    ]
    return assemble(
        name,
        events[rows],
        group[rows],
        about_trials.trials,
        skipped=(*outside, *about_trials.empty),
        unusable=about_trials.unusable,
        provenance=provenance,
        notes=(*notes, *about_trials.notes),
        row_of=rows,
        sort=reading.sort,
    )


def _read_table(path: Path, text: Callable[[str], bool]) -> tuple[Any, Header]:
    """The table in one of our files and its header; ``text`` names the text columns of a CSV file."""
    try:
        if head_of(path).startswith(PARQUET_MAGIC):
            table, metadata = arrow_tables.read_parquet(path)
            header = parse_header(path, metadata.get(KEY))
        else:
            table, header = _read_csv(path, text)
        arrow_tables.check_columns(path, table)
    except UNREADABLE as error:
        raise arrow_tables.unreadable(path, error) from error
    if header.rows not in (None, table.num_rows):
        raise RecordingError(
            f"{path}: truncated, it holds {table.num_rows} rows, expected {header.rows} rows",
            code="truncated",
            value=table.num_rows,
        )
    if not header.append:
        arrow_tables.unbroken(path, table, [name for name in table.column_names if not text(name)])
    return table, header


def _read_csv(path: Path, text: Callable[[str], bool]) -> tuple[Any, Header]:
    with _open_whole(path) as (file, note):
        first = file.readline(1 << 26).removeprefix(UTF_8)
        header = parse_header(path, first[len(MARK) :] if first.startswith(MARK) else None)
        if first.startswith(MARK) and not header.append and not is_ended(path):
            raise RecordingError(
                f"{path}: truncated, the last row does not end with a line break", code="truncated"
            )
        table = arrow_tables.read_csv(path, file, text, skip=int(first.startswith(MARK)))
    return table, msgspec.structs.replace(header, notes=(*header.notes, *filter(None, [note])))


@contextmanager
def _open_whole(path: Path) -> Iterator[tuple[BinaryIO, str]]:
    """The text of a file, of one that was appended to only its whole lines, and a note or an empty one."""
    if not recognises_recorder(head_of(path)):
        with open_utf8(path) as (file, encoding):
            yield file, encoding.note
        return
    data = read_unpacked(path)
    end = data.rstrip(b"\0").rfind(b"\n") + 1
    cut = len(data) - end
    yield (
        BytesIO(data[:end]),
        f"{path.name}: the last line is cut after {cut} bytes and left aside" if cut else "",
    )


def _is_whole(path: Path) -> bool:
    """Whether a CSV file ends with a line break; a Parquet file that was read is whole."""
    return head_of(path).startswith(PARQUET_MAGIC) or is_ended(path)


def events_of(table: Any) -> tuple[FloatArray, dict[int, str]]:
    """The events in the rows of a table, and what is no number by its row."""
    events = np.full((table.num_rows, len(EVENT_COLUMNS)), np.nan)
    events[:, -1] = 0.0
    faults: dict[int, str] = {}
    for index, column in enumerate(EVENT_COLUMNS):
        if column in table.column_names:
            events[:, index], wrong = arrow_tables.numbers(table[column])
            faults |= {row: f"{column} is {cell!r}, expected a number" for row, cell in wrong.items()}
    return events, faults


def _seconds(column: Any, unit: str, group: IntArray) -> FloatArray:
    """The times of a column in its unit as seconds from the first row of each trial."""
    clock, _ = clocks.clock(column, unit == "iso")
    first = np.full(int(group.max(initial=-1)) + 1, np.nan)
    first[group[::-1]] = clock[::-1]
    seconds: FloatArray = (clock - first[group]) / clocks.PER_SECOND[unit]
    return seconds


def _too_slow(recording: Recording) -> list[str]:
    """A note if a clock without a unit is implausible in seconds."""
    inside = ~recording.events.begin[1:]
    intervals = np.diff(recording.events.t)[inside]
    middle = float(np.median(intervals)) if len(intervals) else 0.0
    if middle <= SLOW_S:
        return []
    return [f"the median interval is {middle:g} s; t_s is in seconds: are these milliseconds?"]


def _dataset(path: Path, table: Any) -> str:
    """The one data set the rows belong to; the file's name without such a column."""
    if "dataset" not in table.column_names or not table.num_rows:
        return stem_of(path).removesuffix(SAMPLES)
    column = arrow_tables.words(table["dataset"])
    names_there = pc.unique(column).to_pylist()
    if len(names_there) > 1 or names_there[0] is None:
        row = column.to_pylist().index(names_there[min(1, len(names_there) - 1)])
        raise RecordingError(
            f"{path}: {row_name(row)} belongs to data set {column[row].as_py()!r}, "
            f"expected {names_there[0]!r} in every row"
        )
    return str(names_there[0])


def _keys(path: Path, table: Any) -> tuple[IntArray, list[tuple[str, str]]]:
    """For each row the index of its trial, and (user, trial) of each in the order of first appearance."""
    codes = []
    for name in ("user", "trial"):
        column = arrow_tables.words(table[name])
        if column.null_count:
            row = pc.index(pc.is_null(column), True).as_py()
            raise RecordingError(f"{path}: {row_name(row)} has no {name}, expected one in every row")
        codes.append(codes_of(column))
    return keys_of(*codes)


class TrialsTable(msgspec.Struct):
    """Trials in the requested order, those without samples, those that contradict them, and notes."""

    trials: list[Trial]
    empty: list[Skip] = []
    unusable: dict[int, str] = {}
    notes: list[str] = []


def described(
    path: Path, table: Any, header: Header, name: str, keys: Sequence[tuple[str, str]], sizes: IntArray
) -> TrialsTable:
    """What a trials file says of the trials ``keys`` = (user, trial), which have ``sizes`` samples.

    Its trials that have no samples are skips; a trial of another length than ``n_samples``, one described
    twice, or one with an impossible target is unusable, and of what a recorder wrote one that is not
    described. Raises RecordingError for a wrong column or set.
    """
    arrow_tables.need_columns(path, table.column_names, ("user", "trial"), table.column_names)
    arrow_tables.unbroken(
        path, table, (*TARGET, "n_samples", "clean", *(KEYS if header.rows is None else ()))
    )
    columns, faults = _columns(path, table, header.text)
    if table.num_rows and not header.append and not _is_whole(path):
        faults.setdefault(table.num_rows - 1, f"{path.name}: {UNENDED}")
    if any(other != name for other in columns.get("dataset", [])):
        other = next(other for other in columns["dataset"] if other != name)
        raise RecordingError(f"{path}: describes data set {other!r}, expected {name!r}")
    rows: dict[tuple[str, str], int] = {}
    twice: dict[tuple[str, str], str] = {}
    for row, key in enumerate(zip(columns["user"], columns["trial"], strict=True)):
        if key in rows:
            twice[key] = f"described twice, in rows {rows[key]} and {row} of {path.name}"
        rows.setdefault(key, row)
    conditions = [column for column in columns if column not in TRIAL_COLUMNS]
    result = TrialsTable([], notes=_misnamed(columns, conditions))
    for index, key in enumerate(keys):
        row = rows.pop(key, -1)
        if row >= 0:
            result.trials.append(_trial(key, columns, conditions, row))
            reason = twice.get(key) or faults.get(row) or _contradiction(columns, row, int(sizes[index]))
        else:
            result.trials.append(Trial(*key))
            reason = UNFINISHED if header.append else ""
            if not reason:
                result.notes.append(f"trial {key[1]} of {key[0]} is not described in {path.name}")
        if reason:
            result.unusable[index] = reason
    result.empty = [Skip(trial, "no samples", user=user) for user, trial in rows]
    return result


def _misnamed(columns: dict[str, list[Any]], conditions: Sequence[str]) -> list[str]:
    """A note for each of our columns that is missing while a condition has nearly that name."""
    lower = {condition.lower(): condition for condition in conditions}
    notes = []
    for own in (*TARGET, "clean"):
        near = difflib.get_close_matches(own, lower, 1, NEAR) if own not in columns else []
        if near and difflib.get_close_matches(near[0], TRIAL_COLUMNS, 1) == [own]:
            what = "targets are" if own in TARGET else "clean is"
            notes.append(f"{what} unknown: no column {own}; did {lower[near[0]]!r} mean it?")
    return notes


def _columns(path: Path, table: Any, text: Sequence[str]) -> tuple[dict[str, list[Any]], dict[int, str]]:
    """The columns as Python values (None for empty cells), and the faults by row."""
    columns: dict[str, list[Any]] = {}
    faults: dict[int, str] = {}
    for name in table.column_names:
        column = table[name]
        if name in KEYS:
            columns[name] = arrow_tables.words(column).to_pylist()
            if None in columns[name]:
                raise RecordingError(f"{path}: {row_name(columns[name].index(None))} has no {name}")
        elif name == "clean" and arrow_tables.is_words(column):
            cells = [(cell or "").strip().lower() for cell in column.to_pylist()]
            columns[name] = [FLAGS.get(cell) for cell in cells]
            wrong = {row: cell for row, cell in enumerate(cells) if cell and cell not in FLAGS}
            faults |= {row: f"clean is {cell!r}, expected true or false" for row, cell in wrong.items()}
        elif name not in TRIAL_COLUMNS and arrow_tables.is_words(column):
            columns[name] = condition_cells(column, text=name in text)
        else:
            values, wrong = arrow_tables.numbers(column)
            columns[name] = [None if value != value else value for value in values.tolist()]
            faults |= {row: f"{name} is {cell!r}, expected a number" for row, cell in wrong.items()}
    return columns, faults


def _trial(key: tuple[str, str], columns: dict[str, list[Any]], conditions: Sequence[str], row: int) -> Trial:
    """One row as a trial; empty cells are unknown."""
    said = {name: cells[row] for name, cells in columns.items() if cells[row] is not None}
    clean = said.get("clean")
    return Trial(
        *key,
        **{name: said[name] for name in TARGET if name in said},
        clean=None if clean is None else bool(clean),
        condition={name: said[name] for name in conditions if name in said},
    )


def _contradiction(columns: dict[str, list[Any]], row: int, size: int) -> str:
    """Why a trial's description contradicts its samples; empty if it does not."""
    count = columns["n_samples"][row] if "n_samples" in columns else None
    if count is not None and count != size:
        return f"{size} samples, expected {count:g} as the trials file says"
    for name in TARGET:
        value = columns[name][row] if name in columns else None
        if value is not None and (not np.isfinite(value) or (name == "target_w" and value <= 0)):
            return f"{name} is {value}, expected a finite number" + (" above 0" * (name == "target_w"))
    return ""
