"""The life of a session: its states, what leads from one to another, and every way in which it ends."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import StrEnum

from msgspec import Struct

from pointpred.errors import EventError
from pointpred.protocol.client_messages import Bye, ClientMessage, Events, Hello
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Code, ErrorMessage, Limits, ServerMessage, encode
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.quota import Quota
from pointpred_server.sessions.work import Completion, Work

HELLO_S = 10.0
"""A client sends hello within this time."""
STANDSTILL_S = 1.0
"""A process that is late by more than this stood still: it was stopped, or the machine slept."""
SLOW = "the answers are not read"
FAILED = "the server failed; the session ends"


class State(StrEnum):
    """Where a session is."""

    CONNECTING = "connecting"
    GREETED = "greeted"
    STREAMING = "streaming"
    CLOSED = "closed"


class Trigger(StrEnum):
    """What may lead to another state."""

    HELLO = "hello"
    EVENTS = "events"
    MESSAGE = "any other message"
    CLOSE = "the end, by either side"


TRANSITIONS: Mapping[State, Mapping[Trigger, State]] = {
    State.CONNECTING: {
        Trigger.HELLO: State.GREETED,
        Trigger.CLOSE: State.CLOSED,
    },
    State.GREETED: {
        Trigger.EVENTS: State.STREAMING,
        Trigger.MESSAGE: State.GREETED,
        Trigger.CLOSE: State.CLOSED,
    },
    State.STREAMING: {
        Trigger.EVENTS: State.STREAMING,
        Trigger.MESSAGE: State.STREAMING,
        Trigger.CLOSE: State.CLOSED,
    },
    State.CLOSED: {},
}
"""The next state for each state and trigger; what is not listed for a state is out of place in it."""
TRIGGERS: Mapping[type[ClientMessage], Trigger] = {
    Hello: Trigger.HELLO,
    Events: Trigger.EVENTS,
    Bye: Trigger.CLOSE,
}
"""The trigger of each message; ``Trigger.MESSAGE`` for those that are not listed."""


class Close(Struct, frozen=True):
    """How the connection ends."""

    code: int
    reason: str


def bad_event(error: EventError) -> ErrorMessage:
    """The message for an event that a stage refuses."""
    return ProtocolError("bad_field", str(error), "$.events", field=error.field, value=error.value).answer


class Session:
    """What all sessions share: the state, what waits to be sent, what was refused, and how they end.

    Time is what the caller says it is, so that a test needs no clock. Nothing that a client sends may raise:
    what is wrong is answered. What takes long is not done here: ``work`` is what the caller runs, where it
    likes, before the next frame, and passes the result to ``finish``.
    """

    def __init__(self, name: str, limits: Limits, now: float, state: State = State.CONNECTING) -> None:
        self.name = name
        self.limits = limits
        self.state = state
        self.outbox = Outbox()
        self.close: Close | None = None
        """How the connection is to end, once the session is closed."""
        self.work: Work | None = None
        """What is to be run before the next frame is received."""
        self.refusals: dict[str, int] = {}
        """What was refused, by error code: events that run backwards, frames for all else."""
        self.last_received = now
        """When the client last sent something."""
        self._quota = Quota(limits, now)
        self._stop_reason: str | None = None  # why the session is to stop once its work is done

    @property
    def events(self) -> int:
        """How many events the session has taken in."""
        return 0

    def receive(self, frame: str | bytes, now: float) -> None:
        """Take in one frame; answers are in the outbox, and ``close`` is set when the connection ends."""
        if self.state is State.CLOSED:
            return
        try:
            self._quota.check_size(frame)
            self._receive(frame, now)
        except (ProtocolError, EventError) as error:
            self.answer_error(error)
        self.check_unread()

    def answer_error(self, error: ProtocolError | EventError) -> None:
        """Send why a frame was not used, and end where it says so."""
        if isinstance(error, EventError):
            self.refuse(bad_event(error))
            return
        self.refuse(error.answer)
        if error.close is not None:
            self.end(error.close, error.answer.message)

    def receive_together(self, frames: Sequence[str | bytes], now: float) -> int:
        """Take in the first of frames that have waited, or several of them as one; returns how many."""
        self.receive(frames[0], now)
        return 1

    def tell_behind(self, behind_s: float) -> None:
        """Tell the client how long its frames have waited for the service."""
        sentence = f"the service is behind: what is sent waits for {behind_s:.2g} s before it is used"
        self.send(ErrorMessage("slow", sentence, behind_s=behind_s))

    def _receive(self, frame: str | bytes, now: float) -> None:
        """Take in a frame of a size that is allowed; raises ProtocolError."""
        raise NotImplementedError

    def tick(self, now: float, late_s: float = 0.0) -> None:
        """End a session that is silent for too long or whose answers are not read.

        ``late_s``: how much later than it was due this is called. So long nobody could receive anything,
        because the process stood still, and what came meanwhile comes all at once.
        """
        if late_s > STANDSTILL_S:
            self.last_received += late_s
            self._quota.extend(late_s)
        silent_s = now - self.last_received
        if self.state is State.CLOSED:
            return
        if self.state is State.CONNECTING:
            if silent_s > HELLO_S:
                self.fail("idle", f"expected 'hello' within {HELLO_S:g} s", 1008)
        elif silent_s > self.limits.idle_s:
            self.fail("idle", f"nothing was received for {self.limits.idle_s:g} s", 1008)
        self.check_unread()

    def finish(self, completion: Completion) -> None:
        """Use the result of ``work``."""
        self.work = None
        if self.state is not State.CLOSED:
            completion()
            self.check_unread()
            if self._stop_reason is not None:
                self.stop(self._stop_reason)

    def stop(self, reason: str) -> None:
        """The server stops; work that has begun is finished first."""
        if self.work is not None:
            self._stop_reason = reason
        elif self.state is not State.CLOSED:
            self.send(Bye(reason))
            self.end(1001, reason)

    def check_unread(self) -> None:
        """End the session where more answers wait than a client may leave unread."""
        if self.outbox.full:
            self.fail("slow", SLOW, 1013)

    def connection_lost(self) -> None:
        """Nothing can be sent any more."""
        self.end(1006, "the connection was lost")

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
            self.move(Trigger.CLOSE)
            self.close = Close(code, reason.encode()[:120].decode(errors="ignore"))

    def move(self, trigger: Trigger) -> None:
        """Go to the next state."""
        self.state = TRANSITIONS[self.state][trigger]
