"""A service with a made-up mouse attached to it."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from pointpred import build
from pointpred.devices.cursor_paths import MotorPath
from pointpred.devices.source import Report
from pointpred.live.session import LiveSession
from pointpred.protocol.server_messages import Attached
from pointpred_server.cli.live_page import status_of
from pointpred_server.live_feed import LiveFeed
from pointpred_server.service import Service
from tests.devices.live_fakes import FakeMouse, reach
from tests.server.running import PATIENCE_S, Running, running

ATTACHED = Attached("a made-up mouse", "its own", "motor", "prediction in motor space", "switched", 800.0)


class Attachment:
    """A fake mouse with its session, driven by the test, and its feed."""

    def __init__(self) -> None:
        self.mouse = FakeMouse()
        self.session = LiveSession(self.mouse, MotorPath(800.0), build("switched", cpi=800.0))
        self.feed = LiveFeed(ATTACHED, lambda: status_of(self.session.state()))
        self.session.watchers.append(self.feed.take)

    def move(self, begin: float) -> int:
        """A movement all at once; returns how many events that are."""
        self.mouse.put(reach(begin, (500.0, 200.0)))
        return len(self.session.advance(0.0))


@contextmanager
def attached(**settings: Any) -> Iterator[tuple[Running, Attachment]]:
    made = Attachment()

    def attach(service: Service) -> None:
        service.live = made.feed

    with running(prepare=attach, **settings) as here:
        yield here, made


@contextmanager
def followed(made: Attachment) -> Iterator[None]:
    """Follow the mouse on a thread, as the command line does."""
    stopping = threading.Event()
    thread = threading.Thread(target=made.session.run, args=(stopping,))
    thread.start()
    try:
        yield
    finally:
        stopping.set()
        thread.join(PATIENCE_S)
        assert not thread.is_alive()


def play(made: Attachment, way: tuple[float, float], seconds: float = 0.6) -> None:
    """A movement in real time."""
    began = time.monotonic()
    for report in reach(0.0, way, seconds):
        time.sleep(max(0.0, began + report.t - time.monotonic()))
        made.mouse.put([Report(began + report.t, report.dx, report.dy, report.buttons)])
