"""Convert recordings of any known format to pointpred's own."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import msgspec

from pointpred import recordings
from pointpred.recording import Recording
from pointpred.recordings.conversion import file_names
from pointpred.recordings.read_files import read_any
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.writing import write_together


class Summary(msgspec.Struct, frozen=True):
    """The result of a conversion: files written, trials and users kept, trials skipped by reason, notes."""

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
    return write_recordings(read_any(path_in, reading), path_out, replace=replace)


def write_recordings(parts: list[Recording], path_out: str | Path, *, replace: bool = True) -> Summary:
    """Write recordings as ``convert`` does; raises what it raises."""
    out = Path(path_out)
    several = len(parts) > 1
    names = file_names([recording.name for recording in parts], out.name) if several else [out.name]
    for name in names:
        (recordings.files_of if replace else recordings.check_free)(out.with_name(name))
    files: list[str] = []
    with write_together() as part:
        for recording, name in zip(parts, names, strict=True):
            if recording.trials:
                files += map(str, recordings.write_parts(recording, out.with_name(name), part))
    return Summary(
        tuple(files),
        sum(len(recording.trials) for recording in parts),
        len({(recording.name, trial.user) for recording in parts for trial in recording.trials}),
        sum(len(recording.events) for recording in parts),
        dict(Counter(skip.reason for recording in parts for skip in recording.skipped)),
        tuple(note for recording in parts for note in recording.notes),
    )
