"""When events are due: at the recorded times, faster, or as fast as they are taken."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator

import numpy as np

from pointpred.records import FloatArray

MOST_AT_ONCE = 256
"""Most rows that are due together."""


def due(t: FloatArray, speed: float, most: int = MOST_AT_ONCE) -> Iterator[tuple[int, int]]:
    """Ranges (first, stop) of the rows that are due, after waiting until they are.

    ``t`` s, growing; ``speed`` 1 keeps the recorded times, 2 halves them, infinity never waits.
    Rows that became due while the last ones were sent come together.

    >>> list(due(np.array([0.0, 0.001, 0.002]), math.inf, most=2))
    [(0, 2), (2, 3)]
    """
    began, first = time.perf_counter(), 0
    while first < len(t):
        if math.isinf(speed):
            stop = min(len(t), first + most)
        else:
            wait = began + (t[first] - t[0]) / speed - time.perf_counter()
            if wait > 0.0:
                time.sleep(wait)
            passed = t[0] + (time.perf_counter() - began) * speed
            stop = min(max(first + 1, int(np.searchsorted(t, passed, side="right"))), first + most)
        yield first, stop
        first = stop
