"""Reports of a mouse joined by time with the position of the screen's cursor."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Sequence
from math import hypot
from typing import Literal

from pointpred.devices.cursor.source import Cursor
from pointpred.devices.source import MOST_WAITING, Report
from pointpred.errors import ParameterError
from pointpred.records import PointerEvent

WORDS = "the screen's cursor, paired with the counts by time"
DELAY_MOST_S = 1.0


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

    space: Literal["screen"] = "screen"
    words = WORDS

    def __init__(
        self,
        cursor: Cursor,
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
            events.append(_event(self._last, x, y))
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
            events.append(_event(report, x0 + share * (x - x0), y0 + share * (y - y0)))
        return [*events, _event(due[-1], x, y)]

    def _correct(self, x: float, y: float) -> list[PointerEvent]:
        """The last report's event once more, when the cursor came to its place after it was passed on."""
        if self._last is None or self._place in (None, (x, y)):
            return []
        self.corrections += 1
        return [PointerEvent(self._last.t, x, y, 0.0, 0.0, self._last.buttons)]


def _event(report: Report, x: float, y: float) -> PointerEvent:
    return PointerEvent(report.t, x, y, float(report.dx), float(report.dy), report.buttons)
