"""Frames that wait for the compiler count against the limits at the time they came."""

from __future__ import annotations

import asyncio
from collections.abc import MutableMapping
from typing import Any

from pointpred.protocol.server_messages import Limits
from pointpred.server.connection import Connection
from pointpred.server.receive_buffer import ReceiveBuffer
from pointpred.server.sessions.pointing import PointingSession

Message = MutableMapping[str, Any]
HELLO = '{"type":"hello","version":1,"predictor":"hold"}'
EVENT = '{"type":"events","events":[[%d,5,6,null,null,0]]}'
FRAMES = [HELLO, *(EVENT % i for i in range(1, 9))]


async def said(most: int) -> tuple[PointingSession, Connection]:
    """A session whose hello waits until all its frames have come, one a second."""
    now = asyncio.get_running_loop().time()
    came = [now - 60.0 + i for i in range(len(FRAMES))]
    frames = iter([*({"type": "websocket.receive", "text": text} for text in FRAMES)])
    times = iter(came[1:])  # the first one is what the others wait behind
    compiled, lost = asyncio.Event(), asyncio.Event()

    async def receive() -> Message:
        if (message := next(frames, None)) is None:
            compiled.set()
            await lost.wait()
            return {"type": "websocket.disconnect"}
        return message

    async def send(message: Message) -> None:
        if session.close is not None or (session.stream and EVENT and "8.0" in str(message)):
            lost.set()

    async def wait() -> None:
        await compiled.wait()

    session = PointingSession("early", Limits(max_events_per_s=most), came[0])
    early = ReceiveBuffer(
        receive, lambda message: wait() if message.get("text") == HELLO else None, lambda: next(times)
    )
    talk = Connection(session, early, send, lambda delay: None)
    async with asyncio.timeout(20):
        await talk.run()
    early.close()
    return session, talk


def test_frames_that_waited_are_not_a_burst() -> None:
    session, talk = asyncio.run(said(1))
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
