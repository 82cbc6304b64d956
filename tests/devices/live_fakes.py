"""A mouse that reports what a test tells it to, for sessions that need no device."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence

import numpy as np

from pointpred.devices.source import BoundedQueue, ClosedOnExit, PlaceReport, PlaceReports, Report
from pointpred.devices.surface import Axis, Place, Surface

MONOTONIC = "a test's own, monotonic clock"
SURFACE = Surface(Axis(0, 4000, 508.0), Axis(0, 2000, 254.0))


def touches(*starts: tuple[float, float], began: float = 1.0) -> list[PlaceReport]:
    """A finger that is put down at each place, in shares, drawn to the right for 0.2 s and lifted, at 200 Hz.

    The next one touches 50 ms later.
    """
    made, reports, t = PlaceReports(SURFACE), [], began
    for x, y in starts:
        for at in range(41):
            reports.append(made.report(t, Place(x + 0.2 * (at / 40) ** 2, y, 1, at == 0)))
            t += 0.005
        reports.append(made.report(t, Place(x + 0.2, y, 0, False)))
        t += 0.05
    return reports


class FakeMouse(ClosedOnExit):
    """A device source whose reports a test puts in."""

    name = "a made-up mouse"
    path = "/dev/nowhere"

    def __init__(self, reports: Iterable[Report] = (), clock: str = MONOTONIC) -> None:
        self.clock = clock
        self.plugged = True
        self.unreadable = self.resynchronised = 0
        self.closed = False
        self._queue = BoundedQueue()
        for report in reports:
            self._queue.put(report)

    @property
    def lost(self) -> int:
        return self._queue.lost

    def put(self, reports: Iterable[Report]) -> None:
        for report in reports:
            self._queue.put(report)

    def take(self, timeout_s: float) -> list[Report]:
        return self._queue.take(timeout_s)

    def close(self) -> None:
        self.closed = True
        self._queue.close()


def reach(
    begin: float, distance: Sequence[float], seconds: float = 0.5, rate_hz: float = 1000.0
) -> list[Report]:
    """A minimum-jerk movement in whole counts, and a click at its end."""
    t = np.arange(0.0, seconds, 1.0 / rate_hz)
    u = t / seconds
    way = 10 * u**3 - 15 * u**4 + 6 * u**5
    x, y = (np.diff(np.round(way * part), prepend=0.0) for part in distance)
    reports = [Report(begin + s, float(dx), float(dy)) for s, dx, dy in zip(t.tolist(), x, y, strict=True)]
    end = begin + seconds
    return [*reports, Report(end, 0.0, 0.0, 1), Report(end + 0.08, 0.0, 0.0, 0)]


def now() -> float:
    """The clock that fakes are stamped by where delays are looked at."""
    return time.monotonic()
