"""The counts per inch of a mouse: given, measured with a ruler, or asked for."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from math import hypot

import msgspec
import typer

from pointpred.console import remarks
from pointpred.devices.source import DeviceSource
from pointpred.errors import SourceError
from pointpred.records import CPI

DISTANCE_CM = 10.0
QUESTION = "Counts per inch of the mouse (on its box; m: measure it; -: unknown)"

CM_PER_INCH = 2.54
LEAST_COUNTS = 100.0
"""Less is a hand on its way to the ruler."""
BENT = 1.1
"""A way this much longer than the straight line between its ends was no straight move."""


def counts_per_inch(source: DeviceSource, cpi: float | None) -> float | None:
    """Counts per inch: given, or asked for where somebody can answer, and measured if they say so."""
    if cpi is None and sys.stdin.isatty() and sys.stdout.isatty():
        answer = typer.prompt(QUESTION, value_proc=_cpi)
        if answer == "m":
            return _measured(source)
        cpi = answer if isinstance(answer, float) else None
    if cpi is None:
        remarks().print("no --cpi: one count counts as one px, and speeds of the hand are guesses")
    return cpi


def _cpi(answer: str) -> float | str:
    """An answer to the question."""
    answer = answer.strip()
    if answer in ("m", "-"):
        return answer
    try:
        value = float(answer)
    except ValueError:
        raise typer.BadParameter(f"expected a number, m or -, received {answer!r}") from None
    if not CPI[0] <= value <= CPI[1]:
        raise typer.BadParameter(f"must lie in [{CPI[0]:g}, {CPI[1]:g}], received {value:g}")
    return value


def _measured(source: DeviceSource) -> float:
    remarks().print(
        f"Put the mouse against a ruler, move it {DISTANCE_CM:g} cm in a straight line, then hold it still "
        "for a second."
    )
    resolution = measure(source, DISTANCE_CM)
    remarks().print(
        f"{resolution.counts:.0f} counts over {DISTANCE_CM:g} cm: {resolution.cpi:.0f} CPI, within about 3 %"
    )
    if not resolution.straight:
        remarks().print(
            f"the path was {resolution.bent:.2f} times as long as a straight line: better measure again"
        )
    return resolution.cpi


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
