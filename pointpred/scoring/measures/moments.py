"""The events at which claims are read: those at shares of the time from onset to arrival."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pointpred.compiled import law
from pointpred.records import FloatArray

DECILES = tuple(round(0.1 * i, 1) for i in range(1, 10))
"""Shares of the time from onset to arrival at which claims are read."""


@law
def moments(
    rows: FloatArray, first: int, arrival: int, last: int, shares: FloatArray, out: NDArray[np.int64]
) -> None:
    """For each share of the time its row: the last at or before that time; shares ascend."""
    i, start, span = first, rows[first, 0], rows[arrival, 0] - rows[first, 0]
    for k in range(len(shares)):
        while i < last and rows[i + 1, 0] <= start + shares[k] * span:
            i += 1
        out[k] = i
