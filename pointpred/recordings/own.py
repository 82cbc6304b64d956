"""Pointpred's own recordings: ``<set>_samples`` and ``<set>_trials``, both Parquet or both CSV."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import RecordingError
from pointpred.recording import Provenance, Recording, Skip, Trial
from pointpred.recordings import appended, arrow_tables
from pointpred.recordings.arrow_tables import EVENT_COLUMNS, Header, IntArray
from pointpred.recordings.columns import clocks
from pointpred.recordings.encodings import head_of, stem_of
from pointpred.recordings.reading import AS_IS, Reading, row_name
from pointpred.recordings.trials import (
    TARGET,
    TRIAL_COLUMNS,
    assemble,
    codes_of,
    condition_cells,
    keys_of,
    questions,
)
from pointpred.records import FloatArray

REQUIRED = ("user", "trial", *EVENT_COLUMNS[:3])
KNOWN = ("dataset", "user", "trial", *EVENT_COLUMNS, "t_raw_s")
SAMPLES, TRIALS, PREDICTIONS = "_samples", "_trials", "_predictions"
EXTENSIONS = (".parquet", ".csv")
READ = (*EXTENSIONS, ".csv.gz")
SLOW_S = 1.0
"""Largest plausible median interval, s; with a longer one a note asks about the unit of time."""
KEYS = ("dataset", "user", "trial")
YES, NO = "true", "false"
NEAR = 0.75
"""difflib ratio from which a condition may be a misspelt column of ours."""


def read(path: str | Path, trials: str | Path | None = None, reading: Reading = AS_IS) -> Recording:
    """Read a samples file together with its trials file.

    Assumes the columns ``user, trial, t_s, x_px, y_px`` and optionally ``dataset, dx_counts, dy_counts,
    buttons``; any other column is an error (``t_raw_s`` is ignored, with a note). The rows of a trial must be
    in the order of time. ``reading.time_unit`` names another unit of ``t_s`` for a file not written by
    pointpred; time then starts at 0 in each trial. The trials file is ``trials`` or the sibling
    ``<set>_trials``; without one every target is unknown. Its columns beyond the target and ``clean`` become
    conditions; ``n_samples`` is compared with the samples. Only a stream of the service's recorder is cut
    into trials, according to ``reading``. A trial that cannot be used is in ``Recording.skipped`` with the
    reason and the row.
    Memory: about 200 bytes a row while reading, 48 afterwards.
    Raises RecordingError naming the file, the row and the expected content.
    """
    path = Path(path)
    beside = trials_beside(path) if trials is None else Path(trials)
    if is_appended(path):
        return appended.read(path, beside, reading)
    words = ("dataset", "user", "trial", *(() if reading.time_unit is None else ("t_s",)))
    table, header = arrow_tables.read_table(path, lambda column: column in words)
    names = table.column_names
    if "n_samples" in names and "t_s" not in names:
        raise RecordingError(f"{path}: this is a table of trials, expected the {SAMPLES} file beside it")
    arrow_tables.need_columns(path, names, REQUIRED, KNOWN)
    if header.rows is None:
        arrow_tables.unbroken(path, table, ("dataset", "user", "trial"))
    name = header.name or _dataset(path, table)
    events = np.full((table.num_rows, 6), np.nan)
    events[:, 5] = 0.0
    faults: dict[int, str] = {}
    for index, column in enumerate(EVENT_COLUMNS):
        if column in names:
            events[:, index], wrong = arrow_tables.numbers(table[column])
            faults |= {row: f"{column} is {cell!r}, expected a number" for row, cell in wrong.items()}
    group, keys = _keys(path, table)
    if reading.time_unit is not None and header.provenance is None:
        events[:, 0] = _seconds(table["t_s"], reading.time_unit, group)
    del table
    notes = ["column t_raw_s is left aside"] if "t_raw_s" in names else []
    if reading.time_unit is not None and header.provenance is not None:
        notes.append("time_unit has no effect: the file says itself that t_s is in seconds")
    notes += [] if len(group) or header.rows == 0 else ["no rows below the header"]
    if beside is None:
        about_trials = TrialsTable([Trial(*key) for key in keys])
    else:
        rows, about = arrow_tables.read_table(beside, lambda column: True)
        about_trials = described(beside, rows, about, name, keys, np.bincount(group))
    if not arrow_tables.is_whole(path):
        notes.append(arrow_tables.UNENDED)
        about_trials.unusable |= {int(index): arrow_tables.UNENDED for index in group[-1:]}
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


def is_samples(path: Path) -> bool:
    """Whether a file has the name of one of pointpred's own samples files."""
    return stem_of(path).endswith(SAMPLES)


def trials_beside(path: Path) -> Path | None:
    """The trials file beside a samples file, if there is one."""
    stem = stem_of(path).removesuffix(SAMPLES)
    names_there = [path.with_name(f"{stem}{TRIALS}{end}") for end in (path.suffix, *READ)]
    return next((file for file in names_there if file.exists() and file != path), None)


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


def is_appended(path: Path) -> bool:
    """Whether a file was written by the service's recorder, row by row."""
    return appended.recognises(head_of(path, appended.MOST_HEADER))


def samples_beside(path: Path) -> bool:
    """Whether ``path`` holds the trials or predictions of a samples file beside it."""
    if not stem_of(path).endswith((TRIALS, PREDICTIONS)):
        return False
    stem = stem_of(path).removesuffix(TRIALS).removesuffix(PREDICTIONS)
    names = (SAMPLES, "") if stem_of(path).endswith(TRIALS) else (SAMPLES,)
    return any(path.with_name(f"{stem}{name}{end}").exists() for name in names for end in READ)


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
    twice, or one with an impossible target is unusable. Raises RecordingError for a wrong column or set.
    """
    arrow_tables.need_columns(path, table.column_names, ("user", "trial"), table.column_names)
    arrow_tables.unbroken(
        path, table, (*TARGET, "n_samples", "clean", *(KEYS if header.rows is None else ()))
    )
    columns, faults = _columns(path, table, header.text)
    if table.num_rows and not arrow_tables.is_whole(path):
        faults.setdefault(table.num_rows - 1, f"{path.name}: {arrow_tables.UNENDED}")
    if any(other != name for other in columns.get("dataset", [])):
        other = next(other for other in columns["dataset"] if other != name)
        raise RecordingError(f"{path}: describes data set {other!r}, expected {name!r}")
    rows: dict[tuple[str, str], int] = {}
    twice: dict[tuple[str, str], str] = {}
    for row, key in enumerate(zip(columns["user"], columns["trial"], strict=True)):
        if key in rows:
            twice[key] = f"described twice, in rows {rows[key]} and {row} of {path.name}"
        rows.setdefault(key, row)
    result = TrialsTable([], [], {}, [])
    conditions = [column for column in columns if column not in TRIAL_COLUMNS]
    result.notes += _misnamed(columns, conditions)
    for index, key in enumerate(keys):
        if key not in rows:
            result.trials.append(Trial(*key))
            result.notes.append(f"trial {key[1]} of {key[0]} is not described in {path.name}")
            continue
        row = rows.pop(key)
        result.trials.append(_trial(key, columns, conditions, row))
        reason = twice.get(key) or faults.get(row) or _contradiction(columns, row, int(sizes[index]))
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
        typed = not pa.types.is_string(column.type) and not pa.types.is_large_string(column.type)
        if name in KEYS:
            columns[name] = arrow_tables.words(column).to_pylist()
            if None in columns[name]:
                raise RecordingError(f"{path}: {row_name(columns[name].index(None))} has no {name}")
            continue
        if name == "clean" and not typed:
            column, wrong = _flags(column)
            faults |= wrong
        elif name not in TRIAL_COLUMNS and not typed:
            columns[name] = condition_cells(column, text=name in text)
            continue
        values, wrong_cells = arrow_tables.numbers(column)
        faults |= {row: f"{name} is {cell!r}, expected a number" for row, cell in wrong_cells.items()}
        columns[name] = [None if value != value else value for value in values.tolist()]
    return columns, faults


def _flags(column: Any) -> tuple[Any, dict[int, str]]:
    """Text true and false as a column of booleans, and the rows with anything else."""
    cells = [None if cell is None else cell.strip().lower() for cell in column.to_pylist()]
    wrong = {
        row: f"clean is {cell!r}, expected true or false"
        for row, cell in enumerate(cells)
        if cell not in (None, "", YES, NO, "1", "0")
    }
    values = [{YES: True, "1": True, NO: False, "0": False}.get(cell or "") for cell in cells]
    return pa.array(values, pa.bool_()), wrong


def _trial(key: tuple[str, str], columns: dict[str, list[Any]], conditions: Sequence[str], row: int) -> Trial:
    """One row as a trial; empty cells are unknown."""
    targets = {name: columns[name][row] for name in TARGET if name in columns}
    target = {name: value for name, value in targets.items() if value is not None}
    clean = columns["clean"][row] if "clean" in columns else None
    condition = {name: columns[name][row] for name in conditions if columns[name][row] is not None}
    return Trial(*key, **target, clean=None if clean is None else bool(clean), condition=condition)


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
