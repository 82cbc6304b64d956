"""Movements as a page or a slower mouse would report them."""

from __future__ import annotations

import numpy as np

from pointpred.recording import Recording
from pointpred.records import EventColumns


def thinned(recording: Recording, period_s: float) -> Recording:
    """The same movements with the newest event every ``period_s``, and the last one."""
    parts = []
    for trial in range(len(recording.trials)):
        events = recording.rows(trial)
        frames = np.arange(0.0, events.t[-1], period_s)
        rows = np.searchsorted(events.t, frames, side="right") - 1
        parts.append(EventColumns(events.table[np.unique([*rows, len(events) - 1])]))
    return Recording.of(recording.name, parts, recording.trials, provenance=recording.provenance)
