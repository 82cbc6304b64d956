"""When a worker that has ended is started again: soon at first, then later and later."""

from __future__ import annotations

FIRST_S = 0.25
LONGEST_S = 30.0
STEADY_S = 60.0
"""A worker that has run for so long is not part of a series of failures."""
MOST_FAILURES = 5
"""Failures in a row of every worker, after which the service ends: they would go on for ever."""


class Restarts:
    """The failures of one worker in a row."""

    def __init__(self) -> None:
        self.failures = 0

    def pause_s(self, lived_s: float, *, ordered: bool = False) -> float:
        """Seconds to wait before the next start, after a worker that lived for so long.

        ``ordered``: whether somebody asked it to end, which is no failure.

        >>> restarts = Restarts()
        >>> [restarts.pause_s(1.0) for _ in range(4)], restarts.pause_s(90.0)
        ([0.25, 0.5, 1.0, 2.0], 0.25)
        """
        if lived_s >= STEADY_S:
            self.failures = 0
        if ordered:
            return FIRST_S
        self.failures += 1
        return float(min(FIRST_S * 2 ** (self.failures - 1), LONGEST_S))

    @property
    def hopeless(self) -> bool:
        """Whether it has failed so often in a row that something lasting is wrong."""
        return self.failures >= MOST_FAILURES
