"""What a session says, and how it ends: every way there is, and what the client hears of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from msgspec import Struct

from pointpred.protocol.client_messages import Bye
from pointpred.protocol.server_messages import Code, ErrorMessage, Limits, Score, ServerMessage, encode
from pointpred.server.sessions.outbox import Outbox
from pointpred.server.sessions.stream import Stream, Work
from pointpred.server.sessions.trials import Scoring

State = Literal["connecting", "greeted", "streaming", "closed"]
HELLO_S = 10.0
"""A client says hello within this time."""
SLOW = "the answers are not read"
FAILED = "the server failed; the session ends"


class Close(Struct, frozen=True):
    """How the connection ends."""

    code: int
    reason: str


class Conversation:
    """The side of a session that speaks: what it has said, what it has refused, and whether it has ended."""

    def __init__(self, name: str, limits: Limits, now: float) -> None:
        self.name = name
        self.limits = limits
        self.state: State = "connecting"
        self.outbox = Outbox()
        self.close: Close | None = None
        self.stream: Stream | None = None
        self.work: Scoring | Work | None = None
        """What is to be run before the next frame is taken in."""
        self.refused: dict[Code, int] = {}
        """What was refused, by error code: events that run backwards, frames for all else."""
        self.heard = now
        """When the client was last heard."""
        self.kept_waiting = False
        """Whether the client waits for something to be compiled: its silence is not its own."""
        self._leaving: str | None = None  # why the session is to stop once its work is done

    def tick(self, now: float) -> None:
        """Notice what only time tells: no hello, nothing heard, nothing read."""
        if self.kept_waiting:
            self.heard = now
        silent = now - self.heard
        if self.state == "closed":
            return
        if self.state == "connecting" and silent > HELLO_S:
            self.end("idle", f"expected 'hello' within {HELLO_S:g} s", 1008)
        elif self.state != "connecting" and silent > self.limits.idle_s:
            self.end("idle", f"nothing was heard for {self.limits.idle_s:g} s", 1008)
        elif self.outbox.full:
            self.end("slow", SLOW, 1013)

    def finish(self, found: Score | Callable[[], None]) -> None:
        """Say what came of ``work``."""
        self.work = None
        if self.state != "closed":
            if isinstance(found, Score):
                self.say(found)
            else:
                found()
            if self._leaving is not None:
                self.stop(self._leaving)

    def stop(self, reason: str) -> None:
        """The server stops; work that has begun is finished first."""
        if self.work is not None:
            self._leaving = reason
        elif self.state != "closed":
            self.say(Bye(reason))
            self.shut(1001, reason)

    def fail(self) -> None:
        """Something broke on this side."""
        if self.state != "closed":
            self.end("internal", FAILED, 1011)

    def give_up(self) -> None:
        """The client has not read for too long."""
        if self.state != "closed":
            self.end("slow", SLOW, 1013)

    def lose(self) -> None:
        """The connection is gone: nothing more can be said."""
        if self.state != "closed":
            self.shut(1006, "the connection was lost")

    def say(self, message: ServerMessage | Bye) -> None:
        """Say something that must not be lost."""
        self.outbox.say(encode(message).decode())

    def refuse(self, answer: ErrorMessage, count: int = 1) -> None:
        """Say why something was not used, and count it."""
        self.refused[answer.code] = self.refused.get(answer.code, 0) + count
        self.say(answer)

    def end(self, code: Code, message: str, close: int) -> None:
        """End with an error."""
        self.refuse(ErrorMessage(code, message, None, recoverable=False))
        self.shut(close, message)

    def shut(self, code: int, reason: str) -> None:
        """Nothing is taken in from now on, and the connection is to be closed."""
        self.state = "closed"
        self.close = Close(code, reason.encode()[:120].decode(errors="ignore"))
        if self.stream and self.stream.watch:
            self.stream.watch.close()
