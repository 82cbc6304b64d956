"""One pointing session without a socket: frames in, frames out, and when to close.

``connecting -> greeted -> streaming -> closed``. Time is what the caller says it is, so that a test needs no
clock. Nothing a client sends may raise: what is wrong is answered.
"""

from __future__ import annotations

from typing import Literal

from msgspec import Struct, structs

from pointpred.columns import EventColumns
from pointpred.server.decoding import RefusedError, decode_text, events_of_bytes, events_of_rows
from pointpred.server.messages import (
    VERSION,
    Bye,
    ClientMessage,
    Code,
    Configure,
    ErrorMessage,
    Events,
    Hello,
    Limits,
    Reset,
    ServerMessage,
    Targets,
    TargetsTaken,
    TrialMark,
    Welcome,
    encode,
)
from pointpred.server.outbox import Outbox
from pointpred.server.rate import Rate
from pointpred.server.stream import Stream

State = Literal["connecting", "greeted", "streaming", "closed"]
HELLO_S = 10.0
"""A client says hello within this time."""


class Close(Struct, frozen=True):
    """How the connection ends."""

    code: int
    reason: str


class Session:
    """The server's side of one connection."""

    def __init__(self, name: str, limits: Limits, now: float) -> None:
        self.name = name
        self.limits = limits
        self.state: State = "connecting"
        self.outbox = Outbox()
        self.close: Close | None = None
        self.stream: Stream | None = None
        self.targets = Targets([])
        self.refused: dict[Code, int] = {}
        """What was refused, by error code: events that run backwards, frames for all else."""
        self._heard = now
        self._rate = Rate(limits.max_events_per_s, now)

    def receive(self, frame: str | bytes, now: float) -> None:
        """Take in one frame; answers are in the outbox, and ``close`` is set when the connection ends."""
        if self.state == "closed":
            return
        try:
            self._check_size(frame)
            if isinstance(frame, bytes):
                self._feed(self._greeted("a binary frame"), events_of_bytes(frame), now)
            else:
                self._handle(decode_text(frame), now)
            if self.state != "connecting":
                self._heard = now
        except RefusedError as refused:
            self._refuse(refused.answer)
            if refused.close is not None:
                self._close(refused.close, refused.answer.message)

    def tick(self, now: float) -> None:
        """Notice what only time tells: no hello, nothing heard, nothing read."""
        silent = now - self._heard
        if self.state == "closed":
            return
        if self.state == "connecting" and silent > HELLO_S:
            self._end("idle", f"expected 'hello' within {HELLO_S:g} s", 1008)
        elif self.state != "connecting" and silent > self.limits.idle_s:
            self._end("idle", f"nothing was heard for {self.limits.idle_s:g} s", 1008)
        elif self.outbox.full:
            self._end("slow", "the answers are not read", 1013)

    def stop(self, reason: str) -> None:
        """The server stops."""
        if self.state != "closed":
            self._say(Bye(reason))
            self._close(1001, reason)

    def fail(self) -> None:
        """Something broke on this side."""
        self._end("internal", "the server failed; the session ends", 1011)

    def _handle(self, message: ClientMessage, now: float) -> None:
        """Answer one message; raises RefusedError."""
        if isinstance(message, Hello):
            self._greet(message)
            return
        if isinstance(message, Bye):
            self._close(1000, message.reason or "bye")
            return
        stream = self._greeted(repr(message.__struct_config__.tag))
        if isinstance(message, Events):
            self._feed(stream, events_of_rows(message.events), now)
        elif isinstance(message, Targets):
            self._take_targets(message)
        elif isinstance(message, TrialMark):
            if message.action == "start":
                stream.start_trial(message.target)
            else:
                self._say(stream.end_trial(message.target))
        elif isinstance(message, Configure):
            self._configure(stream, message)
        elif isinstance(message, Reset):
            stream.reset()

    def _greeted(self, what: str) -> Stream:
        if self.stream is None:
            raise RefusedError("out_of_place", f"expected 'hello' first, received {what}")
        return self.stream

    def _greet(self, hello: Hello) -> None:
        if self.stream is not None:
            raise RefusedError("out_of_place", f"expected 'hello' once, the session is {self.state}")
        if hello.version != VERSION:
            raise RefusedError(
                "bad_field", f"version must be {VERSION}, received {hello.version}", "$.version"
            )
        self.stream = Stream(hello)
        self.state = "greeted"
        self._say(Welcome(VERSION, self.name, hello.predictor, self.limits))

    def _configure(self, stream: Stream, message: Configure) -> None:
        """Another predictor or other parameters begin without memory; the answer says what holds now."""
        kept = {} if message.predictor else stream.hello.parameters
        hello = structs.replace(
            stream.hello,
            predictor=message.predictor or stream.hello.predictor,
            parameters={**kept, **message.parameters},
            reply=message.reply or stream.hello.reply,
        )
        if message.predictor or message.parameters:
            self.stream = Stream(hello)
        else:
            stream.hello = hello
        self._say(Welcome(VERSION, self.name, hello.predictor, self.limits))

    def _feed(self, stream: Stream, events: EventColumns, now: float) -> None:
        """Predict from events, within the limits."""
        count, most = len(events), self.limits.max_events_per_frame
        if count > most:
            words = f"a frame holds at most {most} events, received {count}"
            raise RefusedError("too_large", words, "$.events", close=1009)
        if not self._rate.allows(count, now):
            raise RefusedError(
                "too_fast", f"at most {self.limits.max_events_per_s} events a second", close=1008
            )
        if count:
            self.state = "streaming"
        error, dropped = stream.feed(events, self.outbox)
        if error is not None:
            self._refuse(error, dropped)

    def _take_targets(self, message: Targets) -> None:
        count, most = len(message.targets), self.limits.max_targets
        if count > most:
            raise RefusedError("too_many", f"at most {most} targets, received {count}", "$.targets")
        seen: set[str] = set()
        for place, target in enumerate(message.targets):
            if target.id in seen:
                raise RefusedError("bad_field", f"id {target.id!r} occurs twice", f"$.targets[{place}].id")
            seen.add(target.id)
        self.targets = message
        self._say(TargetsTaken(count))

    def _check_size(self, frame: str | bytes) -> None:
        most = self.limits.max_frame_bytes
        size = len(frame) if isinstance(frame, bytes) or len(frame) > most else len(frame.encode())
        if size > most:
            raise RefusedError(
                "too_large", f"a frame holds at most {most} bytes, received {size}", close=1009
            )

    def _say(self, message: ServerMessage) -> None:
        self.outbox.say(encode(message).decode())

    def _refuse(self, answer: ErrorMessage, count: int = 1) -> None:
        self.refused[answer.code] = self.refused.get(answer.code, 0) + count
        self._say(answer)

    def _end(self, code: Code, message: str, close: int) -> None:
        self._refuse(ErrorMessage(code, message, None, recoverable=False))
        self._close(close, message)

    def _close(self, code: int, reason: str) -> None:
        self.state = "closed"
        self.close = Close(code, reason.encode()[:120].decode(errors="ignore"))
