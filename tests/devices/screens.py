"""A screen of its own for a test: Xvfb, with xdotool as the hand of its cursor."""

from __future__ import annotations

import os
import shutil
import subprocess
from types import TracebackType
from typing import Self

WIDTH, HEIGHT = 1920, 1080
PATIENCE_S = 60.0
NOBODYS = ":59000"
"""A display that is never there; one that has just ended may be, as another test's that got its number."""


def missing() -> str | None:
    """Why there can be no such screen here, or ``None``."""
    absent = [name for name in ("Xvfb", "xdotool") if shutil.which(name) is None]
    return f"not installed: {', '.join(absent)}" if absent else None


class Screen:
    """An X11 server without a screen; ``name`` is its display."""

    def __enter__(self) -> Self:
        reading, writing = os.pipe()
        words = [
            "Xvfb",
            "-displayfd",
            str(writing),
            "-screen",
            "0",
            f"{WIDTH}x{HEIGHT}x24",
            "-nolisten",
            "tcp",
        ]
        self._server = subprocess.Popen(words, pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as told:
            self.name = f":{int(told.readline())}"
        environment = os.environ | {"DISPLAY": self.name}
        pipe = subprocess.PIPE
        self._hand = subprocess.Popen(["xdotool", "-"], stdin=pipe, stdout=pipe, env=environment, text=True)
        return self

    def place(self, x: float, y: float) -> tuple[int, int]:
        """Send the cursor to a place and wait until xdotool finds it there, or somewhere."""
        self._say(f"mousemove {x:.0f} {y:.0f} getmouselocation")
        assert self._hand.stdout
        at = dict(word.split(":") for word in self._hand.stdout.readline().split())
        return int(at["x"]), int(at["y"])

    def _say(self, command: str) -> None:
        assert self._hand.stdin
        self._hand.stdin.write(command + "\n")
        self._hand.stdin.flush()

    def stop(self) -> None:
        """End the server, as when a session ends."""
        self._server.terminate()
        self._server.wait(PATIENCE_S)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._server.poll() is None:
            self._hand.communicate(timeout=PATIENCE_S)
            self.stop()
        else:
            self._hand.kill()
            self._hand.communicate(timeout=PATIENCE_S)
