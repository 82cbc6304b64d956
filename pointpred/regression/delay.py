"""Delayed signals: a ring of irregular samples in a flat array, for any device rate.

The ring holds a fixed number of samples. Samples closer than ``spacing`` replace each other, except that the
newest is always stored, so a fast device does not fill the ring sooner. Between two samples a signal is
linear. All zeros: an empty ring.
"""

from __future__ import annotations

from pointpred.compiled import law, layout
from pointpred.records import FloatArray

PER_DELAY = 64
"""Most samples stored per delay."""

# Relative to `at`: number of samples, place of the newest; then the samples, each (t, values).
COUNT, NEWEST, SAMPLES = 0, 1, 2


@layout
def capacity(delays: int) -> int:
    """Samples needed to span a number of delays: the two newest and one on each side."""
    return delays * PER_DELAY + 4


@layout
def states(width: int, samples: int) -> int:
    """Floats of a ring for that many samples of ``width`` values."""
    return SAMPLES + samples * (1 + width)


@law
def push(memory: FloatArray, at: int, width: int, samples: int, spacing: float, t: float) -> int:
    """Make room for the sample at ``t`` (never before the last) and return where its first value goes."""
    size = 1 + width
    count, newest = int(memory[at + COUNT]), int(memory[at + NEWEST])
    keep = count > 0
    if keep:
        last_t = memory[at + SAMPLES + newest * size]
        keep = t > last_t
        if keep and count > 1:
            before = newest - 1 if newest > 0 else samples - 1
            keep = last_t - memory[at + SAMPLES + before * size] >= spacing
    if keep:
        newest = newest + 1 if newest + 1 < samples else 0
    if keep or count == 0:
        memory[at + COUNT] = min(count + 1, samples)
        memory[at + NEWEST] = newest
    memory[at + SAMPLES + newest * size] = t
    return at + SAMPLES + newest * size + 1


@law
def find(memory: FloatArray, at: int, width: int, samples: int, t: float) -> tuple[bool, int, int, float]:
    """The samples around ``t``: (history long enough?, place before, place after, weight of after).

    A value j is then ``memory[before + j] + share * (memory[after + j] - memory[before + j])``. A time
    after the newest sample gives the newest.
    """
    size = 1 + width
    count, newest = int(memory[at + COUNT]), int(memory[at + NEWEST])
    last = at + SAMPLES + newest * size
    if count > 0 and t >= memory[last]:
        return True, last + 1, last + 1, 0.0
    oldest = newest - count + 1
    if oldest < 0:
        oldest += samples
    if count == 0 or t < memory[at + SAMPLES + oldest * size]:
        return False, at, at, 0.0
    low, high = 0, count - 1  # the sample `low` is not after t, the sample `high` is
    before, after = at + SAMPLES + oldest * size, last
    while high - low > 1:
        middle = (low + high) // 2
        row = oldest + middle
        if row >= samples:
            row -= samples
        place = at + SAMPLES + row * size
        if memory[place] <= t:
            low, before = middle, place
        else:
            high, after = middle, place
    return True, before + 1, after + 1, (t - memory[before]) / (memory[after] - memory[before])
