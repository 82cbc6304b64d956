"""One connection: frames from the socket into a session, its answers back, until either side ends it."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable, Coroutine, Generator, MutableMapping
from concurrent.futures import Executor
from time import perf_counter
from typing import Any

from pointpred.protocol.frames import Frame
from pointpred.server.sessions.lifecycle import SLOW, Session

Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Coroutine[Any, Any, None]]

FRAMES_AT_ONCE = 32
"""Frames of one client received before others have their turn, however many have arrived."""
TICK_S = 1.0
"""How often a session is told that time passes."""
STUCK_S = 10.0
"""A session ends whose client has read nothing for so long although answers wait ..."""
LINGER_S = 5.0
"""... and the client has so long to read why."""


class Connection:
    """Runs a session over one accepted WebSocket.

    The answers to a frame are sent as soon as the frames that arrived for other sessions at the same time
    have been received: one kind of work after another costs less than taking turns. Every frame of a burst is
    answered. Where sending would have to wait, because the client does not read, another task waits and
    sends, and frames are received meanwhile: their answers wait in the session's outbox, where newer
    predictions replace older ones. Another thread does the work of a session: its next frames wait for it,
    other sessions do not. The last frames of a client that sends and leaves at once are received as well.
    """

    def __init__(
        self,
        session: Session,
        receive: Receive,
        send: Send,
        observe_delay: Callable[[float], None],
        worker: Executor | None = None,
    ) -> None:
        """``observe_delay`` gets the seconds from the newest frame to its prediction handed to the socket.

        ``worker`` does the work of sessions; the loop's own executor where none is given.
        """
        self.session = session
        self.frames = 0
        """Frames received."""
        self._receive = receive
        self._send = send
        self._observe_delay = observe_delay
        self._worker = worker
        self._wake = asyncio.Event()
        self._received_at = 0.0
        self._flush_due = False  # whether the loop has been asked to call _flush_soon
        self._failure: Exception | None = None
        self._sending = False  # whether the sending task is at work
        self._sent = 0  # frames that the sending task has sent
        self._begun: deque[Awaitable[None] | Frame] = deque()  # what the sending task is to finish first
        self._predicted_at: float | None = None  # when the frame arrived whose prediction is among these
        self._loop = asyncio.get_running_loop()

    async def run(self) -> None:
        """Run until the session closes or the connection is lost; raises what broke."""
        tasks = [
            self._loop.create_task(part())
            for part in (self._receive_frames, self._send_answers, self._watch_time)
        ]
        try:
            await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        finally:
            self._flush_due = False
            for task in tasks:
                task.cancel()
            ended = await asyncio.gather(*tasks, return_exceptions=True)
        for result in ended:
            if isinstance(result, Exception):
                raise result

    def wake(self) -> None:
        """Look whether there is something to send."""
        self._wake.set()

    async def _receive_frames(self) -> None:
        """Ends when the connection is lost."""
        session, loop = self.session, self._loop
        while True:
            message = await self._receive()
            if message["type"] == "websocket.disconnect":
                if code := message.get("refused"):  # the protocol below has already sent the error
                    session.fail(code, message["reason"], message["code"])
                return
            frame = message.get("bytes")
            if self._flush_due:
                self._flush()
            # The loop's own clock counts milliseconds: enough for limits, not for a delay.
            self._received_at = perf_counter()
            self.frames += 1
            buffered_at: float | None = message.get("received_at")
            session.receive(
                message["text"] if frame is None else frame,
                loop.time() if buffered_at is None else buffered_at,
            )
            if session.work is not None:
                session.finish(await loop.run_in_executor(self._worker, session.work))
            if not self._sending:
                self._flush_due = True
                loop.call_soon(self._flush_soon)
            if self.frames % FRAMES_AT_ONCE == 0:
                await asyncio.sleep(0)

    def _flush_soon(self) -> None:
        """Called by the loop, which would only log an error: the sending task raises it."""
        if self._flush_due:
            try:
                self._flush()
            except Exception as error:
                self._failure = error
                self._wake.set()

    def _flush(self) -> None:
        """Send what can be sent without waiting; the rest is for the sending task."""
        self._flush_due = False
        if self._sending:
            return
        session = self.session
        predictions, frames = session.outbox.waiting, session.outbox.take()
        for place, frame in enumerate(frames, 1):
            try:
                rest = begin(self._send(_message(frame)))
            except OSError:
                self._send = discard
                break
            if rest:
                self._begun.extend((rest, *frames[place:]))
                self._sending = True
                self._predicted_at = self._received_at if predictions else None
                break
        else:
            if predictions:
                self._observe_delay(perf_counter() - self._received_at)
        if self._begun or session.close is not None:
            self._wake.set()

    async def _send_answers(self) -> None:
        """Ends when the session has closed and everything is sent."""
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
                self._send = discard
                self._begun.clear()
            self._sending = False
            if (close := session.close) is not None:
                await self._send({"type": "websocket.close", "code": close.code, "reason": close.reason})
                return

    async def _send_waiting(self) -> None:
        """Send what has begun and what is in the outbox, until there is nothing more."""
        session = self.session
        while self._begun or session.outbox:
            while self._begun:
                part = self._begun.popleft()
                await (self._send(_message(part)) if isinstance(part, str | bytes) else part)
                self._sent += 1
            if self._predicted_at is not None:
                self._observe_delay(perf_counter() - self._predicted_at)
                self._predicted_at = None
            received_at, predictions = self._received_at, session.outbox.waiting
            for frame in session.outbox.take():
                await self._send(_message(frame))
                self._sent += 1
            if predictions:
                self._observe_delay(perf_counter() - received_at)

    async def _watch_time(self) -> None:
        """Ends when the client has read nothing for too long; one that reads slowly goes on."""
        sent, stuck_s = 0, 0.0
        while stuck_s < STUCK_S + LINGER_S:
            await asyncio.sleep(TICK_S)
            stuck_s = stuck_s + TICK_S if self._sending and self._sent == sent else 0.0
            sent = self._sent
            if stuck_s >= STUCK_S:
                self.session.fail("slow", SLOW, 1013)
            self.session.tick(self._loop.time())
            self._wake.set()


async def discard(message: Message) -> None:
    """Send nothing: the client has left, and what it sent before is still received."""


def _message(frame: Frame) -> Message:
    return {"type": "websocket.send", "bytes" if isinstance(frame, bytes) else "text": frame}


def begin(coroutine: Coroutine[Any, Any, None]) -> Awaitable[None] | None:
    """Run a coroutine without a task until it ends or must wait; returns the rest to be awaited, or ``None``.

    A coroutine that need not wait costs no more than a call.
    """
    try:
        awaited = coroutine.send(None)
    except StopIteration:
        return None
    return _Rest(coroutine, awaited)


class _Rest:
    """A coroutine that has begun and waits for something."""

    def __init__(self, coroutine: Coroutine[Any, Any, None], awaited: Any) -> None:
        self._coroutine = coroutine
        self._awaited = awaited

    def __await__(self) -> Generator[Any, Any, None]:
        awaited = self._awaited
        while True:
            error: BaseException | None = None
            value: Any = None
            try:
                value = yield awaited
            except BaseException as thrown:  # a cancellation is the coroutine's to handle
                error = thrown
            try:
                awaited = self._coroutine.send(value) if error is None else self._coroutine.throw(error)
            except StopIteration:
                return
