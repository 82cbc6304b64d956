"""The kernel's stamps as seconds on the monotonic clock, and which clock they came from."""

from __future__ import annotations

import struct
import sys
from math import inf

EVIOCSCLOCKID = 0x400445A0
"""_IOW('E', 0xa0, int): the clock that stamps what this file reads."""
CLOCK_MONOTONIC = 1
APART_S = 1.0
"""A stamp further than this from the clock at the read was made after somebody had set the clock."""
MONOTONIC = "the kernel's stamps, monotonic clock"
REAL_TIME = (
    "the kernel's stamps, real-time clock (it refused the steady one): set right at the first report, and "
    "again whenever somebody sets that clock"
)


class Clock:
    """Stamps in microseconds in, seconds that never run backwards out.

    A node whose kernel refuses the monotonic clock stamps with the real-time clock, which may be set: the
    difference is taken at the first report and made smaller whenever a stamp would lie in the future, so it
    is wrong by the shortest time that a reading took; anew (``steps`` counts) when a stamp runs backwards or
    lies more than 1 s from the expected one.

    >>> clock = Clock()
    >>> clock.seconds(1_700_000_000_000_000, now=50.0), clock.seconds(1_700_000_000_008_000, now=50.0085)
    (50.0, 50.008)
    >>> clock.seconds(1_600_000_000_000_000, now=50.016), clock.steps  # somebody set the clock
    (50.016, 1)
    """

    def __init__(self) -> None:
        self.words, self.steps, self.last = REAL_TIME, 0, -inf
        self._ahead_us: int | None = None
        self._monotonic = False

    def ask(self, file: int) -> None:
        """Ask an open node for the monotonic clock."""
        self._monotonic, self._ahead_us = _granted(file), None
        self.words = MONOTONIC if self._monotonic else REAL_TIME

    def seconds(self, stamp_us: int, now: float) -> float:
        """The time of a stamp that was read at ``now`` s on the monotonic clock."""
        t = stamp_us / 1e6 if self._monotonic else self._moved(stamp_us, now)
        self.last = max(t, self.last)
        return self.last

    def _moved(self, stamp_us: int, now: float) -> float:
        """A stamp of the real-time clock on the monotonic one."""
        if self._ahead_us is not None:
            t = (stamp_us - self._ahead_us) / 1e6
            if t >= self.last and now - APART_S <= t <= now:
                return t
            self.steps += not now < t <= now + APART_S
        self._ahead_us = stamp_us - round(now * 1e6)
        return (stamp_us - self._ahead_us) / 1e6


def _granted(file: int) -> bool:
    """Whether the kernel stamps with the monotonic clock from now on."""
    if sys.platform == "win32":
        return False
    import fcntl

    try:
        fcntl.ioctl(file, EVIOCSCLOCKID, struct.pack("i", CLOCK_MONOTONIC))
    except OSError:
        return False
    return True
