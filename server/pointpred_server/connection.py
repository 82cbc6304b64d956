"""One connection: frames from the socket into a session, its answers back, until either side ends it."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Sequence
from itertools import islice
from time import perf_counter
from typing import NamedTuple, Protocol

from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Code
from pointpred_server.arrivals import Arrivals
from pointpred_server.sessions.lifecycle import SLOW, Close, Session
from pointpred_server.sessions.work import Completion, Work
from pointpred_server.work_threads import WorkThreads

FRAMES = "pointpred.frames"
"""The ASGI extension in which an application finds the ``FrameSocket`` of its connection, as ``socket``."""
BEHIND_S = 0.1
"""A client is told that the service is behind where its frames may have waited for so long,"""
TELL_S = 1.0
"""at most once in this time."""
TOGETHER_S = 0.02
"""Frames of events that have waited for so long, or for the work of another thread, are used as one."""
FRAMES_AT_ONCE = 64
"""So many frames of one client are taken in before others have their turn, however many have come, ..."""
TURN_S = 2e-3
"""... and none after this time."""
COSTLY_S = 1e-4
"""After a frame that took so long others have their turn, also where frames are read singly, in fragments."""
TICK_S = 1.0
"""How often a session is told that time passes."""
STUCK_S = 10.0
"""A session ends whose client has read nothing for so long although answers wait ..."""
GRACE_S = 5.0
"""... and the client has so long to read why."""


class Violation(NamedTuple):
    """Why the protocol below has ended a connection; the client has been told.

    ``code`` is ``None`` for what breaks the rules of WebSockets, for which there is no code of ours.
    """

    code: Code | None
    message: str
    close: int


class Receiver(Protocol):
    """Takes what comes from a client; called by the event loop, nothing may raise."""

    def receive(self, frames: Sequence[Frame], read_at: float | None = None) -> None:
        """Messages that were read together, at this time of ``perf_counter``; ``None``: just now."""

    def flush(self) -> None:
        """The client reads again."""

    def disconnect(self, refusal: Violation | None) -> None:
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


Observe = Callable[[float, float], None]
"""Takes how long a prediction took until it was handed over, in seconds: since its frame was taken in, and at
most since that can have come."""


class _Waiting(NamedTuple):
    """A frame that waits."""

    frame: Frame
    received: float
    """When it was read, on the loop's clock: enough for limits."""
    came: float
    """When it can have come at the earliest, on the clock of delays."""
    waited: bool
    """Whether that was so long before it was read that the service is behind."""


class Connection:
    """Runs a session over one accepted WebSocket.

    Frames go from the socket straight into the session, and its answers back, within one call of the event
    loop. Frames of events that have waited together are used as one. While the client does not read, its
    answers wait in the session's outbox, where newer predictions replace older ones, and its frames are still
    taken in. Another thread does the work of a session: its next frames wait for it, other sessions do not.
    The last frames of a client that sends and leaves at once are taken in as well.
    """

    def __init__(
        self,
        session: Session,
        socket: FrameSocket,
        arrivals: Arrivals,
        observe: Observe = lambda taken_s, arrived_s: None,
        threads: WorkThreads | None = None,
    ) -> None:
        """``arrivals`` is shared by the connections of an event loop. ``observe`` gets the delays.

        ``threads`` do the work of sessions; the loop's own executor where none are given. Limits count
        frames that waited by the time they came.
        """
        self.session = session
        self.frames = 0
        """Frames received."""
        self._socket = socket
        self._arrivals = arrivals
        self._observe_delays = observe
        self._threads = threads
        self._loop = asyncio.get_running_loop()
        self._over: asyncio.Future[None] = self._loop.create_future()
        self._waiting: deque[_Waiting] = deque()
        self._working = False  # whether they wait for another thread,
        self._turn: asyncio.Handle | None = None  # or for the turn of others
        self._late = False  # whether they have waited for the session's own work
        self._left = False  # whether the client has
        self._unsent: deque[Frame] = deque()  # taken from the outbox
        self._sent = 0
        self._taken_at = self._came = 0.0  # when the newest frame was taken in, and can have come
        self._predicting: tuple[float, float] | None = None  # both of the prediction among the unsent
        self._paused_at: float | None = None  # since when nothing was read because frames had to wait
        self._told_at = float("-inf")  # when the client was told that the service is behind

    async def run(self) -> Close | None:
        """Run until the session closes or the connection is lost; raises what broke.

        Returns how the connection is to be closed; ``None`` where the client is not there to be told.
        """
        sent, stuck_s = 0, 0.0
        self._socket.attach(self)
        try:
            while stuck_s < STUCK_S + GRACE_S:
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

    def receive(self, frames: Sequence[Frame], read_at: float | None = None) -> None:
        """Take in messages that were read together; those that waited for their turn were so before."""
        if self._over.done():
            return
        self.frames += len(frames)
        taken_at = perf_counter()  # the loop's own clock counts milliseconds
        now = self._loop.time()
        came = self._arrivals.since(taken_at, now)
        if read_at is not None and read_at < came:
            came = read_at
        if self._paused_at is not None:
            came, self._paused_at = min(came, self._paused_at), None
        free = not (self._waiting or self._working or self._turn)
        if free and len(frames) == 1:
            self._take(frames, now, taken_at, came)  # most frames
        else:
            waited = taken_at - came >= TOGETHER_S
            self._waiting.extend(_Waiting(frame, now, came, waited) for frame in frames)
            if self._turn:
                self._pause()
            self._take_waiting()
        self._arrivals.busy_until = used_at = perf_counter()
        if used_at - taken_at >= COSTLY_S and self._turn is None:
            self._turn = self._loop.call_soon(self._take_turn)

    def flush(self) -> None:
        """Send what can be sent now; the rest once the client reads again."""
        try:
            self._flush()
        except Exception as error:
            self._fail(error)

    def disconnect(self, refusal: Violation | None) -> None:
        """The client has left, or was refused by the protocol; what it sent before is still taken in."""
        self._left = True
        if refusal is not None and refusal.code is None:
            self.session.end(refusal.close, refusal.message)
        elif refusal is not None and refusal.code is not None:
            self.session.fail(refusal.code, refusal.message, refusal.close)
        if not (self._waiting or self._working):
            self._end()

    def _flush(self) -> None:
        session, socket, unsent = self.session, self._socket, self._unsent
        outbox = session.outbox
        while socket.can_write:
            if not unsent:
                if outbox.waiting:
                    self._predicting = self._taken_at, self._came
                unsent.extend(outbox.take())
                if not unsent:
                    break
            socket.write(unsent.popleft())
            self._sent += 1
            if self._predicting is not None and not unsent:
                self._observe(*self._predicting)
                self._predicting = None
        if session.close is not None and socket.can_write:
            self._end()

    def _observe(self, taken_at: float, came: float) -> None:
        """A prediction has been handed over."""
        now = perf_counter()
        self._observe_delays(now - taken_at, now - came)
        if now - came > BEHIND_S and now - self._told_at >= TELL_S and not self._late:
            self._told_at = now
            self.session.tell_behind(round(now - came, 3))

    def _take(self, frames: Sequence[Frame], now: float, taken_at: float, came: float) -> int:
        """Give the first of some frames to the session, or several together; send its answers; how many."""
        self._taken_at, self._came = taken_at, came
        session, taken = self.session, 1
        try:
            if len(frames) == 1:
                session.receive(frames[0], now)
            else:
                taken = session.receive_together(frames, now)
            if session.work is not None:
                self._start_work(session.work)
            self._flush()
        except Exception as error:
            self._fail(error)
        return taken

    def _take_waiting(self) -> None:
        """Take in frames that wait, until one has to wait again or others have their turn."""
        taken, begun_at = 0, perf_counter()
        while taken < FRAMES_AT_ONCE and perf_counter() - begun_at < TURN_S:
            if self._working or self._turn or self._over.done():
                return
            if not self._waiting:
                self._late = False
                if self._left:
                    self._end()
                self._socket.resume_frames()
                return
            taken += self._take_first(FRAMES_AT_ONCE - taken)
        self._turn = self._loop.call_soon(self._take_turn)
        if self._waiting:
            self._pause()

    def _take_first(self, most: int) -> int:
        """Take in the first of the frames that wait, or several that have waited long; returns how many."""
        first = self._waiting[0]
        if not (first.waited or self._late):
            most = 1
        frames = [each.frame for each in islice(self._waiting, most)]
        taken = self._take(frames, first.received, perf_counter(), first.came)
        for _ in range(taken):
            self._waiting.popleft()
        return taken

    def _take_turn(self) -> None:
        self._turn = None
        self._take_waiting()

    def _pause(self) -> None:
        """Have nothing read until the frames that wait are taken in."""
        self._paused_at = self._paused_at or perf_counter()
        self._socket.pause_frames()

    def _start_work(self, work: Work) -> None:
        self._working = True
        self._pause()
        if self._threads is None:
            done = self._loop.run_in_executor(None, work)
        else:
            done = asyncio.wrap_future(self._threads.submit(work), loop=self._loop)
        done.add_done_callback(self._finish_work)

    def _finish_work(self, done: asyncio.Future[Completion]) -> None:
        """Use the result of the work, and take in the frames that waited for it."""
        self._working, self._late = False, True
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
