"""What ``replay`` and ``live --replay`` play: one recording, some of its trials, how fast."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pointpred.cli.reading_options import recordings_in
from pointpred.console import remarks
from pointpred.errors import ParameterError, RecordingError

if TYPE_CHECKING:
    from pointpred.recording import Recording

SPEED = "1 as recorded, 2 twice as fast, max without waiting."
TRIAL = "USER-TRIAL, or its number counted from 1; repeatable. Not given: all."


def one_recording(file: Path | None, reading: Any) -> Recording:
    """The recording to play; the embedded sample where no file is named."""
    if file is None:
        from pointpred.datasets import sample

        remarks().print("No recording given: playing the embedded sample of simulated people.")
        return sample()
    from pointpred.cli.progress import following

    with following() as progress:
        recordings = recordings_in(file, reading, progress)
    if len(recordings) != 1:
        raise RecordingError(f"{file} holds {len(recordings)} recordings; name a file with one")
    return recordings[0]


def speed_of(text: str) -> float:
    """A number above 0, or infinity for ``max``; raises ParameterError."""
    try:
        value = math.inf if text == "max" else float(text)
    except ValueError:
        value = math.nan
    if not value > 0.0:
        raise ParameterError(f"speed must be a positive number or 'max', received {text!r}")
    return value


def print_skipped(skips: tuple[Any, ...]) -> None:
    """Say which trials are left out, and why."""
    for skip in skips:
        remarks().print(f"left out: {skip.user}-{skip.trial} {skip.reason}", style="red", markup=False)
