"""Convert recordings of any known format to pointpred's own."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import msgspec

from pointpred.recording import Recording, kinds_of
from pointpred.recordings.read_files import read_any, readable
from pointpred.recordings.reading import AS_IS, Reading
from pointpred.recordings.writing import check_free, files_of, write_parts, write_together

LONGEST_BYTES = 150
RESERVED = re.compile(r"^(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(?=\.|$)", re.IGNORECASE)
"""Device names on Windows, also with any extension."""


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
        plain = re.sub(r"[^\w.,+ -]+", "_", readable(name)).strip(". ")
        plain = RESERVED.sub(r"\1_", plain)
        plain = plain.encode()[:LONGEST_BYTES].decode(errors="ignore") or "recording"
        chosen, count = f"{plain}_{ending}", 1
        while chosen.lower() in taken:
            count += 1
            chosen = f"{plain}_{count}_{ending}"
        taken[chosen.lower()] = chosen
    return list(taken.values())
