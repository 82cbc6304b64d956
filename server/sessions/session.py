"""One pointing session without a socket: frames in, frames out, and when to close.

``connecting -> greeted -> streaming -> closed``. Time is what the caller says it is, so that a test needs no
clock. Nothing a client sends may raise: what is wrong is answered.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from pointpred.columns import FloatArray
from pointpred.errors import EventError
from pointpred.protocol.client_messages import (
    VERSION,
    Bye,
    ClientMessage,
    Configure,
    EventRow,
    Events,
    Hello,
    Person,
    Reset,
    Targets,
    TrialMark,
)
from pointpred.protocol.decoding import decode_client_message, row_of, table_of_bytes, table_of_rows
from pointpred.protocol.errors import ProtocolError, short
from pointpred.protocol.records import EVENT, unpack_event
from pointpred.protocol.server_messages import ErrorMessage, KnownPerson, Limits, TargetsTaken, Welcome
from pointpred.server.sessions.allowance import TARGETS_AN_EVENT, Allowance
from pointpred.server.sessions.assisted import stream_of
from pointpred.server.sessions.building import NO_COEFFICIENTS
from pointpred.server.sessions.conversation import SLOW, Conversation
from pointpred.server.sessions.stream import Stream
from pointpred.server.sessions.watch import Watch

RECORD = EVENT.itemsize


class Session(Conversation):
    """The server's side of one connection.

    What takes long is not done here: ``work`` is what the caller runs, where it likes, before the next frame,
    and gives what came of it to ``finish``. ``watch`` opens, at the client's hello, what is told of the
    session's events, such as a recording. ``coefficients``: the files that the client may ask for by name.
    """

    def __init__(
        self,
        name: str,
        limits: Limits,
        now: float,
        watch: Callable[[str, Hello], Watch | None] | None = None,
        coefficients: Mapping[str, Path] = NO_COEFFICIENTS,
    ) -> None:
        super().__init__(name, limits, now)
        self.targets = Targets([])
        self._allowance = Allowance(limits, now)
        self._watch = watch
        self._coefficients = coefficients

    def receive(self, frame: str | bytes, now: float) -> None:
        """Take in one frame; answers are in the outbox, and ``close`` is set when the connection ends."""
        if self.work is not None:
            self.finish(self.work())  # answers come in the order of what they answer
        if self.state == "closed":
            return
        stream = self.stream
        try:
            if stream is not None:
                if now > self.heard:  # a frame that was kept waiting came before
                    self.heard = now
                # Most frames of a fast device, and cheap: one packed event with nothing wrong about it.
                if len(frame) == RECORD and isinstance(frame, bytes) and self._take_one(stream, frame, now):
                    return
            self._allowance.check_size(frame)
            if isinstance(frame, bytes):
                self._take_bytes(frame, now)
            else:
                self._handle(self._decode(frame, now), now)
        except ProtocolError as refused:
            self.refuse(refused.answer)
            if refused.close is not None:
                self.shut(refused.close, refused.answer.message)
        except EventError as error:
            self.refuse(ErrorMessage("bad_field", short(str(error)), "$.events"))
        if self.outbox.full:
            self.end("slow", SLOW, 1013)

    def _take_one(self, stream: Stream, frame: bytes, now: float) -> bool:
        """Predict from one packed event; False, and nothing taken, where there is more to say about it."""
        if not self._allowance.rate.allows(1, now):
            return False
        if not stream.feed_one(unpack_event(frame), self.outbox):
            self._allowance.rate.give_back(1)
            return False
        self.state = "streaming"
        return True

    def _take_bytes(self, frame: bytes, now: float) -> None:
        """Packed events; raises ProtocolError."""
        stream = self.stream
        self._allowance.take(len(frame) // RECORD, now)
        if stream is None:
            raise _out_of_place("a binary frame")
        self._predict(stream, table_of_bytes(frame))

    def _take_rows(self, stream: Stream, rows: list[EventRow], now: float) -> None:
        """Events in JSON; raises ProtocolError."""
        self._allowance.take(len(rows), now)
        if len(rows) == 1 and stream.feed_one(row_of(rows[0]), self.outbox):
            self.state = "streaming"
        else:
            self._predict(stream, table_of_rows(rows))

    def _predict(self, stream: Stream, table: FloatArray) -> None:
        error, dropped = stream.feed(table, self.outbox)
        self.work, stream.work = stream.work, None
        if len(table):
            self.state = "streaming"
        if error is not None:
            self.refuse(error, dropped)

    def _decode(self, text: str, now: float) -> ClientMessage:
        """A message; raises ProtocolError, a text that is none having been counted."""
        try:
            return decode_client_message(text)
        except ProtocolError:
            self._allowance.take_unusable(text, now)
            raise

    def _handle(self, message: ClientMessage, now: float) -> None:
        """Answer one message; raises ProtocolError."""
        stream = self.stream
        if isinstance(message, Events) and stream is not None:
            self._take_rows(stream, message.events, now)
            return
        if isinstance(message, Bye):
            self.shut(1000, message.reason or "bye")
            return
        self._allowance.take_message(now)
        if isinstance(message, Hello):
            self._greet(message, now)
        elif stream is None:
            raise _out_of_place(repr(message.__struct_config__.tag))
        elif isinstance(message, Targets):
            self._allowance.check_targets(message.targets)
            stream.take_targets(message.targets, self.outbox)
            self.targets = message
            self._allowance.burden = 1 + len(message.targets) // TARGETS_AN_EVENT
            self.say(TargetsTaken(len(message.targets)))
        elif isinstance(message, TrialMark):
            if message.action == "start":
                stream.start_trial(message.target)
            else:
                self.work = stream.end_trial(message.target)
        elif isinstance(message, Configure):
            stream.configure(message)
            self._welcome(stream)
        elif isinstance(message, Reset):
            stream.reset()
        elif isinstance(message, Person):
            self.say(KnownPerson(stream.person(message.person)))

    def _greet(self, hello: Hello, now: float) -> None:
        if self.stream is not None:
            raise ProtocolError("out_of_place", f"expected 'hello' once, the session is {self.state}")
        if hello.version != VERSION:
            raise ProtocolError(
                "bad_field", f"version must be {VERSION}, received {hello.version}", "$.version"
            )
        self.stream = stream_of(hello, self._coefficients)
        self.stream.watch = self._watch(self.name, hello) if self._watch else None
        self.state, self.heard = "greeted", max(now, self.heard)
        self._welcome(self.stream)

    def _welcome(self, stream: Stream) -> None:
        self.say(Welcome(VERSION, self.name, stream.hello.predictor, self.limits))


def _out_of_place(what: str) -> ProtocolError:
    return ProtocolError("out_of_place", f"expected 'hello' first, received {what}")
