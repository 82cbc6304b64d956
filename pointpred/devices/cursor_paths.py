"""Where the cursor is while a device is read, and how it is known: the screen, a transfer function, or not.

A mouse reports counts and never a position; predictors need positions. Every path says in words what its
pixels mean.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, Protocol

from pointpred.devices.source import Report
from pointpred.errors import EventError
from pointpred.records import PointerEvent
from pointpred.transfer import PixelTransfer, TransferFunction

Space = Literal["screen", "transfer", "motor"]

MOVED = "no cursor to read: the counts moved by a transfer function, from where the session began"
MOTOR = "no cursor to read: prediction in motor space, the hand's own way drawn at the screen's size"
GUESSED = "no cursor to read and no CPI: prediction in motor space, one count drawn as one px"


class CursorPath(Protocol):
    """Makes pointer events of reports; ``Pairing`` is the one for a screen's cursor."""

    @property
    def space(self) -> Space:
        """What the positions are."""

    @property
    def words(self) -> str:
        """The same for people."""

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """The events that can be made now, in the order of their times; a path may hold some back."""


class MotorPath:
    """Integrated counts: where the hand is, in px of a screen as large as its desk.

    Assumes nothing about the cursor, and says nothing about it. With ``cpi`` 1 px is 1/dpi inch of the hand;
    without, one count is one px. x += dx dpi / cpi. Memory: two floats.

    >>> path = MotorPath(cpi=960.0, dpi=96.0)
    >>> [(event.x, event.dx) for event in path.events([Report(0.0, 10, 0), Report(0.1, 20, 0)])]
    [(1.0, 10.0), (3.0, 20.0)]
    """

    space: Space = "motor"

    def __init__(self, cpi: float | None = None, dpi: float = 96.0) -> None:
        self.words = MOTOR if cpi is not None else GUESSED
        self._scale = 1.0 if cpi is None else dpi / cpi
        self._x = self._y = 0.0

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """One event for each report."""
        events = []
        for report in reports:
            self._x += self._scale * report.dx
            self._y += self._scale * report.dy
            events.append(event_of(report, self._x, self._y))
        return events


class TransferPath:
    """Counts moved by a transfer function: where the cursor would be if nothing stopped it.

    Assumes that the function is the system's own, and a screen without edges: off by what the pointer lost
    there. Memory: that of ``PixelTransfer``. A report before the last one moves nothing and is counted in
    ``refused``: its event goes on, for the pipeline to refuse.

    >>> from pointpred.transfer import ConstantGain
    >>> path = TransferPath(ConstantGain(4.0), cpi=960.0, dpi=96.0)
    >>> [event.x for event in path.events([Report(0.0, 10, 0), Report(0.1, 20, 0)])]
    [4.0, 12.0]
    """

    space: Space = "transfer"

    def __init__(self, function: TransferFunction, *, cpi: float, dpi: float = 96.0) -> None:
        self.words = MOVED
        self.refused = 0
        self._transfer = PixelTransfer(function, cpi=cpi, dpi=dpi)
        self._x = self._y = 0.0

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """One event for each report."""
        events = []
        for report in reports:
            try:
                moved = self._transfer.update((report.t, report.dx, report.dy))
            except EventError:
                self.refused += 1
                moved = (0.0, 0.0)
            self._x += moved[0]
            self._y += moved[1]
            events.append(event_of(report, self._x, self._y))
        return events


class PositionReport(Report, frozen=True, kw_only=True, gc=False):
    """Where something is. ``dx`` and ``dy`` say that it moves: counts, or px where it has no counts."""

    event: PointerEvent


class PositionPath:
    """Positions that were read as such: a followed cursor's, or a stream's. ``counts``: events have them.

    >>> PositionPath("px").events([PositionReport(0.5, 1.0, 0.0, event=PointerEvent(0.5, 8.0, 9.0))])
    [PointerEvent(t=0.5, x=8.0, y=9.0, dx=None, dy=None, buttons=0)]
    """

    space: Space = "screen"

    def __init__(self, words: str, *, counts: bool = False) -> None:
        self.words, self.counts = words, counts

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """The event of each report."""
        return [report.event for report in reports if isinstance(report, PositionReport)]


def event_of(report: Report, x: float, y: float) -> PointerEvent:
    """A report at a place."""
    return PointerEvent(report.t, x, y, float(report.dx), float(report.dy), report.buttons)
