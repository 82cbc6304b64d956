"""Since when the bytes that a connection reads can have waited: TCP does not say when they came."""

from __future__ import annotations

IDLE_S = 1e-3
"""Where nothing was done for so long before something is read, the event loop was waiting for it."""


class Arrivals:
    """The earliest time at which what is read now can have come, from how long the event loop was busy.

    In one turn the loop reads every socket that has something, then it asks the kernel again. What it reads
    came after it began its turn before, or, where it was waiting, just now. Both are bounds: the time is too
    early by at most one turn, and by ``IDLE_S``. What waits outside this machine, or in the buffers of a
    client that sends faster than it is read, is not seen.
    """

    def __init__(self) -> None:
        self._turn = float("nan")
        self._begun_at = self._since = self.busy_until = float("-inf")

    def since(self, now: float, turn: float) -> float:
        """The earliest time at which what is read at ``now`` can have come; seconds of one clock.

        ``turn``: a number that stays the same throughout a turn, such as the loop's own clock.
        """
        if turn != self._turn:
            self._turn = turn
            self._since = self._begun_at if now - self.busy_until < IDLE_S else now
            self._begun_at = now
        return self._since
