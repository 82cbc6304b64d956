"""Moments of this machine; times of events, which may be of any clock, are numbers of another type."""

from __future__ import annotations

import time
from typing import NamedTuple


class Instant(NamedTuple):
    """A moment on this machine's monotonic clock, s: only two of them have a time between them.

    >>> Instant(3.5).since(Instant(1.0))
    2.5
    """

    s: float

    def since(self, earlier: Instant) -> float:
        """Seconds since then."""
        return self.s - earlier.s

    def later(self, seconds: float) -> Instant:
        """The moment so many seconds after this one."""
        return Instant(self.s + seconds)


NEVER = Instant(float("-inf"))


def now() -> Instant:
    """Now, by ``time.perf_counter``: finer than ``time.monotonic`` on Windows and the same elsewhere."""
    return Instant(time.perf_counter())
