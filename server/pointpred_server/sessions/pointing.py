"""One pointing session without a socket: frames in, frames out, and when to close."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, ClassVar

from pointpred.clock import Instant
from pointpred.protocol.client_messages import (
    VERSIONS,
    Bye,
    ClientMessage,
    Configure,
    Enter,
    Events,
    Forget,
    Hello,
    Person,
    Reset,
    Targets,
    TrialMark,
)
from pointpred.protocol.decoding import decode_client_message, rows_of_bytes, rows_of_message
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import (
    KnownPerson,
    Limits,
    ServerMessage,
    TargetsTaken,
    Welcome,
)
from pointpred_server.sessions.lifecycle import Session, State
from pointpred_server.sessions.pipelines import NO_COEFFICIENTS
from pointpred_server.sessions.prediction_stream import PredictionStream, SessionObserver
from pointpred_server.sessions.quota import BUILDING, Address

Handler = Callable[[Any, Any], ServerMessage | None]


class PointingSession(Session):
    """The server's side of one connection to ``/v1/stream``.

    ``observe`` makes, at the client's hello, an observer of the session's events, such as a recorder.
    ``coefficients``: the files that the client may ask for by name.
    """

    def __init__(
        self,
        name: str,
        limits: Limits,
        now: Instant,
        address: Address | None = None,
        observe: Callable[[str, Hello], SessionObserver | None] = lambda name, hello: None,
        coefficients: Mapping[str, Path] = NO_COEFFICIENTS,
    ) -> None:
        super().__init__(name, limits, now, address)
        self._stream: PredictionStream | None = None
        self._observe = observe
        self._coefficients = coefficients

    @property
    def stream(self) -> PredictionStream:
        """The stream, once the client has said hello; raises ProtocolError before."""
        if self._stream is None:
            raise ProtocolError("out_of_place", "expected 'hello' first")
        return self._stream

    @property
    def events(self) -> int:
        """How many events the session has taken in."""
        return self._stream.events if self._stream else 0

    def _receive(self, frame: str | bytes, now: Instant) -> None:
        try:
            message = rows_of_bytes(frame) if isinstance(frame, bytes) else decode_client_message(frame)
        except ProtocolError:
            self._quota.take_message(now, len(frame))
            raise
        if isinstance(message, list):
            rows = message
        elif isinstance(message, Events):
            rows = rows_of_message(message)
        else:
            self._handle(message, len(frame), now)
            return
        self._quota.take_events(len(rows), now)
        error, dropped = self.stream.push(rows)
        if rows:
            self.state = State.STREAMING
        if error is not None:
            self.refuse(error, dropped)

    def _handle(self, message: ClientMessage, size: int, now: Instant) -> None:
        """Act on a message that is not events."""
        kind = type(message)
        if kind is not Bye:
            self._quota.take_message(now, size, BUILDING if _builds(message) else 1)
        if kind is not Hello and kind is not Bye and self._stream is None:
            received = message.__struct_config__.tag
            raise ProtocolError("out_of_place", f"expected 'hello' first, received {received!r}")
        reply = self.handlers[kind](self, message)
        if reply is not None:
            self.send(reply)

    def handle_hello(self, message: Hello) -> Welcome:
        """Open the stream that the client asks for."""
        if self._stream is not None:
            raise ProtocolError("out_of_place", f"expected 'hello' once, the session is {self.state}")
        if message.version not in VERSIONS:
            sentence = f"version must be {' or '.join(map(str, VERSIONS))}, received {message.version}"
            raise ProtocolError("bad_field", sentence, "$.version")
        self._stream = PredictionStream(message, self.outbox, self._coefficients)
        self._stream.observer = self._observe(self.name, message)
        self.state = State.GREETED
        return self._welcome()

    def handle_targets(self, message: Targets) -> TargetsTaken:
        """Replace the set of targets."""
        self._quota.check_targets(message.targets)
        self.stream.replace_targets(message.targets)
        self._weigh_events()
        return TargetsTaken(len(message.targets))

    def handle_trial(self, message: TrialMark) -> None:
        """Start a trial, or end it: its score is sent once it is known."""
        if message.action == "start":
            self.stream.start_trial(message.target, message.conditions)
        else:
            self.run_aside(self.stream.end_trial(message.target, message.conditions))

    def handle_configure(self, message: Configure) -> Welcome:
        """Change the predictor, its parameters or the kind of reply."""
        self.stream.configure(message)
        return self._welcome()

    def handle_reset(self, message: Reset) -> None:
        """Forget every event."""
        self.stream.reset()

    def handle_person(self, message: Person) -> KnownPerson:
        """Send what is known of the person."""
        return KnownPerson(self.stream.person(message.person))

    def handle_enter(self, message: Enter) -> None:
        """Remember places for this window."""
        self.stream.enter(message)

    def handle_forget(self, message: Forget) -> KnownPerson:
        """Forget the person."""
        return KnownPerson(self.stream.forget())

    def handle_bye(self, message: Bye) -> None:
        """Close as the client asks."""
        self.end(1000, message.reason or "bye")

    handlers: ClassVar[Mapping[type[ClientMessage], Handler]] = {
        Hello: handle_hello,
        Targets: handle_targets,
        TrialMark: handle_trial,
        Configure: handle_configure,
        Enter: handle_enter,
        Forget: handle_forget,
        Reset: handle_reset,
        Person: handle_person,
        Bye: handle_bye,
    }
    """The method for each message but events. It returns the answer, if any, and raises ProtocolError."""

    def end(self, code: int, reason: str) -> None:
        """As ``Session.end``; the observer is told, too."""
        if self.state is not State.CLOSED and self._stream and self._stream.observer:
            self._stream.observer.close()
        super().end(code, reason)

    def _weigh_events(self) -> None:
        """What an event counts, with the targets and the settings in force."""
        self._quota.weigh_events(self.stream.targets, places=self.stream.hello.places)

    def _welcome(self) -> Welcome:
        self._weigh_events()
        hello = self.stream.hello
        return Welcome(hello.version, self.name, hello.predictor, self.limits)


def _builds(message: ClientMessage) -> bool:
    """Whether a message has a pipeline built, or a trial scored."""
    if isinstance(message, Configure):
        return message.predictor is not None or bool(message.parameters)
    if isinstance(message, Person):
        return message.person is not None
    return isinstance(message, Hello | TrialMark)
