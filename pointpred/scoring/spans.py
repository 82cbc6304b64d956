"""Many trials, some at a time: ranges of whole trials, worked on in threads."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

SPAN_EVENTS = 32_768
"""Events in one call: enough to forget the call, few enough for the processor's cache."""

Answer = TypeVar("Answer")
Item = TypeVar("Item")


def spans(offsets: NDArray[np.int64]) -> list[tuple[int, int]]:
    """Ranges (first, stop) of whole trials with at most SPAN_EVENTS events; a longer trial stands alone.

    >>> spans(np.array([0, 20_000, 30_000, 40_000, 90_000]))
    [(0, 2), (2, 3), (3, 4)]
    """
    ranges, first = [], 0
    while first < len(offsets) - 1:
        reach = offsets[first] + SPAN_EVENTS
        stop = max(first + 1, int(np.searchsorted(offsets, reach, side="right")) - 1)
        ranges.append((first, stop))
        first = stop
    return ranges


def users(names: Sequence[str], offsets: NDArray[np.int64]) -> list[list[tuple[int, int]]]:
    """The trials of each user in order, as ranges like those of ``spans``; users as they first appear.

    >>> users(["ann", "ann", "bob", "ann"], np.array([0, 10, 20, 30, 40]))
    [[(0, 2), (3, 4)], [(2, 3)]]
    """
    ranges: dict[str, list[tuple[int, int]]] = {}
    for k, name in enumerate(names):
        mine = ranges.setdefault(name, [])
        if mine and mine[-1][1] == k and offsets[k + 1] - offsets[mine[-1][0]] <= SPAN_EVENTS:
            mine[-1] = (mine[-1][0], k + 1)
        else:
            mine.append((k, k + 1))
    return list(ranges.values())


def in_threads(
    work: Callable[[int, int], Answer], offsets: NDArray[np.int64], threads: int | None
) -> Iterator[Answer]:
    """The answers of ``work(first, stop)`` for each span, in order; one thread a processor unless given."""
    yield from each_in_threads(lambda span: work(*span), spans(offsets), threads)


def each_in_threads(
    work: Callable[[Item], Answer], items: Iterable[Item], threads: int | None
) -> Iterator[Answer]:
    """The answers of ``work(item)``, in order; a thread a processor unless given, one is the caller's."""
    if threads == 1:
        yield from map(work, items)  # a pool of one costs more than a short trial
        return
    with ThreadPoolExecutor(max(1, os.cpu_count() or 1 if threads is None else threads)) as pool:
        yield from pool.map(work, items)
