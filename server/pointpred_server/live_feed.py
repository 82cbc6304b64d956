"""The attached device inside the service: from the thread that reads it to every viewer."""

from __future__ import annotations

import asyncio
import threading
from collections import deque
from collections.abc import Callable, Sequence
from itertools import islice

from msgspec.structs import astuple

from pointpred.protocol.client_messages import Events
from pointpred.protocol.frames import Frame, prediction_text
from pointpred.protocol.server_messages import Attached, Curve, Status, encode
from pointpred.records import Pair, prediction_row
from pointpred_server.sessions.lifecycle import Session

FRAME_S = 1 / 120
"""Viewers get one frame in this time: the events since the last one, with the newest prediction."""
MOST_WAITING = 1024
"""Events of one frame; of more, the oldest are dropped and counted."""


class LiveFeed:
    """What an attached device sends, for the viewers of ``/v1/live``.

    ``take`` is called on the device's thread, everything else on the event loop. Each viewer has an outbox of
    its own: one that reads slowly gets the newest frame, and is told how many were dropped.
    """

    def __init__(self, attached: Attached, status: Callable[[], Status]) -> None:
        self.attached = attached
        """What is attached; replaced whole, from any thread, where another device is followed."""
        self.status = status
        """How the reading goes; any thread may call it."""
        self.curve: Curve | None = None
        """The newest transfer function; replaced whole, from any thread."""
        self.skipped = 0
        """Events that no viewer got because the event loop was late."""
        self._viewers: dict[Session, Callable[[], None]] = {}
        self._waiting: deque[Pair] = deque()
        self._lock = threading.Lock()
        self._due = False
        self._loop: asyncio.AbstractEventLoop | None = None
        self._sent_at = float("-inf")

    @property
    def watched(self) -> bool:
        """Whether there are viewers."""
        return bool(self._viewers)

    def start(self, loop: asyncio.AbstractEventLoop) -> None:
        """Send to viewers from now on, from this loop."""
        self._loop = loop

    def join(self, viewer: Session, wake: Callable[[], None]) -> None:
        """Send to one more viewer; ``wake`` sends what its outbox holds."""
        self._viewers[viewer] = wake

    def leave(self, viewer: Session) -> None:
        """Send nothing more to it."""
        self._viewers.pop(viewer, None)

    def take(self, pairs: Sequence[Pair]) -> None:
        """Keep events and predictions until the next frame; a ``Watcher``. Does not wait."""
        if self._loop is None or not self._viewers or not pairs:
            return
        with self._lock:
            self._waiting.extend(pairs)
            while len(self._waiting) > MOST_WAITING:
                self._waiting.popleft()
                self.skipped += 1
            call, self._due = not self._due, True
        if call:
            self._call(self._schedule)

    def end(self, reason: str) -> None:
        """The device has failed: send why, and close; on the event loop."""
        for viewer, wake in list(self._viewers.items()):
            viewer.fail("internal", reason, 1011)
            wake()

    def fail(self, reason: str) -> None:
        """``end`` from the device's thread."""
        self._call(self.end, reason)

    def _call(self, function: Callable[..., None], *arguments: str) -> None:
        """Have a function called on the event loop."""
        if self._loop is None:
            return
        try:
            self._loop.call_soon_threadsafe(function, *arguments)
        except RuntimeError:  # the loop has ended, and every viewer with it
            self._loop = None

    def _schedule(self) -> None:
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
    rows = [astuple(event)[:6] for event, _ in islice(pairs, MOST_WAITING)]
    event, newest = pairs[-1]
    return [encode(Events(rows)).decode(), prediction_text(prediction_row(newest, event.t))]
