"""Is a trial clean? A rule for recordings that do not say it themselves."""

from __future__ import annotations

from math import hypot, sqrt

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.records import BoolArray, EventColumns, FloatArray

DISTANCE_PX = 80.0
"""A clean trial goes at least so far."""
PATH_RATIO = 1.5
"""Its path is at most so many times the distance."""
STANDSTILL_S = 0.1
"""On the way it never stands still for longer."""
LEAVING, ARRIVING = 0.05, 0.95
"""The way: between these shares of the progress along the line from start to end."""


@law
def straight_through(table: FloatArray, first: int, stop: int) -> bool:
    """Whether the trial in rows ``first`` up to ``stop`` goes far enough, straight enough, without a stop."""
    x, y = table[first, 1], table[first, 2]
    along_x, along_y = table[stop - 1, 1] - x, table[stop - 1, 2] - y
    square = along_x * along_x + along_y * along_y
    path, moved = 0.0, first
    for i in range(first + 1, stop):
        step = hypot(table[i, 1] - table[i - 1, 1], table[i, 2] - table[i - 1, 2])
        if step > 0.0:
            progress = ((table[moved, 1] - x) * along_x + (table[moved, 2] - y) * along_y) / square
            if LEAVING < progress < ARRIVING and table[i, 0] - table[moved, 0] > STANDSTILL_S:
                return False
            moved = i
        path += step
    return bool(square >= DISTANCE_PX**2 and path <= PATH_RATIO * sqrt(square))


@law
def judge(table: FloatArray, offsets: NDArray[np.int64], out: BoolArray) -> None:
    """The same for each trial."""
    for k in range(len(out)):
        out[k] = straight_through(table, offsets[k], offsets[k + 1])


def clean_trials(events: EventColumns, offsets: NDArray[np.int64]) -> BoolArray:
    """Which trials are clean: at least 80 px far, path at most 1.5 times that, no stop on the way over 0.1 s.

    Rows ``offsets[i]`` up to ``offsets[i + 1]`` are trial i; each covers some distance. The rule looks at
    the whole trial: it picks trials to compare with papers that excluded the rest, and is never used on line.
    """
    out = np.zeros(len(offsets) - 1, dtype=np.bool_)
    judge(events.table, offsets, out)
    return out
