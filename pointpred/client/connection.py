"""A connection for scripts: every call that has an answer waits for it."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, suppress
from types import TracebackType
from typing import Any, Self, TypeVar

from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.sync.client import ClientConnection
from websockets.sync.client import connect as dial
from websockets.typing import Subprotocol

from pointpred.client.dialogue import Dialogue
from pointpred.client.wire import Row, address, authorization
from pointpred.columns import EventColumns, PredictionColumns
from pointpred.errors import SourceError
from pointpred.events import PointerEvent
from pointpred.protocol.client_messages import SUBPROTOCOL, Bye, Goal, Target
from pointpred.protocol.server_messages import (
    Choice,
    Cursor,
    KnownPerson,
    Limits,
    PredictionMessage,
    Score,
    TargetsTaken,
    Welcome,
    encode,
)

Answer = TypeVar("Answer")
QUEUE = 1024
"""Frames kept for a script that does not read; then the service keeps only its newest prediction."""


def connect(url: str, *, token: str | None = None, timeout_s: float = 10.0, **hello: Any) -> Connection:
    """Open a session; use it as a context manager.

    ``url``: of the service or of its stream, http or ws. ``hello``: ``predictor``, ``parameters``,
    ``device``, ``screen``, ``reply``, ``encoding``, ``person`` as in the protocol; binary unless told
    otherwise. No answer for ``timeout_s`` is an error. Raises SourceError where nobody answers, ServiceError
    where the service refuses, ParameterError where a field does not fit.
    """
    dialogue = Dialogue(**hello)
    where = address(url)
    try:
        opened = dial(
            where,
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            additional_headers=authorization(token),
            compression=None,
            max_queue=QUEUE,
            open_timeout=timeout_s,
            proxy=None,
        )
        socket = ExitStack().enter_context(opened)  # websockets 17 wants to be entered; `close` leaves
    except (OSError, InvalidHandshake, TimeoutError) as error:
        raise SourceError(f"cannot connect to {where}: {error}") from error
    connection = Connection(socket, dialogue, timeout_s)
    try:
        connection.greet()
    except BaseException:
        socket.close()
        raise
    return connection


class Connection:
    """One session; made by ``connect``. Not safe for threads."""

    def __init__(self, socket: ClientConnection, dialogue: Dialogue, timeout_s: float) -> None:
        self.dialogue = dialogue
        self.timeout_s = timeout_s
        self._socket = socket

    def greet(self) -> Welcome:
        """Say hello; ``connect`` does."""
        self._say(encode(self.dialogue.hello).decode())
        return self._await(Welcome)

    @property
    def welcome(self) -> Welcome:
        """What the service said last about the session."""
        assert self.dialogue.welcome is not None
        return self.dialogue.welcome

    @property
    def limits(self) -> Limits:
        """What the session may do."""
        return self.welcome.limits

    def send(self, events: EventColumns | Iterable[PointerEvent | Row]) -> int:
        """Send events, in as many frames as the limits ask for; returns how many."""
        count = 0
        for frame in self.dialogue.events(events):
            self._say(frame)
            count += 1
        return count

    def predictions(self) -> Iterator[PredictionMessage]:
        """Predictions in order, until the newest event sent has its own; null where nothing is justified.

        Raises ServiceError for an event that was refused; call again for what comes after.
        """
        while True:
            while (message := self.dialogue.take()) is not None:
                yield message
            if self.dialogue.answered:
                return
            self._hear()

    def columns(self) -> PredictionColumns:
        """The same predictions as a table."""
        while not self.dialogue.answered:
            self._hear()
        return self.dialogue.take_all()

    def poll(self) -> PredictionColumns:
        """The predictions that are there, without waiting."""
        while True:
            try:
                self.dialogue.heard(self._socket.recv(timeout=0))
            except TimeoutError:
                return self.dialogue.take_all()
            except ConnectionClosed as closed:
                raise SourceError(closed_words(closed)) from closed

    def choices(self) -> list[Choice]:
        """What was proposed and retracted since the last call, oldest first, without waiting.

        The choices of an event are received before its prediction: once a prediction is there, so are its
        choices. The newest thousand are kept.
        """
        return self.dialogue.take_choices()

    @property
    def proposed(self) -> str | None:
        """The newest of the targets that are proposed, as far as it was heard."""
        return self.dialogue.proposed

    @property
    def cursor(self) -> Cursor | None:
        """Where the service has put the cursor, in a session opened with ``assist``; newest heard."""
        return self.dialogue.cursor

    def targets(self, targets: Iterable[dict[str, Any] | Target]) -> int:
        """Replace the set of targets; returns how many the service holds."""
        self._say(self.dialogue.targets(targets))
        return self._await(TargetsTaken).count

    def trial(self, action: str, target: dict[str, float] | Goal | None = None) -> Score | None:
        """A movement starts, or has ended; the end returns its score."""
        self._say(self.dialogue.trial(action, target))
        return self._await(Score) if action == "end" else None

    def configure(self, **changes: Any) -> Welcome:
        """Change ``predictor``, ``parameters``, ``reply``, ``precision``, ``assist``; the rest stays."""
        self._say(self.dialogue.configure(**changes))
        answer = self._await(Welcome)
        self.dialogue.configured(**changes)
        return answer

    def person(self, known: str | None = None) -> str:
        """What finished movements taught of the person, for ``person=`` of another session; "" for nobody.

        ``known``, where it is given, replaces it, and the session begins anew; "" forgets the person. The
        movement that goes on is not in it: ``reset`` finishes it.
        """
        self._say(self.dialogue.person(known))
        return self._await(KnownPerson).person

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self._say(self.dialogue.reset())

    def close(self) -> None:
        """Take leave; twice is as good as once."""
        # Nothing more is taken from the socket while a full queue waits: not even the other side's goodbye.
        emptying = threading.Thread(target=self._empty, name="leaving", daemon=True)
        emptying.start()
        try:
            self._socket.send(encode(Bye()).decode())
        except ConnectionClosed:
            return
        finally:
            self._socket.close()
            emptying.join()

    def _empty(self) -> None:
        with suppress(ConnectionClosed):
            while True:
                self._socket.recv()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _say(self, frame: str | bytes) -> None:
        try:
            self._socket.send(frame)
        except ConnectionClosed as closed:
            self._last_words()
            raise SourceError(closed_words(closed)) from closed

    def _last_words(self) -> None:
        """What the service said before it left, where it said why: raises ServiceError."""
        try:
            while True:
                self.dialogue.heard(self._socket.recv(timeout=0))
        except (ConnectionClosed, TimeoutError):
            return

    def _hear(self, timeout_s: float | None = None) -> Any:
        try:
            received = self._socket.recv(timeout=self.timeout_s if timeout_s is None else timeout_s)
            return self.dialogue.heard(received)
        except TimeoutError:
            raise silent(self.timeout_s) from None
        except ConnectionClosed as closed:
            raise SourceError(closed_words(closed)) from closed

    def _await(self, kind: type[Answer]) -> Answer:
        """The next answer of a kind; predictions that come before it are kept."""
        until = time.monotonic() + self.timeout_s
        while (left := until - time.monotonic()) > 0.0:
            message = self._hear(left)
            if isinstance(message, kind):
                return message
        raise silent(self.timeout_s)


def silent(timeout_s: float) -> SourceError:
    """The answer that was awaited did not come."""
    return SourceError(f"the service did not answer for {timeout_s:g} s")


def closed_words(closed: ConnectionClosed) -> str:
    """How the service took leave."""
    said = closed.rcvd
    if said is None:
        return "the connection to the service was lost"
    return f"the service closed the session: {said.code} {said.reason}".rstrip()
