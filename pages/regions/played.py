"""Movements played to a session of the service, without a socket and over one, with given coefficients."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import msgspec
import numpy as np

from pointpred import EventColumns, Pipeline, PredictionColumns
from pointpred.client import connect
from pointpred.protocol.client_messages import Device, Hello, Reset, Screen
from pointpred.protocol.frames import event_frames, packable, row_of_prediction
from pointpred.protocol.packed import unpack_predictions
from pointpred.protocol.server_messages import PredictionMessage, encode
from pointpred_server.access import HostRule
from pointpred_server.listening import listen, make_server
from pointpred_server.service import Service
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.settings import Settings

SETTINGS = Settings(max_events_per_s=10**8)
WARM_S = 600.0
PAUSE_S = 0.004
"""Before each movement over a socket: a service takes only so many messages a second."""


class Known(PointingSession):
    """A session that predicts with a pipeline it is given, whatever the client's hello asks for."""

    pipeline: Pipeline

    def receive(self, frame: str | bytes, now: float) -> None:
        """The same, and the pipeline is put in its place as soon as there is a stream."""
        greeted = self.stream is not None
        super().receive(frame, now)
        if self.stream is not None and not greeted:
            self.stream.pipeline = self.pipeline.fresh()


class KnownService(Service):
    """Opens such sessions; ``pipeline`` is that of the next one."""

    pipeline: Pipeline

    def open_session(self, now: float) -> PointingSession:
        """A session with the pipeline."""
        session = super().open_session(now)
        session.__class__ = Known
        assert isinstance(session, Known)
        session.pipeline = self.pipeline
        return session


def hello_of(name: str, events: EventColumns, resolution: dict[str, float | None]) -> Hello:
    """The hello of a client: one prediction an event, packed where records can hold the events."""
    cpi, dpi = resolution["cpi"], resolution["dpi"]
    return Hello(
        1,
        name,
        device=None if cpi is None else Device(cpi=cpi),
        screen=None if dpi is None else Screen(dpi=dpi),
        reply="event",
        encoding="binary" if packable(events) else "json",
    )


def in_session(
    pipeline: Pipeline, hello: Hello, movements: list[EventColumns]
) -> Iterator[PredictionColumns]:
    """The answers to movements one after another, each decoded from the frames of a session."""
    session = Known("session", SETTINGS.limits, 0.0)
    session.pipeline = pipeline
    session.receive(encode(hello).decode(), 0.0)
    session.outbox.take()
    for second, events in enumerate(movements, 1):  # a service takes only so many messages a second
        session.receive(encode(Reset()).decode(), float(second))
        rows: list[list[float]] = []
        for frame, _ in event_frames(events, hello.encoding, SETTINGS.limits):
            session.receive(frame, float(second))
            for answer in session.outbox.take():
                rows += rows_of(answer)
        yield PredictionColumns(np.array(rows, dtype=np.float64).reshape(-1, len(PredictionColumns.names)))


def rows_of(answer: str | bytes) -> list[list[float]]:
    """A frame of predictions as rows of ``PredictionColumns``."""
    if isinstance(answer, bytes):
        return unpack_predictions(answer)
    return [row_of_prediction(msgspec.json.decode(answer, type=PredictionMessage))]


def over_socket(url: str, hello: Hello, movements: list[EventColumns]) -> Iterator[PredictionColumns]:
    """The same answers from a service, by the Python client."""
    settings: dict[str, Any] = {"device": hello.device, "screen": hello.screen}
    settings = {name: msgspec.to_builtins(value) for name, value in settings.items() if value is not None}
    with connect(
        url, predictor=hello.predictor, reply="event", encoding=hello.encoding, timeout_s=WARM_S, **settings
    ) as connection:
        for events in movements:
            time.sleep(PAUSE_S)
            connection.reset()
            connection.send(events)
            yield connection.columns()


@contextmanager
def served() -> Iterator[tuple[KnownService, str]]:
    """A service of this process on a free port of loopback, and its address."""
    service, opened, up = KnownService(SETTINGS), listen("127.0.0.1", 0), threading.Event()
    server = make_server(HostRule(), service, up.set)
    thread = threading.Thread(target=server.run, args=([opened],))
    thread.start()
    try:
        if not up.wait(WARM_S):
            raise SystemExit("the service did not start")
        yield service, f"http://127.0.0.1:{opened.getsockname()[1]}"
    finally:
        server.should_exit = True
        thread.join()
        opened.close()
