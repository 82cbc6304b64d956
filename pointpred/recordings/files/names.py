"""File names valid on any file system, and names from any file system as text."""

from __future__ import annotations

import re
from collections.abc import Sequence

import msgspec

from pointpred.recording import Recording

LONGEST_BYTES = 150
RESERVED = re.compile(r"^(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(?=\.|$)", re.IGNORECASE)
"""Device names on Windows, also with any extension."""


def readable(text: str) -> str:
    """A file's name as valid text; bytes that are not UTF-8 become replacement marks.

    >>> readable("study") == "study"
    True
    """
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def readable_recording(recording: Recording) -> Recording:
    """The recording with every name, reason and note ``readable``."""
    replace = msgspec.structs.replace
    return replace(
        recording,
        name=readable(recording.name),
        trials=tuple(
            replace(trial, user=readable(trial.user), trial=readable(trial.trial))
            for trial in recording.trials
        ),
        skipped=tuple(
            replace(
                skip,
                trial=readable(skip.trial),
                reason=readable(skip.reason),
                user=None if skip.user is None else readable(skip.user),
            )
            for skip in recording.skipped
        ),
        notes=tuple(map(readable, recording.notes)),
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
