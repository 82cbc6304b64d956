"""Where the X11 server's cursor is."""

from __future__ import annotations

import os
from typing import Any

from pointpred.devices.cursor.buttons import mask_of
from pointpred.devices.source import ClosedOnExit
from pointpred.errors import SourceError
from pointpred.extras import install_command

OTHERWISE = (
    "predict in motor space, or give the transfer function that moves the cursor (identified before, on a "
    "screen that can be read)"
)

LEFT, MIDDLE, RIGHT = 1 << 8, 1 << 9, 1 << 10
"""Button1Mask to Button3Mask of the core protocol."""


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
        if display is None and (os.environ.get("WAYLAND_DISPLAY") or _session() == "wayland"):
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


def _session() -> str:
    return os.environ.get("XDG_SESSION_TYPE", "").lower()


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
