"""One connection: frames from the socket into a session, its answers back, until either side ends it."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable, Coroutine, MutableMapping
from concurrent.futures import Executor
from time import perf_counter
from typing import Any, Protocol

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Code, Score
from pointpred.server.connections.eager import begin
from pointpred.server.sessions.conversation import Close
from pointpred.server.sessions.outbox import Outbox
from pointpred.server.sessions.stream import Work
from pointpred.server.sessions.trials import Scoring

Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Coroutine[Any, Any, None]]

AT_ONCE = 32
"""Frames of one client taken in before others have their turn, however many have come at once."""
TICK_S = 1.0
"""How often a session is told that time passes."""
STUCK_S = 10.0
"""A client that has read nothing for so long, with answers waiting, is given up ..."""
LAST_S = 5.0
"""... and may read for so long why."""


class Speaker(Protocol):
    """What a connection needs of a session."""

    outbox: Outbox
    close: Close | None
    work: Scoring | Work | None

    def receive(self, frame: str | bytes, now: float) -> None:
        """Take in one frame."""

    def finish(self, found: Score | Callable[[], None]) -> None:
        """Say what came of its work."""

    def tick(self, now: float) -> None:
        """Notice that time has passed."""

    def give_up(self) -> None:
        """The client has not read for too long."""

    def end(self, code: Code, message: str, close: int) -> None:
        """End with an error."""


class Talk:
    """Runs a session over one accepted WebSocket.

    What a session says to a frame is sent as soon as the frames that came to other sessions at the same time
    have been taken in: one kind of work after another costs less than taking turns. Every frame of a burst is
    answered. Where sending would have to wait, because the client does not read, another task waits and
    sends, and frames are taken in meanwhile: their answers wait in the session's outbox, where predictions
    give way to newer ones. Work of a session is done by another thread: its next frames wait for it, other
    sessions do not. A client that sends and leaves at once has its last frames taken in as well.
    """

    def __init__(
        self,
        session: Speaker,
        receive: Receive,
        send: Send,
        delayed: Callable[[float], None],
        worker: Executor | None = None,
    ) -> None:
        """``delayed`` is told the seconds from the newest frame to its prediction handed to the socket.

        ``worker`` does the work of sessions; the loop's own where none is given.
        """
        self.session = session
        self.frames = 0
        """Frames received."""
        self._receive = receive
        self._send = send
        self._delayed = delayed
        self._worker = worker
        self._wake = asyncio.Event()
        self._arrived = 0.0
        self._due = False  # whether the loop has been asked to call _answer_soon
        self._failure: Exception | None = None
        self._sending = False  # whether the sending task is at work
        self._sent = 0  # what it has sent
        self._begun: deque[Awaitable[None] | Frame] = deque()  # what the sending task is to finish first
        self._predicted: float | None = None  # when the frame came whose prediction is among these
        self._loop = asyncio.get_running_loop()

    async def run(self) -> None:
        """Talk until the session closes or the connection is lost; raises what broke."""
        tasks = [
            self._loop.create_task(part()) for part in (self._take_frames, self._send_answers, self._tick)
        ]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            self._due = False
            for task in tasks:
                task.cancel()
            ended = await asyncio.gather(*tasks, return_exceptions=True)
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
                if (code := message.get("refused")) and session.close is None:
                    session.end(code, message["reason"], message["code"])  # it has been told already
                return
            frame = message.get("bytes")
            if self._due:
                self._answer()
            # The loop's own clock counts milliseconds: enough for limits, not for a delay.
            self._arrived = perf_counter()
            self.frames += 1
            heard: float | None = message.get("heard")  # when it came, where it had to wait
            session.receive(
                message["text"] if frame is None else frame, loop.time() if heard is None else heard
            )
            if session.work is not None:
                session.finish(await loop.run_in_executor(self._worker, session.work))
            if not self._sending:
                self._due = True
                loop.call_soon(self._answer_soon)
            if self.frames % AT_ONCE == 0:
                await asyncio.sleep(0)

    def _answer_soon(self) -> None:
        """Called by the loop, where nobody would hear of an error: the sending task tells it."""
        if self._due:
            try:
                self._answer()
            except Exception as error:
                self._failure = error
                self._wake.set()

    def _answer(self) -> None:
        """Send what can be sent without waiting; the rest is for the sending task."""
        self._due = False
        if self._sending:
            return
        session = self.session
        predictions, frames = session.outbox.waiting, session.outbox.take()
        for place, frame in enumerate(frames, 1):
            try:
                rest = begin(self._send(_message(frame)))
            except OSError:
                self._send = unheard
                break
            if rest:
                self._begun.extend((rest, *frames[place:]))
                self._sending = True
                self._predicted = self._arrived if predictions else None
                break
        else:
            if predictions:
                self._delayed(perf_counter() - self._arrived)
        if self._begun or session.close is not None:
            self._wake.set()

    async def _send_answers(self) -> None:
        """Ends when the session has closed and all is said."""
        session, wake = self.session, self._wake
        while True:
            await wake.wait()
            wake.clear()
            if self._failure is not None:
                raise self._failure
            self._sending = True
            try:
                await self._send_waiting()
            except OSError:
                self._send = unheard
                self._begun.clear()
            self._sending = False
            if (close := session.close) is not None:
                await self._send({"type": "websocket.close", "code": close.code, "reason": close.reason})
                return

    async def _send_waiting(self) -> None:
        """Send what has begun and what the session has said, until there is nothing more."""
        session = self.session
        while self._begun or session.outbox:
            while self._begun:
                part = self._begun.popleft()
                await (self._send(_message(part)) if isinstance(part, str | bytes) else part)
                self._sent += 1
            if self._predicted is not None:
                self._delayed(perf_counter() - self._predicted)
                self._predicted = None
            arrived, predictions = self._arrived, session.outbox.waiting
            for frame in session.outbox.take():
                await self._send(_message(frame))
                self._sent += 1
            if predictions:
                self._delayed(perf_counter() - arrived)

    async def _tick(self) -> None:
        """Ends when the client has read nothing for too long; one that reads slowly goes on."""
        sent, stuck = 0, 0.0
        while stuck < STUCK_S + LAST_S:
            await asyncio.sleep(TICK_S)
            stuck = stuck + TICK_S if self._sending and self._sent == sent else 0.0
            sent = self._sent
            if stuck >= STUCK_S:
                self.session.give_up()
            self.session.tick(self._loop.time())
            self._wake.set()


async def unheard(message: MutableMapping[str, Any]) -> None:
    """Sends nothing: the client has left, and what it sent before is still taken in."""


def _message(frame: Frame) -> MutableMapping[str, Any]:
    return {"type": "websocket.send", "bytes" if isinstance(frame, bytes) else "text": frame}
