"""The table of trials beside a samples file: targets, descriptions of each trial, conditions."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa

from pointpred.errors import RecordingError
from pointpred.recording import Recording, Skip, Trial
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import Header, IntArray
from pointpred.recordings.reading import row_name
from pointpred.recordings.trials import TARGET, TRIAL_COLUMNS

KEYS = ("dataset", "user", "trial")
YES, NO = "true", "false"
NEAR = 0.75
"""difflib ratio from which a condition may be a misspelt column of ours."""


class TrialsTable(msgspec.Struct):
    """Trials in the requested order, those without samples, those that contradict them, and notes."""

    trials: list[Trial]
    empty: list[Skip] = []
    unusable: dict[int, str] = {}
    notes: list[str] = []


def read_trials_table(
    path: Path | None, name: str, keys: Sequence[tuple[str, str]], sizes: IntArray
) -> TrialsTable:
    """Read the descriptions of the trials ``keys`` = (user, trial), which have ``sizes`` samples.

    Trials of the file that have no samples are skips; a trial of other length than ``n_samples``, one
    described twice, or one with an impossible target is unfit. Raises RecordingError if the file cannot be
    read.
    """
    if path is None:
        return TrialsTable([Trial(user, trial) for user, trial in keys])
    table, header = arrow_tables.read_table(path, lambda column: True)
    return described(path, table, header, name, keys, sizes)


def described(
    path: Path, table: Any, header: Header, name: str, keys: Sequence[tuple[str, str]], sizes: IntArray
) -> TrialsTable:
    """``read_trials_table`` of the rows of a table that was read."""
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


def trial_table(recording: Recording, sizes: IntArray) -> tuple[Any, dict[str, Any]]:
    """The trials of a recording as an Arrow table, and the names of the text columns for the header."""
    trials = recording.trials
    keys = [(trial.user, trial.trial) for trial in trials]
    if len(set(keys)) < len(keys):
        user, trial = next(key for at, key in enumerate(keys) if key in keys[:at])
        raise RecordingError(f"{recording.name}: trial {trial!r} of {user!r} occurs twice, cannot be written")
    columns: dict[str, Any] = {
        "dataset": pa.array([recording.name] * len(trials), pa.string()),
        "user": pa.array([user for user, _ in keys], pa.string()),
        "trial": pa.array([trial for _, trial in keys], pa.string()),
    }
    for column in TARGET:
        values = np.array([getattr(trial, column) for trial in trials], dtype=np.float64)
        columns[column] = pa.array(values, mask=np.isnan(values))
    columns["n_samples"] = pa.array(np.asarray(sizes, np.int64))
    text = []
    for column in sorted({key for trial in trials for key in trial.condition}):
        cells = [trial.condition.get(column) for trial in trials]
        kinds = {str if isinstance(cell, str) else float for cell in cells if cell is not None}
        if (
            column in TRIAL_COLUMNS
            or len(kinds) > 1
            or not column
            or column != column.strip(' "\r\n,')
            or "," in column
        ):
            raise RecordingError(
                f"{recording.name}: condition {column!r} cannot be written, expected a name of its own and "
                "either words or numbers in all trials"
            )
        text += [column] * (str in kinds)
        columns[column] = pa.array(cells, pa.string() if str in kinds else pa.float64())
    columns["clean"] = pa.array([trial.clean for trial in trials], pa.bool_())
    table = pa.table(columns)
    return table, {"name": recording.name, "text": text}


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
        elif name not in TRIAL_COLUMNS and not typed and (name in text or not _numeric(column)):
            columns[name] = column.to_pylist()
            continue
        values, wrong_cells = arrow_tables.numbers(column)
        faults |= {row: f"{name} is {cell!r}, expected a number" for row, cell in wrong_cells.items()}
        columns[name] = [None if value != value else value for value in values.tolist()]
    return columns, faults


def _numeric(column: Any) -> bool:
    """Whether every cell of a text column is a number or empty."""
    return not arrow_tables.numbers(column)[1]


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
