"""The samples of an accelerometer that belong to each trial of a stream."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray
from pointpred.sources.tables.column_table import IntArray

BEFORE_S = 10.0
"""Most of the time before a trial whose samples go with it."""


def samples_of_trials(
    samples: FloatArray, clock: FloatArray, members: IntArray, group: IntArray, count: int
) -> list[FloatArray]:
    """Of each of ``count`` trials the samples up to its last row, on a clock that is 0 at its first.

    ``samples`` has shape (samples, 4), times in s that never fall; ``clock`` s of every row of the file, of
    which ``members`` are in trials, each in that of ``group``. A trial has the samples since the row before
    its first one, whether that is in a trial or not, and at most 10 s of them: while no row comes, the
    device rests, and its samples then tell gravity and bias.
    """
    parts = [np.empty((0, samples.shape[1])) for _ in range(count)]
    order = np.argsort(group, kind="stable")
    first = np.searchsorted(group[order], np.arange(count), side="left")
    stop = np.searchsorted(group[order], np.arange(count), side="right")
    for k in range(count):
        rows = members[order[first[k] : stop[k]]]
        if not len(rows) or not np.isfinite(clock[rows[[0, -1]]]).all():
            continue
        begins, ends = clock[rows[0]], clock[rows[-1]]
        earlier = clock[rows[0] - 1] if rows[0] else -np.inf
        since = max(begins - BEFORE_S, earlier if earlier <= begins else -np.inf)
        a, b = np.searchsorted(samples[:, 0], [since, ends], side="right")
        parts[k] = samples[a:b].copy()
        parts[k][:, 0] -= begins
    return parts
