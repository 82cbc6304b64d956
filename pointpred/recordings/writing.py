"""Recordings written as pointpred's own: all files appear, or none."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.csv as pacsv
import pyarrow.parquet as pq

from pointpred.errors import ParameterError, RecordingError
from pointpred.files import together
from pointpred.recording import Recording, kinds_of
from pointpred.recordings.arrow_tables import open_file
from pointpred.recordings.own import EVENT_COLUMNS, EXTENSIONS, KEY, KEYS, MARK, REQUIRED, SAMPLES, TRIALS
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.trials import TARGET, is_condition

LONGEST_BYTES = 150
RESERVED = re.compile(r"^(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(?=\.|$)", re.IGNORECASE)
"""Device names on Windows, also with any extension."""


def write(recording: Recording, path: str | Path) -> tuple[Path, Path]:
    """Write a recording as a samples file and a trials file; the same recording gives the same bytes.

    ``path`` names the samples file (``<set>_samples.parquet`` or ``.csv``; ``_samples`` is added if missing).
    Provenance, skips and notes go into the header. Floating point numbers are exact. Returns both paths; if
    one cannot be written, neither file is left or replaced. Raises RecordingError for another extension, two
    trials with the same user and name, or a condition that is text in one trial and a number in another.
    """
    with write_together() as part:
        return write_parts(recording, path, part)


@contextmanager
def write_together() -> Iterator[Callable[[Path], Path]]:
    """As ``together`` of ``pointpred.files``; raises RecordingError naming the file that has no place."""
    try:
        with together() as part:
            yield part
    except OSError as error:
        raise RecordingError(f"{error.filename}: cannot be written: {error.strerror or error}") from error


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
    return pa.table(columns), {"name": recording.name, "text": text}


def samples_table(recording: Recording, trials: Any, *, every: bool = False) -> Any:
    """The rows of a recording as a table, with ``every`` column or only those that say something."""
    sizes = np.diff(recording.offsets)
    index = pa.array(np.repeat(np.arange(len(sizes), dtype=np.int32), sizes))
    columns: dict[str, Any] = {
        key: pa.DictionaryArray.from_arrays(index, trials[key].combine_chunks()).cast(pa.string())
        for key in KEYS
    }
    for column, values in zip(EVENT_COLUMNS, recording.events.table.T, strict=True):
        said = values != 0 if column == "buttons" else values == values
        if every or column in REQUIRED or np.any(said):
            columns[column] = pa.array(values, mask=np.isnan(values))
    return pa.table(columns)


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


class Summary(msgspec.Struct, frozen=True):
    """The result of a conversion: files written, trials and users kept, how many were skipped, notes.

    ``skipped`` counts them by the kind of reason, which names the first of several.
    """

    files: tuple[str, ...]
    trials: int
    users: int
    rows: int
    skipped: dict[str, int]
    notes: tuple[str, ...]


def convert(
    path_in: str | Path, path_out: str | Path, reading: Reading = AS_IS, *, replace: bool = True
) -> Summary:
    """Convert a recording of any format, or a folder of one, to pointpred's own Parquet or CSV.

    ``path_out`` ends in ``.parquet`` or ``.csv``; if the input has several recordings, each goes to a file of
    that name prefixed with its own. A recording without a trial is not written. On any failure no file is
    left and none is replaced. Raises RecordingError, and ParameterError if a file would be replaced without
    ``replace``.
    """
    from pointpred.recordings.read_files import read_any  # writing alone needs no other format

    return write_recordings(read_any(path_in, reading), path_out, replace=replace)


def write_recordings(parts: list[Recording], path_out: str | Path, *, replace: bool = True) -> Summary:
    """Write recordings as ``convert`` does; raises what it raises."""
    out = Path(path_out)
    several = len(parts) > 1
    names = file_names([recording.name for recording in parts], out.name) if several else [out.name]
    for name in names:
        (files_of if replace else check_free)(out.with_name(name))
    files: list[str] = []
    with write_together() as part:
        for recording, name in zip(parts, names, strict=True):
            if recording.trials:
                files += map(str, write_parts(recording, out.with_name(name), part))
    return Summary(
        tuple(files),
        sum(len(recording.trials) for recording in parts),
        len({(recording.name, trial.user) for recording in parts for trial in recording.trials}),
        sum(len(recording.events) for recording in parts),
        {
            kind if len(skips) == 1 else f"{kind} (first: {skips[0].place})": len(skips)
            for kind, skips in kinds_of(skip for recording in parts for skip in recording.skipped)
        },
        tuple(note for recording in parts for note in recording.notes),
    )


def file_names(names: Sequence[str], ending: str) -> list[str]:
    """A file name ``<name>_<ending>`` for each name, unique also without regard to case.

    >>> file_names(["study", "lab/a", "lab:a"], "all.csv")
    ['study_all.csv', 'lab_a_all.csv', 'lab_a_2_all.csv']
    """
    taken: dict[str, str] = {}
    for name in names:
        plain = re.sub(r"[^\w.,+ -]+", "_", name).strip(". ")
        plain = RESERVED.sub(r"\1_", plain)
        plain = plain.encode()[:LONGEST_BYTES].decode(errors="ignore") or "recording"
        chosen, count = f"{plain}_{ending}", 1
        while chosen.lower() in taken:
            count += 1
            chosen = f"{plain}_{count}_{ending}"
        taken[chosen.lower()] = chosen
    return list(taken.values())
