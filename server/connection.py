"""One connection: frames from the socket into a session, its answers back, until either side ends it."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Coroutine, Sequence
from concurrent.futures import Executor
from functools import partial
from time import perf_counter
from typing import Any, NamedTuple, Protocol

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Code
from pointpred.server.sessions.lifecycle import SLOW, Close, Session, Work

FRAMES = "pointpred.frames"
"""The ASGI extension in which an application finds the ``FrameSocket`` of its connection, as ``socket``."""
FRAMES_AT_ONCE = 64
"""So many frames of one client are taken in before others have their turn, however many have come."""
TICK_S = 1.0
"""How often a session is told that time passes."""
STUCK_S = 10.0
"""A session ends whose client has read nothing for so long although answers wait ..."""
LINGER_S = 5.0
"""... and the client has so long to read why."""
MOST_MESSAGES = 4096
MOST_BYTES = 2**20
"""What is read from a client while it waits for the compiler. Only by reading does the service notice that a
client has left. A client that sends more than this is read again after the wait."""


class Refusal(NamedTuple):
    """Why the protocol below has ended a connection; the client has been told.

    ``code`` is ``None`` for what breaks the rules of WebSockets, for which there is no code of ours.
    """

    code: Code | None
    message: str
    close: int


class Receiver(Protocol):
    """Takes what comes from a client; called by the event loop, nothing may raise."""

    def receive(self, frames: Sequence[Frame]) -> None:
        """Messages that came together."""

    def flush(self) -> None:
        """The client reads again."""

    def disconnect(self, refusal: Refusal | None) -> None:
        """Nothing more comes, and nothing can be sent."""


class FrameSocket(Protocol):
    """What a connection needs of the WebSocket below it; nothing waits."""

    can_write: bool
    """Whether little enough is unsent: otherwise answers wait in the session's outbox."""

    def attach(self, receiver: Receiver) -> None:
        """Give what comes from the client to a receiver from now on."""

    def detach(self) -> None:
        """Drop what comes from the client from now on."""

    def write(self, frame: Frame) -> None:
        """Send a message."""

    def pause_frames(self) -> None:
        """Read nothing more from the client."""

    def resume_frames(self) -> None:
        """Read again."""


class Connection:
    """Runs a session over one accepted WebSocket.

    Frames go from the socket straight into the session, and its answers back, within one call of the event
    loop. Every frame of a burst is answered. While the client does not read, its answers wait in the
    session's outbox, where newer predictions replace older ones, and its frames are still taken in. Another
    thread does the work of a session: its next frames wait for it, other sessions do not. The last frames of
    a client that sends and leaves at once are taken in as well.
    """

    def __init__(
        self,
        session: Session,
        socket: FrameSocket,
        observe_delay: Callable[[float], None],
        worker: Executor | None = None,
        prepare: Callable[[Frame], Coroutine[Any, Any, None] | None] | None = None,
    ) -> None:
        """``observe_delay`` gets the seconds from the newest frame to its prediction handed to the socket.

        ``worker`` does the work of sessions; the loop's own executor where none is given. ``prepare``
        returns what a frame has to wait for, ``None`` where there is nothing; a client that leaves meanwhile
        cancels it. Limits count frames that waited by the time they came.
        """
        self.session = session
        self.frames = 0
        """Frames received."""
        self._socket = socket
        self._observe_delay = observe_delay
        self._worker = worker
        self._prepare = prepare
        self._loop = asyncio.get_running_loop()
        self._over: asyncio.Future[None] = self._loop.create_future()
        self._waiting: deque[tuple[Frame, float]] = deque()  # frames that wait, and when they came
        self._waiting_bytes = 0
        self._working = False  # whether they wait for another thread,
        self._preparation: asyncio.Task[None] | None = None  # for what the first of them needs,
        self._turn: asyncio.Handle | None = None  # or for the turn of others
        self._left = False  # whether the client has
        self._unsent: deque[Frame] = deque()  # taken from the outbox
        self._sent = 0
        self._received_at = 0.0
        self._predicted_at: float | None = None  # when the frame came whose prediction is among the unsent

    async def run(self) -> Close | None:
        """Run until the session closes or the connection is lost; raises what broke.

        Returns how the connection is to be closed; ``None`` where the client is not there to be told.
        """
        sent, stuck_s = 0, 0.0
        self._socket.attach(self)
        try:
            while stuck_s < STUCK_S + LINGER_S:
                self._flush()
                before = self._loop.time()
                await asyncio.wait((self._over,), timeout=TICK_S)
                if self._over.done():
                    self._over.result()
                    return None if self._left else self.session.close
                stuck_s = stuck_s + TICK_S if self._sent == sent and not self._socket.can_write else 0.0
                sent = self._sent
                if stuck_s >= STUCK_S:
                    self.session.fail("slow", SLOW, 1013)
                now = self._loop.time()
                self.session.tick(now, late_s=now - before - TICK_S)
        finally:
            self._end()
            self._socket.detach()
        return None

    def receive(self, frames: Sequence[Frame]) -> None:
        """Take in messages that came together."""
        if self._over.done():
            return
        self.frames += len(frames)
        now = self._loop.time()
        if len(frames) == 1 and not self._waiting and not self._working and self._prepare is None:
            self._take(frames[0], now)  # most frames
            return
        self._waiting.extend((frame, now) for frame in frames)
        self._waiting_bytes += sum(map(len, frames))
        if len(self._waiting) > MOST_MESSAGES or self._waiting_bytes > MOST_BYTES:
            self._socket.pause_frames()
        self._take_waiting()

    def flush(self) -> None:
        """Send what can be sent now; the rest once the client reads again."""
        try:
            self._flush()
        except Exception as error:
            self._fail(error)

    def disconnect(self, refusal: Refusal | None) -> None:
        """The client has left, or was refused by the protocol; what it sent before is still taken in."""
        self._left = True
        if refusal is not None and refusal.code is None:
            self.session.end(refusal.close, refusal.message)
        elif refusal is not None and refusal.code is not None:
            self.session.fail(refusal.code, refusal.message, refusal.close)
        if self._preparation is not None or not self._waiting:
            self._end()

    def _flush(self) -> None:
        session, socket, unsent = self.session, self._socket, self._unsent
        outbox = session.outbox
        while socket.can_write and (unsent or outbox):
            if not unsent:
                if outbox.waiting:
                    self._predicted_at = self._received_at
                unsent.extend(outbox.take())
            socket.write(unsent.popleft())
            self._sent += 1
            if self._predicted_at is not None and not unsent:
                self._observe_delay(perf_counter() - self._predicted_at)
                self._predicted_at = None
        if session.close is not None and socket.can_write:
            self._end()

    def _take(self, frame: Frame, now: float) -> None:
        """Give a frame to the session, send its answers, and have its work done."""
        # The loop's own clock counts milliseconds: enough for limits, not for a delay.
        self._received_at = perf_counter()
        session = self.session
        try:
            session.receive(frame, now)
            if session.work is not None:
                self._start_work(session.work)
            self._flush()
        except Exception as error:
            self._fail(error)

    def _take_waiting(self) -> None:
        """Take in frames that wait, until one has to wait again or others have their turn."""
        for _ in range(FRAMES_AT_ONCE):
            if self._working or self._preparation or self._turn or self._over.done():
                return
            if not self._waiting:
                if self._left:
                    self._end()
                self._socket.resume_frames()
                return
            frame, came = self._waiting.popleft()
            self._waiting_bytes -= len(frame)
            preparation = None if self._prepare is None else self._prepare(frame)
            if preparation is None:
                self._take(frame, came)
            else:
                self._preparation = self._loop.create_task(preparation)
                self._preparation.add_done_callback(partial(self._take_prepared, frame, came))
        if self._waiting:
            self._turn = self._loop.call_soon(self._take_turn)

    def _take_turn(self) -> None:
        self._turn = None
        self._take_waiting()

    def _take_prepared(self, frame: Frame, came: float, preparation: asyncio.Task[None]) -> None:
        """Take in a frame that has waited for what it needs, and then those behind it."""
        self._preparation = None
        if preparation.cancelled() or self._over.done():
            return
        if error := preparation.exception():
            self._over.set_exception(error)
            return
        self._take(frame, came)
        self._take_waiting()

    def _start_work(self, work: Work) -> None:
        self._working = True
        self._socket.pause_frames()
        self._loop.run_in_executor(self._worker, work).add_done_callback(self._finish_work)

    def _finish_work(self, done: asyncio.Future[Callable[[], None]]) -> None:
        """Use the result of the work, and take in the frames that waited for it."""
        self._working = False
        if done.cancelled() or self._over.done():
            return
        try:
            self.session.finish(done.result())
            self._flush()
        except Exception as error:
            self._fail(error)
        self._take_waiting()

    def _fail(self, error: Exception) -> None:
        if not self._over.done():
            self._over.set_exception(error)

    def _end(self) -> None:
        if not self._over.done():
            self._over.set_result(None)
        if self._preparation is not None:
            self._preparation.cancel()
