"""The life of a session: its states, and how it ends.

| close code | why | where it is decided |
| --- | --- | --- |
| 1000 | the client said ``bye`` | `pointing.py`, `viewing.py` |
| 1000, 1001, 1005 | the client closed the WebSocket | `websocket_protocol.py` |
| 1001 | the server stops | ``Session.stop`` |
| 1002, 1007 | a rule of WebSockets is broken, or a text is not UTF-8 | `websocket_protocol.py` |
| 1006 | the connection was lost | ``Session.connection_lost`` |
| 1008 | no ``hello`` in time, or silence | ``Session.tick`` |
| 1008 | too many events or messages a second | `quota.py` |
| 1009 | a frame or message is too long | `quota.py`, `websocket_protocol.py` |
| 1011 | something failed here, or a ping went unanswered | ``Session.fail``, `websocket_protocol.py` |
| 1013 | answers are not read: too many wait, or for too long | ``Session.receive``, `websocket_protocol.py` |
"""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum

from msgspec import Struct

from pointpred.clock import NEVER, Instant
from pointpred.errors import EventError
from pointpred.protocol.client_messages import Bye
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Code, ErrorMessage, Limits, ServerMessage, encode
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.quota import Address, Quota

HELLO_S = 10.0
"""A client sends hello within this time."""
STANDSTILL_S = 1.0
"""A process that is late by more than this stood still: it was stopped, or the machine slept."""
RETRY_S = 120.0
"""What could not be delivered meanwhile, TCP sends again after as long as it has tried, at most so long."""
SLOW = "the answers are not read"
FAILED = "the server failed; the session ends"
LOST = 1006
"""The close code of a connection that was lost: a tab was closed, a process ended."""


class State(StrEnum):
    """Where a session is: each follows the one before it, and any may be the last before ``CLOSED``."""

    CONNECTING = "connecting"
    GREETED = "greeted"
    STREAMING = "streaming"
    CLOSED = "closed"


class Close(Struct, frozen=True):
    """How the connection ends."""

    code: int
    reason: str


class Session:
    """What all sessions share: the state, what waits to be sent, what was refused, and how they end.

    Time is what the caller says it is, so that a test needs no clock. Nothing that a client sends may raise:
    what is wrong is answered.
    """

    def __init__(
        self,
        name: str,
        limits: Limits,
        now: Instant,
        address: Address | None = None,
        state: State = State.CONNECTING,
    ) -> None:
        self.name = name
        self.limits = limits
        self.state = state
        self.outbox = Outbox()
        self.close: Close | None = None
        """How the connection is to end, once the session is closed."""
        self.refusals: dict[str, int] = {}
        """What was refused, by error code: events that run backwards, frames for all else."""
        self.last_received = now
        """When the client last sent something."""
        self.patient_until = NEVER
        """No silence counts before: the process stood still, and the client may not know that it goes on."""
        self.run_aside: Callable[[Callable[[], ServerMessage]], None] = lambda work: self.send(work())
        """Has work done that takes long, in another thread where one is given, and sends what comes of it."""
        self._quota = Quota(limits, now, address)

    @property
    def events(self) -> int:
        """How many events the session has taken in."""
        return 0

    def receive(self, frame: str | bytes, now: Instant) -> None:
        """Take in one frame; answers are in the outbox, and ``close`` is set when the connection ends."""
        if self.state is State.CLOSED:
            return
        try:
            self._quota.check_size(frame)
            self._receive(frame, now)
        except (ProtocolError, EventError) as error:
            self.answer_error(error)
        if self.state is not State.CONNECTING:
            self.last_received = now
        if self.outbox.full:
            self.fail("slow", SLOW, 1013)

    def _receive(self, frame: str | bytes, now: Instant) -> None:
        """Take in a frame of a size that is allowed; raises ProtocolError."""
        raise NotImplementedError

    def receive_piece(self, now: Instant) -> None:
        """Count a ping, a pong or a piece of a message: they are limited as messages are."""
        if self.state is not State.CLOSED:
            try:
                self._quota.take_message(now)
            except ProtocolError as error:
                self.answer_error(error)

    def answer_error(self, error: ProtocolError | EventError) -> None:
        """Send why a frame was not used, and end where it says so."""
        if isinstance(error, EventError):
            error = ProtocolError("bad_field", str(error), "$.events", field=error.field, value=error.value)
        self.refuse(error.answer)
        if error.close is not None:
            self.end(error.close, error.answer.message)

    def tick(self, now: Instant, late_s: float = 0.0) -> None:
        """End a session that is silent for too long.

        ``late_s``: how much later than it was due this is called. So long nobody could receive anything,
        because the process stood still, and what came meanwhile comes all at once.
        """
        if late_s > STANDSTILL_S:
            self.last_received = self.last_received.later(late_s)
            self._quota.extend(late_s)
        silent_s = now.since(max(self.last_received, self.patient_until))
        if self.state is State.CONNECTING:
            if silent_s > HELLO_S:
                self.fail("idle", f"expected 'hello' within {HELLO_S:g} s", 1008)
        elif silent_s > self.limits.idle_s:
            self.fail("idle", f"nothing was received for {self.limits.idle_s:g} s", 1008)
        if late_s > STANDSTILL_S:
            self.patient_until = now.later(min(late_s, RETRY_S))

    def stop(self, reason: str) -> None:
        """The server stops."""
        if self.state is not State.CLOSED:
            self.send(Bye(reason))
            self.end(1001, reason)

    def connection_lost(self) -> None:
        """Nothing can be sent any more."""
        self.end(LOST, "the connection was lost")

    def send(self, message: ServerMessage | Bye) -> None:
        """Send a message that must not be lost."""
        self.outbox.add(encode(message).decode())

    def refuse(self, error: ErrorMessage, count: int = 1) -> None:
        """Send why something was not used, and count it."""
        self.refusals[error.code] = self.refusals.get(error.code, 0) + count
        self.send(error)

    def fail(self, code: Code = "internal", message: str = FAILED, close: int = 1011) -> None:
        """End with an error: unless another is named, something broke on this side."""
        if self.state is not State.CLOSED:
            self.refuse(ErrorMessage(code, message, None, recoverable=False))
            self.end(close, message)

    def end(self, code: int, reason: str) -> None:
        """Receive nothing from now on, and have the connection closed."""
        if self.state is not State.CLOSED:
            self.state = State.CLOSED
            self.close = Close(code, reason.encode()[:120].decode(errors="ignore"))
