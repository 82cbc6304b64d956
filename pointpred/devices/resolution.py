"""How many counts a device makes of an inch: measured with a ruler."""

from __future__ import annotations

import time
from collections.abc import Callable
from math import hypot

import msgspec

from pointpred.devices.source import DeviceSource
from pointpred.errors import SourceError

CM_PER_INCH = 2.54
LEAST_COUNTS = 100.0
"""Less is a hand on its way to the ruler."""
BENT = 1.1
"""A way this much longer than the straight line between its ends was no straight move."""


class Resolution(msgspec.Struct, frozen=True):
    """Counts over a known way: ``cpi`` from the line between its ends, ``bent`` the way over that line."""

    cpi: float
    counts: float
    bent: float

    @property
    def straight(self) -> bool:
        """Whether the way was one straight move."""
        return self.bent < BENT


def measure(
    source: DeviceSource,
    distance_cm: float = 10.0,
    *,
    still_s: float = 1.0,
    patience_s: float = 60.0,
    clock: Callable[[], float] = time.monotonic,
) -> Resolution:
    """Counts per inch from one move over a known way, which ends when the device holds still.

    Assumes one straight move and a device that reports in proportion: acceleration inside the device spoils
    it. A hand is off by some 3 % over 10 cm. cpi = 2.54 |sum of counts| / distance_cm. Takes every report
    that comes meanwhile. Raises SourceError where nothing moved within ``patience_s``.

    >>> from types import SimpleNamespace
    >>> from pointpred.devices.source import Report
    >>> looks = iter([[Report(0.0, 1000, 0)], [Report(0.1, 575, 0)], []])
    >>> moments = iter([0.0, 0.1, 0.2, 1.5])
    >>> source = SimpleNamespace(take=lambda timeout_s: next(looks))
    >>> round(measure(source, 4.0, clock=lambda: next(moments)).cpi, 1)
    1000.1
    """
    begun = moved = clock()
    x = y = way = 0.0
    while True:
        reports = source.take(0.1)
        now = clock()
        for report in reports:
            x, y, way = x + report.dx, y + report.dy, way + hypot(report.dx, report.dy)
        if any(report.dx or report.dy for report in reports):
            moved = now
        counts = hypot(x, y)
        if counts >= LEAST_COUNTS and now - moved >= still_s:
            return Resolution(CM_PER_INCH * counts / distance_cm, counts, way / counts)
        if now - begun > patience_s:
            raise SourceError(
                f"no move of {distance_cm:g} cm within {patience_s:g} s ({counts:.0f} counts came); "
                "give the resolution with --cpi: it is printed on the mouse's box"
            )
