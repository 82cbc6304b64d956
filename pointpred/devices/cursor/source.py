"""The cursor of the screen on any system, and a source that follows it without a device."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Protocol, Self

from pointpred.devices.cursor_paths import PositionReport
from pointpred.devices.reader import ReaderSource
from pointpred.devices.source import MOST_WAITING, DeviceInfo
from pointpred.errors import ParameterError, SourceError
from pointpred.records import PointerEvent

RATE_HZ, FASTEST_HZ = 250.0, 1000.0
NAME = "cursor"
"""The name of the cursor where a device is named."""
UNTRIED = {"win32", "cygwin", "darwin"}
"""Systems on which this is untested on real machines."""


class Cursor(Protocol):
    """A cursor whose position can be read."""

    def position(self) -> tuple[float, float]:
        """The cursor's place now, px from the left and from the top."""
        ...


class SystemCursor(Cursor, Protocol):
    """A cursor of a whole screen, with its buttons; ``words`` says what a px of it is.

    ``size`` of the screen in these px. ``position`` raises SourceError where it can no longer be read.
    """

    words: str
    size: tuple[int, int]

    def buttons(self) -> int:
        """Buttons pressed now, as in ``PointerEvent``."""
        ...

    def close(self) -> None:
        """Close the connection to the screen; may be called twice."""
        ...


class CursorSource(ReaderSource):
    """A ``DeviceSource`` that looks at the screen's cursor ``rate_hz`` times a second, on its own thread.

    Assumes that a look takes less than its share of the time. A look that finds place and buttons as before
    reports nothing. What happens between two looks is not seen: a click shorter than 1 / ``rate_hz``, and
    how the cursor came from one place to the next. Times are those of the looks, not of the mouse.

    Parameters: ``open_cursor`` opens the cursor; ``rate_hz`` in (0, 1000]; ``most`` reports wait, then the
    oldest goes first. Memory: the queue. Raises ParameterError; entering raises SourceError with what to do
    next, ``take`` where the cursor can no longer be read.
    """

    name = "the screen's cursor"
    path = NAME
    plugged = True
    unreadable = resynchronised = 0

    def __init__(
        self,
        open_cursor: Callable[[], SystemCursor],
        *,
        rate_hz: float = RATE_HZ,
        most: int = MOST_WAITING,
        clock: Callable[[], float] = time.perf_counter,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        if not 0.0 < rate_hz <= FASTEST_HZ:
            raise ParameterError(f"rate_hz must lie in (0, {FASTEST_HZ:g}] Hz, received {rate_hz!r}")
        self.rate_hz = rate_hz
        self.clock = f"this computer's monotonic clock, at each of {rate_hz:g} looks a second"
        self._open, self._now, self._sleep = open_cursor, clock, sleep
        super().__init__(most)

    @property
    def words(self) -> str:
        """The unit of the positions; known once open."""
        return self.cursor.words

    def __enter__(self) -> Self:
        self._check_unused()
        self.cursor = self._open()
        try:
            self._before = (*self.cursor.position(), self.cursor.buttons())
        except SourceError:
            self.cursor.close()
            raise
        self._start()
        return self

    def _close_device(self) -> None:
        self.cursor.close()

    def _read_all(self) -> None:
        """From the thread's start on it alone uses the cursor."""
        period_s, due = 1.0 / self.rate_hz, self._now()
        while not self._stopping.is_set():
            due = max(due + period_s, self._now())  # looks that were missed are not made up for
            self._sleep(max(due - self._now(), 0.0))
            x, y = self.cursor.position()
            look, t = (x, y, self.cursor.buttons()), self._now()
            if look != self._before:
                dx, dy = x - self._before[0], y - self._before[1]
                event = PointerEvent(t, x, y, buttons=look[2])
                self._queue.put(PositionReport(t, dx, dy, look[2], event=event))
                self._before = look


def system_cursor(display: str | None = None) -> SystemCursor:
    """The cursor of this system, or of an X11 display; raises SourceError where it cannot be read."""
    if sys.platform in ("win32", "cygwin"):
        from pointpred.devices.cursor.windows import WindowsCursor

        return WindowsCursor()
    if sys.platform == "darwin":
        from pointpred.devices.cursor.macos import MacCursor

        return MacCursor()
    from pointpred.devices.cursor.x11 import ScreenCursor

    return ScreenCursor(display)


def cursor_info() -> DeviceInfo:
    """The cursor as one of the devices of this system, tried."""
    note = ", untested on this platform" if sys.platform in UNTRIED else ""
    name = f"{CursorSource.name}, looked at {RATE_HZ:g} times a second{note}"
    try:
        system_cursor().close()
    except SourceError as error:
        return DeviceInfo(NAME, name, "cursor", False, "it cannot be read", str(error))
    return DeviceInfo(NAME, name, "cursor", True)
