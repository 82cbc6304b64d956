"""Write pointpred's own recordings: all files appear, or none."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.csv as pacsv
import pyarrow.parquet as pq

from pointpred.errors import ParameterError, RecordingError
from pointpred.files import beside
from pointpred.recording import Recording
from pointpred.recordings.arrow_tables import EVENT_COLUMNS, KEY, MARK, open_file
from pointpred.recordings.own import EXTENSIONS, REQUIRED, SAMPLES, TRIALS
from pointpred.recordings.trials import TARGET, is_condition


@contextmanager
def write_together() -> Iterator[Callable[[Path], Path]]:
    """Yield a path to write each file to; at the end of the block all are renamed to their final names.

    On a failure or an interrupt no file is left and none is replaced. Raises RecordingError naming the file
    that cannot be renamed.
    """
    files: list[Path] = []

    def part(path: Path) -> Path:
        files.append(path)
        return _part(path)

    try:
        yield part
        _place(files)
    finally:
        for path in files:
            _part(path).unlink(missing_ok=True)


def _place(files: list[Path]) -> None:
    """Rename all files; on a failure the replaced ones are restored."""
    placed: list[Path] = []
    path = files[0] if files else Path()
    try:
        for path in files:
            if path.is_dir():
                raise RecordingError(f"{path}: cannot be written: it is a folder")
            _keep(path)
        for path in files:
            placed.append(path)
            _part(path).replace(path)
    except BaseException as error:
        for done in placed:
            if not _part(done).exists():
                done.unlink(missing_ok=True)
        for done in files:
            if _old(done).exists():
                _old(done).replace(done)
                _old(done).unlink(missing_ok=True)  # two hard links to one file both remain
        if isinstance(error, OSError):
            raise RecordingError(f"{path}: cannot be written: {error.strerror or error}") from error
        raise
    for path in files:
        _old(path).unlink(missing_ok=True)


def _keep(path: Path) -> None:
    """Back up a file under another name, if it exists."""
    old = _old(path)
    old.unlink(missing_ok=True)
    if path.exists():
        try:
            os.link(path, old)
        except OSError:  # a file system without links
            path.replace(old)


def _part(path: Path) -> Path:
    return beside(path, "part")


def _old(path: Path) -> Path:
    return beside(path, "old")


def trial_table(recording: Recording) -> tuple[Any, dict[str, Any]]:
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
    columns["n_samples"] = pa.array(np.diff(recording.offsets))
    text = []
    for column in sorted({key for trial in trials for key in trial.condition}):
        cells = [trial.condition.get(column) for trial in trials]
        kinds = {str if isinstance(cell, str) else float for cell in cells if cell is not None}
        if len(kinds) > 1 or not is_condition(column):
            raise RecordingError(
                f"{recording.name}: condition {column!r} cannot be written, expected a name of its own and "
                "either words or numbers in all trials"
            )
        text += [column] * (str in kinds)
        columns[column] = pa.array(cells, pa.string() if str in kinds else pa.float64())
    columns["clean"] = pa.array([trial.clean for trial in trials], pa.bool_())
    table = pa.table(columns)
    return table, {"name": recording.name, "text": text}


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
    """Write both files of a recording as ``write`` does, each where ``part`` of ``write_together`` says."""
    path, beside = files_of(path)
    about, header = trial_table(recording)
    header |= {
        "provenance": msgspec.to_builtins(recording.provenance),
        "skipped": [[skip.trial, skip.reason, skip.row, skip.user] for skip in recording.skipped],
        "notes": list(recording.notes),
    }
    write_table(path, part(path), samples_table(recording, about), header)
    write_table(beside, part(beside), about, {key: header[key] for key in ("name", "text")})
    return path, beside


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


def write_table(path: Path, part: Path, table: Any, header: dict[str, Any]) -> None:
    """Write a table with its header into ``part``, which is to become ``path``, as Parquet or CSV.

    The extension of ``path`` decides. The same table gives the same bytes. Raises RecordingError.
    """
    encoded = msgspec.json.encode(header | {"version": 1, "rows": table.num_rows}, order="sorted")
    try:
        with open_file(part, "wb") as file:
            if path.suffix == ".parquet":
                table = table.replace_schema_metadata({KEY: encoded})
                pq.write_table(table, file, compression="zstd", write_page_checksum=True)
            else:
                file.write(MARK + encoded + b"\n")
                file.write(",".join(table.column_names).encode() + b"\n")
                pacsv.write_csv(table, file, pacsv.WriteOptions(include_header=False))
    except (OSError, pa.ArrowException) as error:
        raise RecordingError(f"{path}: cannot be written: {error}") from error


def samples_table(recording: Recording, trials: Any, *, every: bool = False) -> Any:
    """The rows of a recording as a table, with ``every`` column or only those that say something."""
    sizes = np.diff(recording.offsets)
    index = pa.array(np.repeat(np.arange(len(sizes), dtype=np.int32), sizes))
    columns: dict[str, Any] = {
        key: pa.DictionaryArray.from_arrays(index, trials[key].combine_chunks()).cast(pa.string())
        for key in ("dataset", "user", "trial")
    }
    for column, values in zip(EVENT_COLUMNS, recording.events.table.T, strict=True):
        said = values != 0 if column == "buttons" else values == values
        if every or column in REQUIRED or np.any(said):
            columns[column] = pa.array(values, mask=np.isnan(values))
    return pa.table(columns)
