"""Where the cursor is while a device is read, and how it is known: the screen, a transfer function, or not.

A mouse reports counts and never a position; predictors need positions. Every path says in words what its
pixels mean.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Sequence
from math import hypot
from typing import Literal, Protocol

from pointpred.devices.source import MOST_WAITING, PlaceReport, Report
from pointpred.devices.surface import Scale, Surface
from pointpred.errors import EventError, ParameterError
from pointpred.records import PointerEvent
from pointpred.transfer import PixelTransfer, TransferFunction

Space = Literal["screen", "transfer", "motor"]

MOVED = "no cursor to read: the counts moved by a transfer function, from where the session began"
MOTOR = "no cursor to read: prediction in motor space, the hand's own way drawn at the screen's size"
GUESSED = "no cursor to read and no CPI: prediction in motor space, one count drawn as one px"
PAIRED = "the screen's cursor, paired with the counts by time"
DELAY_MOST_S = 1.0


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


class PlaceEvent(PointerEvent, frozen=True, kw_only=True):
    """An event of an absolute device; ``begins``: it is the first of a contact, which begins a movement."""

    begins: bool = False


class SurfacePath:
    """Places of absolute devices in px; the reports of others go to the path ``counts``, if there is one.

    The px of a surface are those of its size at ``dpi``; where that is not known, or ``whole``, its range is
    drawn over ``screen`` (width, height), else over 1920 x 1080 px. ``words`` are those of the newest report.

    >>> from pointpred.devices.source import PlaceReports
    >>> from pointpred.devices.surface import Axis, Place
    >>> reports = PlaceReports(Surface(Axis(0, 99, 254.0), Axis(0, 99, 254.0)))
    >>> SurfacePath(dpi=96.0).events([reports.report(0.5, Place(0.5, 0.25, 1, True))])
    [PlaceEvent(t=0.5, x=480.0, y=240.0, dx=None, dy=None, buttons=1, begins=True)]
    """

    def __init__(
        self,
        counts: CursorPath | None = None,
        *,
        dpi: float = 96.0,
        screen: tuple[float, float] | None = None,
        whole: bool = False,
    ) -> None:
        self.counts = counts
        self._dpi, self._screen, self._whole = dpi, screen, whole
        self._surface: Surface | None = None
        self._scale = Scale(1.0, 1.0, "")

    @property
    def space(self) -> Space:
        """What the positions are."""
        return "screen" if self.counts is None or self._surface is not None else self.counts.space

    @property
    def words(self) -> str:
        """The same for people."""
        if self._surface is not None:
            return f"the device's own, {self._scale.words}"
        return "the device's own" if self.counts is None else self.counts.words

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """An event for each place, and what the other path makes of the other reports."""
        places = [report for report in reports if isinstance(report, PlaceReport)]
        others = [report for report in reports if not isinstance(report, PlaceReport)]
        if others:
            self._surface = None
        events: list[PointerEvent] = []
        if self.counts is not None and self._surface is None and (others or not places):
            events += self.counts.events(others)
        for report in places:
            if report.surface is not self._surface:
                self._surface = report.surface
                self._scale = report.surface.scale(self._dpi, self._screen, whole=self._whole)
            x, y, buttons, begins = report.place
            x, y = x * self._scale.width, y * self._scale.height
            events.append(PlaceEvent(report.t, x, y, buttons=buttons, begins=begins))
        return sorted(events, key=lambda event: event.t) if places and others else events


class ReadableCursor(Protocol):
    """A cursor whose position can be read."""

    def position(self) -> tuple[float, float]:
        """The cursor's place now, px from the left and from the top."""
        ...


class Pairing:
    """Makes pointer events of a device's reports and the cursor of the screen it moves.

    Assumes that reports and ``clock`` count seconds on the same clock, and that this device moves the cursor.
    A cursor that anything else moves, or that the screen's edge stops, is reported as it is: the positions
    are right, the counts no longer explain them.

    The cursor is asked once a call. A look at time T shows every report up to T - ``delay_s``; the way since
    the last look is shared among the reports that it shows by the counts of each. A report later than that
    waits for the next look. When the cursor arrives only after its report was passed on, an event with that
    report's time and no counts corrects the place.

    Parameters: ``cursor``; ``delay_s`` in [0, 1], how long the server takes to move its cursor; ``most``
    reports wait, then the oldest goes on with the place seen last, counted in ``unpaired``.
    ``corrections`` counts the places corrected. Memory: the reports that wait.
    Raises ParameterError; ``events`` raises SourceError when the screen is gone.

    >>> class Still:
    ...     def position(self):
    ...         return 9.0, 0.0
    >>> pairing = Pairing(Still(), clock=lambda: 1.0)
    >>> [(e.t, e.x, e.dx) for e in pairing.events([Report(0.9, 2, 0), Report(1.0, 1, 0), Report(1.1, 1, 0)])]
    [(0.9, 9.0, 2.0), (1.0, 9.0, 1.0)]
    """

    space: Space = "screen"
    words = PAIRED

    def __init__(
        self,
        cursor: ReadableCursor,
        *,
        delay_s: float = 0.0,
        most: int = MOST_WAITING,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        if not 0.0 <= delay_s <= DELAY_MOST_S:
            raise ParameterError(f"delay_s must lie in [0, {DELAY_MOST_S:g}] s, received {delay_s!r}")
        if most < 1:
            raise ParameterError(f"most must be at least 1 report, received {most!r}")
        self.cursor, self.delay_s = cursor, delay_s
        self.unpaired = self.corrections = 0
        self._most, self._clock = most, clock
        self._waiting: deque[Report] = deque()
        self._last: Report | None = None
        self._place: tuple[float, float] | None = None

    def events(self, reports: Sequence[Report]) -> list[PointerEvent]:
        """The events that can be made now, in the order of the reports; looks at the cursor once."""
        self._waiting.extend(reports)
        before = self._clock()
        x, y = self.cursor.position()
        shown_until = 0.5 * (before + self._clock()) - self.delay_s
        due: list[Report] = []
        while self._waiting and self._waiting[0].t <= shown_until:
            due.append(self._waiting.popleft())
        events = self._share(due, x, y) if due else self._correct(x, y)
        while len(self._waiting) > self._most:
            self.unpaired += 1
            self._last = self._waiting.popleft()
            events.append(event_of(self._last, x, y))
        self._place = (x, y)
        return events

    def _share(self, due: list[Report], x: float, y: float) -> list[PointerEvent]:
        """The way since the last look, along the reports that this look shows."""
        self._last = due[-1]
        x0, y0 = self._place or (x, y)
        paths = [hypot(report.dx, report.dy) for report in due]
        whole, gone = sum(paths), 0.0
        events = []
        for report, path in zip(due[:-1], paths[:-1], strict=True):
            gone += path
            share = gone / whole if whole > 0.0 else 1.0
            events.append(event_of(report, x0 + share * (x - x0), y0 + share * (y - y0)))
        return [*events, event_of(due[-1], x, y)]

    def _correct(self, x: float, y: float) -> list[PointerEvent]:
        """The last report's event once more, when the cursor came to its place after it was passed on."""
        if self._last is None or self._place in (None, (x, y)):
            return []
        self.corrections += 1
        return [PointerEvent(self._last.t, x, y, 0.0, 0.0, self._last.buttons)]


def event_of(report: Report, x: float, y: float) -> PointerEvent:
    """A report at a place."""
    return PointerEvent(report.t, x, y, float(report.dx), float(report.dy), report.buttons)
