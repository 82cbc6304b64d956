"""What the clients of the soak send: the movements of the embedded sample, one after another, for ever."""

from __future__ import annotations

from functools import cache

import numpy as np

from pointpred.datasets import sample
from pointpred.records import FloatArray

APART = 9973
"""Events between the beginnings of two clients in the sample."""


@cache
def _recorded() -> FloatArray:
    return sample().events.table


def events(number: int, rate_hz: float, first: int, count: int) -> FloatArray:
    """Events ``first`` to ``first + count`` of a client, as rows of t s, x px, y px, dx, dy, buttons."""
    recorded = _recorded()
    places = np.arange(first, first + count)
    table = recorded[(places + number * APART) % len(recorded)]
    table[:, 0] = places / rate_hz
    return table
