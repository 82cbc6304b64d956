"""The cursor of the screen on any system, and a source that follows it without a device."""

from __future__ import annotations

import ctypes
import os
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, Protocol, Self

from pointpred.devices.cursor_paths import PositionReport, ReadableCursor
from pointpred.devices.source import (
    BROWSER,
    BUTTON_NAMES,
    MOST_WAITING,
    ClosedOnExit,
    DeviceInfo,
    ReaderSource,
)
from pointpred.errors import ParameterError, SourceError
from pointpred.extras import install_command
from pointpred.records import PointerEvent

RATE_HZ, FASTEST_HZ = 250.0, 1000.0
NAME = "cursor"
"""The name of the cursor where a device is named."""
UNTRIED = {"win32", "cygwin", "darwin"}
"""Systems on which this is untested on real machines."""

# X11.
OTHERWISE = (
    "predict in motor space, or give the transfer function that moves the cursor (identified before, on a "
    "screen that can be read)"
)
LEFT, MIDDLE, RIGHT = 1 << 8, 1 << 9, 1 << 10
"""Button1Mask to Button3Mask of the core protocol."""

# Windows.
KEYS = (0x01, 0x02, 0x04, 0x05, 0x06)
"""Virtual keys of the left, right, middle, first and second side button."""
PRESSED = 0x8000
SWAPPED, WIDTH, HEIGHT = 23, 0, 1
"""What ``GetSystemMetrics`` is asked for: whether the buttons are swapped, and the main screen's px."""
PER_MONITOR_V2, PER_MONITOR = -4, 2
"""DPI_AWARENESS_CONTEXT_PER_MONITOR_AWARE_V2, and how ``GetAwarenessFromDpiAwarenessContext`` names it."""
PIXELS = "the cursor of Windows in px of its screen, from the main screen's corner; no counts are known"
SCALED = (
    "the cursor of Windows in px that Windows scales for this process, from the main screen's corner; "
    "no counts are known"
)

# macOS.
NUMBERS = (0, 1, 2, 3, 4)
"""Left, right, middle, and the two side buttons, as Quartz counts them."""
POINTS = (
    "the cursor of macOS in points, which are one or two px of the screen, from the main screen's corner; "
    "no counts are known"
)


class SystemCursor(ReadableCursor, Protocol):
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
        return WindowsCursor()
    if sys.platform == "darwin":
        return MacCursor()
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


class ScreenCursor(ClosedOnExit):
    """The cursor of an X11 screen, asked for anew at each call: one round trip to the server.

    Assumes X11. Under Wayland a program hears of the cursor only while it is over a window of its own kind:
    the place would stand still elsewhere, so without a named ``display`` such a session is refused.
    The server moves its cursor a little after the device reported; ``Pairing`` allows for that.

    Parameters: ``display`` such as ``":0"``; ``None`` takes the environment's. One thread at a time.
    Raises SourceError, which says what to do next, when opening, and from ``position`` once the server is
    gone.
    """

    words = "the cursor of the X11 screen in px; no counts are known"

    def __init__(self, display: str | None = None) -> None:
        if display is None and (
            os.environ.get("WAYLAND_DISPLAY") or os.environ.get("XDG_SESSION_TYPE", "").lower() == "wayland"
        ):
            raise SourceError(
                "the screen's cursor cannot be followed under Wayland: it is told only over X11 windows; "
                f"log in to an X11 session, or {OTHERWISE}."
            )
        self.name = display or os.environ.get("DISPLAY", "")
        if not self.name:
            raise SourceError(f"no X11 display: DISPLAY is not set; set it, or {OTHERWISE}.")
        self._display = _connect(self.name)
        screen = self._display.screen()
        self._root = screen.root
        self.size = (int(screen.width_in_pixels), int(screen.height_in_pixels))
        self._mask = 0

    def position(self) -> tuple[float, float]:
        """The cursor's place now, px from the left and from the top of the screen. Raises SourceError."""
        from Xlib.error import ConnectionClosedError

        try:
            pointer = self._root.query_pointer()
        except (ConnectionClosedError, OSError) as error:
            raise SourceError(f"the X11 display {self.name} is gone ({error}); {OTHERWISE}.") from error
        self._mask = int(pointer.mask)
        return float(pointer.root_x), float(pointer.root_y)

    def buttons(self) -> int:
        """Left, right and middle as in ``PointerEvent``, as they were when ``position`` was asked last."""
        return mask_of([bool(self._mask & bit) for bit in (LEFT, RIGHT, MIDDLE)])

    def close(self) -> None:
        """Leave the server; may be called twice, and when the server is gone."""
        from Xlib.error import ConnectionClosedError

        try:
            self._display.close()
        except (ConnectionClosedError, OSError):
            return


def _connect(name: str) -> Any:
    """A connection to a display; raises SourceError."""
    try:
        from Xlib import display, error
    except ImportError as missing:
        raise SourceError(
            f"reading the cursor needs python-xlib: {install_command('live')}; or {OTHERWISE}."
        ) from missing
    try:
        return display.Display(name)
    except (error.DisplayError, error.XauthError, error.ConnectionClosedError, OSError) as refused:
        raise SourceError(f"the X11 display {name} cannot be opened ({refused}); {OTHERWISE}.") from refused


class ScreenPoint(ctypes.Structure):
    """POINT."""

    _fields_ = (("x", ctypes.c_long), ("y", ctypes.c_long))


class WindowsCursor:
    """The cursor of a Windows session: px from the left and from the top of the main screen.

    Assumes Windows 10 of 2017 or later; before, positions are those that Windows scales for the process,
    which ``words`` says. The process is made aware of each monitor's DPI. Screens to the left of the main
    one, or above, have negative places. While Windows refuses the place (the lock screen, a question for
    administrator rights) the last one is repeated, and ``refused`` counts it. No permission is needed.
    Untested on real machines.

    Raises SourceError, which says what to do next, when opening.
    """

    def __init__(self, user32: Any = None) -> None:
        self._user32 = _user32() if user32 is None else user32
        self.words = PIXELS if _aware(self._user32) else SCALED
        self.size = (int(self._metric(WIDTH)), int(self._metric(HEIGHT)))
        self.refused = 0
        self._point = ScreenPoint()
        if not self._user32.GetCursorPos(ctypes.byref(self._point)):
            raise SourceError(f"Windows does not tell where its cursor is; {BROWSER}.")

    def position(self) -> tuple[float, float]:
        """The cursor's place now, px from the left and from the top of the main screen."""
        if not self._user32.GetCursorPos(ctypes.byref(self._point)):
            self.refused += 1
        return float(self._point.x), float(self._point.y)

    def buttons(self) -> int:
        """Buttons pressed now. The keys are the mouse's own: where somebody swapped them, so are these."""
        left, right, *others = (bool(self._user32.GetAsyncKeyState(key) & PRESSED) for key in KEYS)
        if self._metric(SWAPPED):
            left, right = right, left
        return mask_of([left, right, *others])

    def close(self) -> None:
        """Nothing is open."""

    def _metric(self, number: int) -> int:
        return int(self._user32.GetSystemMetrics(number))


def _user32() -> Any:
    """user32.dll; raises SourceError where there is none."""
    library = getattr(ctypes, "windll", None)
    if library is None:
        raise SourceError(f"the cursor of Windows can be read on Windows only; {BROWSER}.")
    return library.user32


def _aware(user32: Any) -> bool:
    """Make positions those of the screen's own px; whether they are."""
    try:
        context = ctypes.c_void_p
        user32.SetProcessDpiAwarenessContext.argtypes = [context]
        user32.GetThreadDpiAwarenessContext.restype = context
        user32.GetAwarenessFromDpiAwarenessContext.argtypes = [context]
        user32.SetProcessDpiAwarenessContext(PER_MONITOR_V2)  # refused where the process has chosen before
        own = user32.GetThreadDpiAwarenessContext()
        return bool(user32.GetAwarenessFromDpiAwarenessContext(own) == PER_MONITOR)
    except AttributeError:  # an older Windows
        return False


class MacCursor:
    """The cursor of a macOS session: points from the left and from the top of the main screen.

    Assumes pyobjc's Quartz. ``CGEventGetLocation`` counts y downwards from the main screen's top; screens to
    its left or above it have negative places. A point is two px of a Retina screen. A position asked for like
    this is said to need no permission, unlike listening to events; where macOS gives none, that is told.
    Untested on real machines.

    Raises SourceError, which says what to do next, when opening and where macOS tells no place.
    """

    words = POINTS

    def __init__(self, quartz: Any = None) -> None:
        self._quartz = _quartz() if quartz is None else quartz
        size = self._quartz.CGDisplayBounds(self._quartz.CGMainDisplayID()).size
        self.size = (int(size.width), int(size.height))
        self.position()

    def position(self) -> tuple[float, float]:
        """The cursor's place now, points from the left and from the top of the main screen."""
        event = self._quartz.CGEventCreate(None)
        if event is None:
            raise SourceError(
                "macOS does not tell where its cursor is; allow your terminal in System Settings, Privacy & "
                f"Security, Accessibility, and start again; or {BROWSER}."
            )
        place = self._quartz.CGEventGetLocation(event)
        return float(place.x), float(place.y)

    def buttons(self) -> int:
        """Buttons pressed now."""
        state = self._quartz.kCGEventSourceStateCombinedSessionState
        return mask_of([bool(self._quartz.CGEventSourceButtonState(state, number)) for number in NUMBERS])

    def close(self) -> None:
        """Nothing is open."""


def _quartz() -> Any:
    """Pyobjc's Quartz; raises SourceError where it is not installed."""
    try:
        import Quartz
    except ImportError as missing:
        raise SourceError(
            f"reading the cursor of macOS needs pyobjc ({missing}): {install_command('live')}; or {BROWSER}."
        ) from missing
    return Quartz


def mask_of(pressed: Sequence[bool]) -> int:
    """Buttons as in ``PointerEvent`` from left, right, middle, back, forward.

    >>> mask_of([True, False, True])
    5
    """
    return sum(bit for bit, down in zip(BUTTON_NAMES, pressed, strict=False) if down)
