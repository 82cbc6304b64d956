"""Frames that wait for the compiler count against the limits at the time they came."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from typing import Any

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Limits
from pointpred.server.connection import Connection
from pointpred.server.sessions.pointing import PointingSession
from tests.server.fake_socket import FakeSocket
from tests.server.hurried import HurriedLoop

HELLO = '{"type":"hello","version":1,"predictor":"hold"}'
EVENT = '{"type":"events","events":[[%d,5,6,null,null,0]]}'
FRAMES = [HELLO, *(EVENT % i for i in range(1, 9))]


async def said(most: int) -> tuple[PointingSession, Connection]:
    """A session whose hello waits until all its frames have come, one a second."""
    loop = asyncio.get_running_loop()
    compiled = asyncio.Event()

    def write(frame: Frame) -> None:
        if session.close is not None or "8.0" in str(frame):
            socket.there.disconnect(None)

    def come() -> None:
        for place, text in enumerate(FRAMES):
            loop.call_later(1.0 * place, lambda text=text: socket.there.receive([text]))
        loop.call_later(60.0, compiled.set)

    async def wait() -> None:
        await compiled.wait()

    session, socket = PointingSession("early", Limits(max_events_per_s=most), loop.time()), FakeSocket(write)
    session.waits_for_compiler = True
    socket.on_attach = come
    talk = Connection(
        session,
        socket,
        lambda delay: None,
        prepare=lambda frame: wait() if frame == HELLO and not compiled.is_set() else None,
    )
    await talk.run()
    return session, talk


def in_no_time(talk: Coroutine[Any, Any, tuple[PointingSession, Connection]]) -> Any:
    with asyncio.Runner(loop_factory=HurriedLoop) as runner:
        return runner.run(talk)


def test_frames_that_waited_are_not_a_burst() -> None:
    session, talk = in_no_time(said(1))
    assert session.refusals == {}
    assert talk.frames == len(FRAMES)


def test_waiting_is_not_silence() -> None:
    session = PointingSession("early", Limits(), 0.0)
    session.waits_for_compiler = True
    session.tick(300.0)
    session.waits_for_compiler = False
    session.receive(HELLO, 1.0)
    session.receive(EVENT % 1, 2.0)
    session.tick(301.0)
    assert session.close is None
