"""Pointpred's own recordings: ``<set>_samples`` and ``<set>_trials``, both Parquet or both CSV."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import ParameterError, RecordingError
from pointpred.recording import Provenance, Recording, Skip
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import IntArray
from pointpred.recordings.columns import time_units
from pointpred.recordings.encodings import head_of, stem_of
from pointpred.recordings.own import appended, read_trials_table, trial_table
from pointpred.recordings.reading import AS_IS, Reading, row_name
from pointpred.recordings.trials import assemble, codes_of, keys_of
from pointpred.recordings.writing import write_together
from pointpred.records import FloatArray

REQUIRED = ("user", "trial", "t_s", "x_px", "y_px")
VALUES = ("t_s", "x_px", "y_px", "dx_counts", "dy_counts", "buttons")
KNOWN = ("dataset", *REQUIRED, "dx_counts", "dy_counts", "buttons", "t_raw_s")
SAMPLES, TRIALS, PREDICTIONS = "_samples", "_trials", "_predictions"
EXTENSIONS = (".parquet", ".csv")
READ = (*EXTENSIONS, ".csv.gz")
SLOW_S = 1.0
"""Largest plausible median interval, s; with a longer one a note asks about the unit of time."""


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
    for index, column in enumerate(VALUES):
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
    about_trials = read_trials_table(beside, name, keys, np.bincount(group))
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
    )
    slow = [] if header.provenance or reading.time_unit else _too_slow(recording)
    return msgspec.structs.replace(recording, notes=(*recording.notes, *slow))


def write(recording: Recording, path: str | Path) -> tuple[Path, Path]:
    """Write a recording as a samples file and a trials file; the same recording gives the same bytes.

    ``path`` names the samples file (``<set>_samples.parquet`` or ``.csv``; ``_samples`` is added if missing).
    Provenance, skips and notes go into the header. Floating point numbers are exact. Returns both paths; if
    one cannot be written, neither file is left or replaced. Raises RecordingError for another extension, two
    trials with the same user and name, or a condition that is text in one trial and a number in another.
    """
    with write_together() as part:
        return write_parts(recording, path, part)


def write_parts(recording: Recording, path: str | Path, part: Callable[[Path], Path]) -> tuple[Path, Path]:
    """Write both files of a recording as ``write`` does, each at its path in ``part`` (``together``)."""
    path, beside = files_of(path)
    sizes = np.diff(recording.offsets)
    about, header = trial_table(recording, sizes)
    index = pa.array(np.repeat(np.arange(len(sizes), dtype=np.int32), sizes))
    columns: dict[str, Any] = {
        key: pa.DictionaryArray.from_arrays(index, about[key].combine_chunks()).cast(pa.string())
        for key in ("dataset", "user", "trial")
    }
    for column, values in zip(VALUES, recording.events.table.T, strict=True):
        if column in REQUIRED or np.any(values == values if column != "buttons" else values != 0):
            columns[column] = pa.array(values, mask=np.isnan(values))
    header |= {
        "provenance": msgspec.to_builtins(recording.provenance),
        "skipped": [[skip.trial, skip.reason, skip.row, skip.user] for skip in recording.skipped],
        "notes": list(recording.notes),
    }
    arrow_tables.write_table(path, part(path), pa.table(columns), header)
    arrow_tables.write_table(beside, part(beside), about, {key: header[key] for key in ("name", "text")})
    return path, beside


def _seconds(column: Any, unit: str, group: IntArray) -> FloatArray:
    """The times of a column in its unit as seconds from the first row of each trial."""
    clock, _ = time_units.clock(column, unit == "iso")
    first = np.full(int(group.max(initial=-1)) + 1, np.nan)
    first[group[::-1]] = clock[::-1]
    seconds: FloatArray = (clock - first[group]) / time_units.PER_SECOND[unit]
    return seconds


def _too_slow(recording: Recording) -> list[str]:
    """A note if a clock without a unit is implausible in seconds."""
    inside = ~recording.events.begin[1:]
    intervals = np.diff(recording.events.t)[inside]
    middle = float(np.median(intervals)) if len(intervals) else 0.0
    if middle <= SLOW_S:
        return []
    return [f"the median interval is {middle:g} s; t_s is in seconds: are these milliseconds?"]


def files_of(path: str | Path) -> tuple[Path, Path]:
    """The samples file and the trials file that ``write`` makes of ``path``; raises RecordingError.

    >>> [file.name for file in files_of("study.csv")]
    ['study_samples.csv', 'study_trials.csv']
    """
    path = Path(path)
    if path.suffix not in EXTENSIONS:
        raise RecordingError(
            f"{path}: cannot write {path.suffix or 'no extension'}, expected .parquet or .csv"
        )
    stem = path.stem.removesuffix(SAMPLES)
    return path.with_name(f"{stem}{SAMPLES}{path.suffix}"), path.with_name(f"{stem}{TRIALS}{path.suffix}")


def check_free(path: str | Path) -> None:
    """Raise ParameterError if ``write`` to ``path`` would replace a file."""
    files = files_of(path)
    taken = [file for file in files if file.exists()]
    if taken:
        other = files[1] if taken[0] == files[0] else files[0]
        raise ParameterError(f"{taken[0]} exists; pass --force to replace it and {other.name}")


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
