"""An event loop in which seconds take no time."""

from __future__ import annotations

import asyncio
import selectors


class HurriedLoop(asyncio.SelectorEventLoop):
    """Nobody waits: its clock runs on to the next thing that is due, however fast or busy the machine is."""

    def __init__(self) -> None:
        self.now = 0.0
        super().__init__(Hurry(self))

    def time(self) -> float:
        return self.now


class Hurry(selectors.DefaultSelector):
    """Takes no time to wait."""

    def __init__(self, loop: HurriedLoop) -> None:
        super().__init__()
        self.loop = loop

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        if timeout is None:
            return super().select(None)
        self.loop.now += max(timeout, 0.0)
        return super().select(0)
