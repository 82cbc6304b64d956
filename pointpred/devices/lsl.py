"""Lab Streaming Layer: its library, and its clock beside the one that everything live counts on."""

from __future__ import annotations

import time
from typing import Any

from pointpred.errors import SourceError
from pointpred.extras import require

PURPOSE = "Lab Streaming Layer"
TRIES = 5


def library() -> Any:
    """The module pylsl; raises MissingExtraError, and SourceError where its library cannot be loaded."""
    require("lsl", PURPOSE)
    try:
        import pylsl
    except (RuntimeError, OSError) as error:
        raise SourceError(f"{PURPOSE} cannot be loaded: {' '.join(str(error).split())}") from error
    return pylsl


def ahead_s(lsl: Any) -> float:
    """How far this computer's monotonic clock is ahead of Lab Streaming Layer's, s; the same on most systems.

    Of some looks the quickest one counts: it is off by less than the microseconds that it took.
    """
    looks = []
    for _ in range(TRIES):
        before, theirs, after = time.perf_counter(), lsl.local_clock(), time.perf_counter()
        looks.append((after - before, 0.5 * (before + after) - theirs))
    return float(min(looks)[1])
