"""Where the cursor of macOS is: Quartz event services, through pyobjc. Never tried on a real machine."""

from __future__ import annotations

from typing import Any

from pointpred.devices.cursor.buttons import mask_of
from pointpred.devices.hidraw.nodes import BROWSER
from pointpred.errors import SourceError
from pointpred.extras import install_command

NUMBERS = (0, 1, 2, 3, 4)
"""Left, right, middle, and the two side buttons, as Quartz counts them."""
POINTS = (
    "the cursor of macOS in points, which are one or two px of the screen, from the main screen's corner; "
    "no counts are known"
)


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
