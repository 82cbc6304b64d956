"""Many trials, some at a time: ranges of whole trials, worked on in threads."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

CHUNK_EVENTS = 32_768
"""Events in one call: enough to forget the call, few enough for the processor's cache."""

Answer = TypeVar("Answer")


def spans(offsets: NDArray[np.int64]) -> list[tuple[int, int]]:
    """Ranges (first, stop) of whole trials with at most CHUNK_EVENTS events; a longer trial stands alone.

    >>> spans(np.array([0, 20_000, 30_000, 40_000, 90_000]))
    [(0, 2), (2, 3), (3, 4)]
    """
    found, first = [], 0
    while first < len(offsets) - 1:
        reach = offsets[first] + CHUNK_EVENTS
        stop = max(first + 1, int(np.searchsorted(offsets, reach, side="right")) - 1)
        found.append((first, stop))
        first = stop
    return found


def in_threads(
    work: Callable[[int, int], Answer], offsets: NDArray[np.int64], threads: int | None
) -> Iterator[Answer]:
    """The answers of ``work(first, stop)`` for each span, in order; one thread a processor unless given."""
    with ThreadPoolExecutor(max(1, os.cpu_count() or 1 if threads is None else threads)) as pool:
        yield from pool.map(lambda span: work(*span), spans(offsets))
