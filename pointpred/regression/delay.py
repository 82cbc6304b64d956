"""Delayed signals: a ring of irregular samples (t, w, y), for any device rate.

The ring holds a fixed number of samples. Samples closer than ``spacing`` replace each other, except that the
newest is always stored, so a fast device does not fill the ring sooner. Between two samples a signal is
linear. All zeros: an empty ring.
"""

from __future__ import annotations

from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.records import FloatArray

PER_DELAY = 64
"""Most samples stored per delay."""


class Ring(Layout):
    """How many samples there are, and which is the newest; then each: its time, n values w, one value y."""

    count: float
    newest: float
    samples: Annotated[FloatArray, None]


@law
def capacity(delays: int) -> int:
    """Samples needed to span a number of delays: the two newest and one on each side."""
    return delays * PER_DELAY + 4


@law
def states(n: int, samples: int) -> int:
    """Floats of a ring for that many samples of n + 1 values."""
    return Ring.length + samples * (n + 2)


@law
def push(ring: Ring, samples: int, spacing: float, t: float, w: FloatArray, y: float) -> None:
    """Store the sample (t, w, y), never before the last."""
    n = len(w)
    size = n + 2
    count, newest = int(ring.count), int(ring.newest)
    keep = count > 0
    if keep:
        last_t = ring.samples[newest * size]
        keep = t > last_t
        if keep and count > 1:
            before = newest - 1 if newest > 0 else samples - 1
            keep = last_t - ring.samples[before * size] >= spacing
    if keep:
        newest = newest + 1 if newest + 1 < samples else 0
    if keep or count == 0:
        ring.count = min(count + 1, samples)
        ring.newest = newest
    at = newest * size
    ring.samples[at] = t
    for j in range(n):
        ring.samples[at + 1 + j] = w[j]
    ring.samples[at + 1 + n] = y


@law
def delayed(ring: Ring, samples: int, t: float, w: FloatArray) -> tuple[bool, float]:
    """Write w(t) and return y(t), on a line between the samples around ``t``: (history long enough?, y).

    A time after the newest sample gives the newest.
    """
    n = len(w)
    size = n + 2
    count, newest = int(ring.count), int(ring.newest)
    oldest = newest - count + 1
    if oldest < 0:
        oldest += samples
    before, after, share = newest * size, newest * size, 0.0
    if count == 0 or t < ring.samples[oldest * size]:
        return False, 0.0
    if t < ring.samples[after]:
        before = oldest * size
        low, high = 0, count - 1  # the sample `low` is not after t, the sample `high` is
        while high - low > 1:
            middle = (low + high) // 2
            row = oldest + middle
            if row >= samples:
                row -= samples
            if ring.samples[row * size] <= t:
                low, before = middle, row * size
            else:
                high, after = middle, row * size
        share = (t - ring.samples[before]) / (ring.samples[after] - ring.samples[before])
    for j in range(n):
        first = ring.samples[before + 1 + j]
        w[j] = first + share * (ring.samples[after + 1 + j] - first)
    first = ring.samples[before + 1 + n]
    return True, first + share * (ring.samples[after + 1 + n] - first)
