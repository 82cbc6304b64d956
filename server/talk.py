"""One connection: frames from the socket into a session, its answers back, until either side ends it."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, MutableMapping
from typing import Any, Protocol

from pointpred.server.outbox import Outbox
from pointpred.server.session import Close

Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]

TICK_S = 1.0
"""How often a session is told that time passes."""
STUCK_S = 10.0
"""A client that has not read for so long, with answers waiting, is given up."""


class Speaker(Protocol):
    """What a connection needs of a session."""

    outbox: Outbox
    close: Close | None

    def receive(self, frame: str | bytes, now: float) -> None:
        """Take in one frame."""

    def tick(self, now: float) -> None:
        """Notice that time has passed."""

    def lose(self) -> None:
        """The connection is gone."""


class Talk:
    """Runs a session over one accepted WebSocket.

    Receiving and sending are two tasks, so that a client that does not read holds up its answers only: they
    wait in the session's outbox, where predictions give way to newer ones.
    """

    def __init__(
        self, session: Speaker, receive: Receive, send: Send, delayed: Callable[[float], None]
    ) -> None:
        """``delayed`` is told the seconds from a frame's arrival to its answer on the socket."""
        self.session = session
        self._receive = receive
        self._send = send
        self._delayed = delayed
        self._wake = asyncio.Event()
        self._arrived = 0.0
        self._sending_since: float | None = None
        self._loop = asyncio.get_running_loop()

    async def run(self) -> None:
        """Talk until the session closes or the connection is lost."""
        tasks = [
            self._loop.create_task(part()) for part in (self._take_frames, self._send_answers, self._tick)
        ]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            for task in tasks:
                task.cancel()
            ended = await asyncio.gather(*tasks, return_exceptions=True)
            self.session.lose()
        for result in ended:
            if isinstance(result, Exception):
                raise result

    def wake(self) -> None:
        """There may be something to send."""
        self._wake.set()

    async def _take_frames(self) -> None:
        """Ends when the connection is lost."""
        session, loop = self.session, self._loop
        while True:
            message = await self._receive()
            if message["type"] == "websocket.disconnect":
                return
            frame = message.get("bytes")
            self._arrived = loop.time()
            session.receive(message["text"] if frame is None else frame, self._arrived)
            self._wake.set()

    async def _send_answers(self) -> None:
        """Ends when the session has closed and all is said."""
        session, send, wake, loop = self.session, self._send, self._wake, self._loop
        while True:
            await wake.wait()
            wake.clear()
            self._sending_since = loop.time()
            while session.outbox:
                arrived = self._arrived
                for frame in session.outbox.take():
                    kind = "bytes" if isinstance(frame, bytes) else "text"
                    await send({"type": "websocket.send", kind: frame})
                self._delayed(loop.time() - arrived)
            self._sending_since = None
            if (close := session.close) is not None:
                await send({"type": "websocket.close", "code": close.code, "reason": close.reason})
                return

    async def _tick(self) -> None:
        """Ends when the client has not read for too long."""
        while self._sending_since is None or self._loop.time() - self._sending_since < STUCK_S:
            await asyncio.sleep(TICK_S)
            self.session.tick(self._loop.time())
            self._wake.set()
