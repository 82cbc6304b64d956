"""What every executor does."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Protocol, TypeVar

Item = TypeVar("Item")
Answer = TypeVar("Answer")

AHEAD = 2
"""Items that wait at each worker: enough that none is idle, few enough for bounded memory."""


class Executor(Protocol):
    """Calls one function for many items at once."""

    workers: int
    """How many items are worked on at once."""
    inner_threads: int
    """How many threads the function may use where there is one item only."""

    def each(self, function: Callable[[Item], Answer], items: Iterable[Item]) -> Iterator[tuple[int, Answer]]:
        """The place of each item, from 0, and its answer, as they are done: in no particular order.

        Items are taken as workers become free. The first error that the function raises is raised here; items
        that were not begun are given up then, as when the caller stops. On processes and clusters, function,
        items and answers are pickled, and ParameterError is raised where a process of a pool was killed.
        """
        ...
