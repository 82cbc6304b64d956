"""The attached device inside the service: from the thread that reads it to everybody who looks on."""

from __future__ import annotations

import asyncio
import threading
from collections import deque
from collections.abc import Callable, Sequence
from itertools import islice

from pointpred.events import Pair, PointerEvent, Prediction
from pointpred.protocol.client_messages import Events
from pointpred.protocol.frames import Frame
from pointpred.protocol.live_messages import Attached, Curve, Status
from pointpred.protocol.server_messages import PredictionMessage, Region, encode
from pointpred.server.live.viewer import Viewer

FRAME_S = 1 / 120
"""Viewers hear at most so often: what came meanwhile goes as one frame, with its newest prediction."""
MOST_WAITING = 1024
"""Events of one frame; of more, the oldest are left out and counted."""


class LiveFeed:
    """What an attached device says, for viewers of ``/v1/live``.

    ``take`` is called on the device's thread, everything else on the event loop. Each viewer has an outbox of
    its own: one that reads slowly gets the newest frame, and hears how many gave way.
    """

    def __init__(self, attached: Attached, status: Callable[[], Status]) -> None:
        self.attached = attached
        """What is attached; replaced whole, from any thread, where another device is followed."""
        self.status = status
        """How the reading goes; any thread may call it."""
        self.curve: Curve | None = None
        """The newest transfer function; replaced whole, from any thread."""
        self.skipped = 0
        """Events no viewer was shown because the event loop was late."""
        self._viewers: dict[Viewer, Callable[[], None]] = {}
        self._waiting: deque[Pair] = deque()
        self._lock = threading.Lock()
        self._due = False
        self._loop: asyncio.AbstractEventLoop | None = None
        self._sent_at = float("-inf")

    @property
    def watched(self) -> bool:
        """Whether somebody looks on."""
        return bool(self._viewers)

    def begin(self, loop: asyncio.AbstractEventLoop) -> None:
        """From now on viewers can be told."""
        self._loop = loop

    def join(self, viewer: Viewer, wake: Callable[[], None]) -> None:
        """Tell one more viewer; ``wake`` sends what its outbox holds."""
        self._viewers[viewer] = wake
        viewer.show(self)
        wake()

    def leave(self, viewer: Viewer) -> None:
        """Tell it no more."""
        self._viewers.pop(viewer, None)

    def take(self, pairs: Sequence[Pair]) -> None:
        """Put aside what the session made; a ``Watcher``. Does not wait."""
        if self._loop is None or not self._viewers or not pairs:
            return
        with self._lock:
            self._waiting.extend(pairs)
            while len(self._waiting) > MOST_WAITING:
                self._waiting.popleft()
                self.skipped += 1
            call, self._due = not self._due, True
        if call:
            self._soon(self._plan)

    def end(self, why: str) -> None:
        """The session has failed: say so and close; on the event loop."""
        for viewer, wake in list(self._viewers.items()):
            viewer.end("internal", why, 1011)
            wake()

    def fail(self, why: str) -> None:
        """``end`` from the device's thread."""
        self._soon(self.end, why)

    def _soon(self, call: Callable[..., None], *about: str) -> None:
        """Have something called on the event loop."""
        if self._loop is None:
            return
        try:
            self._loop.call_soon_threadsafe(call, *about)
        except RuntimeError:  # the loop has ended, and with it everybody who looked on
            self._loop = None

    def _plan(self) -> None:
        loop = asyncio.get_running_loop()
        loop.call_at(max(loop.time(), self._sent_at + FRAME_S), self._send)

    def _send(self) -> None:
        with self._lock:
            pairs, self._due = list(self._waiting), False
            self._waiting.clear()
        self._sent_at = asyncio.get_running_loop().time()
        if not pairs or not self._viewers:
            return
        frames = frames_of(pairs)
        for viewer, wake in list(self._viewers.items()):
            viewer.outbox.predict(frames, len(pairs))
            wake()


def frames_of(pairs: Sequence[Pair]) -> list[Frame]:
    """One ``events`` and one ``prediction``, the newest, as texts."""
    rows = [_row(event) for event, _ in islice(pairs, MOST_WAITING)]
    event, newest = pairs[-1]
    return [encode(Events(rows)).decode(), encode(_message(event.t, newest)).decode()]


def _row(event: PointerEvent) -> tuple[float, float, float, float | None, float | None, int]:
    return event.t, event.x, event.y, event.dx, event.dy, event.buttons


def _message(t: float, one: Prediction | None) -> PredictionMessage:
    if one is None:
        return PredictionMessage(t)
    region = Region(*one.scale, one.tail) if one.scale else None
    return PredictionMessage(one.t, one.x, one.y, region, one.phase, one.remaining_s)
