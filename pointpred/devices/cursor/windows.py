"""Where the cursor of Windows is: ``GetCursorPos``, asked through ctypes. Never tried on a real machine."""

from __future__ import annotations

import ctypes
from typing import Any

from pointpred.devices.cursor.buttons import mask_of
from pointpred.devices.hidraw.nodes import BROWSER
from pointpred.errors import SourceError

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


class Point(ctypes.Structure):
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
        self._point = Point()
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
