"""The same calls for asyncio."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Iterable
from types import TracebackType
from typing import Any, Self, TypeVar

from websockets.asyncio.client import ClientConnection
from websockets.asyncio.client import connect as dial
from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.typing import Subprotocol

from pointpred.client.connection import QUEUE, closed_words, silent
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


async def connect_async(
    url: str, *, token: str | None = None, timeout_s: float = 10.0, **hello: Any
) -> AsyncConnection:
    """Open a session as ``connect`` does, and wait for it: ``async with await ...``."""
    dialogue = Dialogue(**hello)
    where = address(url)
    try:
        socket = await dial(
            where,
            subprotocols=[Subprotocol(SUBPROTOCOL)],
            additional_headers=authorization(token),
            compression=None,
            max_queue=QUEUE,
            open_timeout=timeout_s,
            proxy=None,
        )
    except (OSError, InvalidHandshake, TimeoutError) as error:
        raise SourceError(f"cannot connect to {where}: {error}") from error
    connection = AsyncConnection(socket, dialogue, timeout_s)
    try:
        await connection.greet()
    except BaseException:
        await socket.close()
        raise
    return connection


class AsyncConnection:
    """One session; made by ``connect_async``. One task at a time waits for answers."""

    def __init__(self, socket: ClientConnection, dialogue: Dialogue, timeout_s: float) -> None:
        self.dialogue = dialogue
        self.timeout_s = timeout_s
        self._socket = socket

    async def greet(self) -> Welcome:
        """Say hello; ``connect_async`` does."""
        await self._say(encode(self.dialogue.hello).decode())
        return await self._await(Welcome)

    @property
    def welcome(self) -> Welcome:
        """What the service said last about the session."""
        assert self.dialogue.welcome is not None
        return self.dialogue.welcome

    @property
    def limits(self) -> Limits:
        """What the session may do."""
        return self.welcome.limits

    async def send(self, events: EventColumns | Iterable[PointerEvent | Row]) -> int:
        """Send events, in as many frames as the limits ask for; returns how many."""
        count = 0
        for frame in self.dialogue.events(events):
            await self._say(frame)
            count += 1
        return count

    async def predictions(self) -> AsyncIterator[PredictionMessage]:
        """Predictions in order, until the newest event sent has its own."""
        while True:
            while (message := self.dialogue.take()) is not None:
                yield message
            if self.dialogue.answered:
                return
            await self._hear()

    async def columns(self) -> PredictionColumns:
        """The same predictions as a table."""
        while not self.dialogue.answered:
            await self._hear()
        return self.dialogue.take_all()

    async def poll(self) -> PredictionColumns:
        """The predictions that are there, without waiting."""
        for _ in range(2):
            await asyncio.sleep(0)  # a turn of the loop to look at the socket, one to read it
        while True:
            try:
                async with asyncio.timeout(0.0):
                    self.dialogue.heard(await self._socket.recv())
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

    async def targets(self, targets: Iterable[dict[str, Any] | Target]) -> int:
        """Replace the set of targets; returns how many the service holds."""
        await self._say(self.dialogue.targets(targets))
        return (await self._await(TargetsTaken)).count

    async def trial(self, action: str, target: dict[str, float] | Goal | None = None) -> Score | None:
        """A movement starts, or has ended; the end returns its score."""
        await self._say(self.dialogue.trial(action, target))
        return await self._await(Score) if action == "end" else None

    async def configure(self, **changes: Any) -> Welcome:
        """Change ``predictor``, ``parameters``, ``reply``, ``precision``, ``assist``; the rest stays."""
        await self._say(self.dialogue.configure(**changes))
        answer = await self._await(Welcome)
        self.dialogue.configured(**changes)
        return answer

    async def person(self, known: str | None = None) -> str:
        """What finished movements taught of the person, for ``person=`` of another session; "" for nobody.

        ``known``, where it is given, replaces it, and the session begins anew; "" forgets the person. The
        movement that goes on is not in it: ``reset`` finishes it.
        """
        await self._say(self.dialogue.person(known))
        return (await self._await(KnownPerson)).person

    async def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        await self._say(self.dialogue.reset())

    async def close(self) -> None:
        """Take leave; twice is as good as once."""
        try:
            await self._socket.send(encode(Bye()).decode())
        except ConnectionClosed:
            return
        finally:
            await self._socket.close()

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    async def _say(self, frame: str | bytes) -> None:
        try:
            await self._socket.send(frame)
        except ConnectionClosed as closed:
            await self._last_words()
            raise SourceError(closed_words(closed)) from closed

    async def _last_words(self) -> None:
        """What the service said before it left, where it said why: raises ServiceError."""
        try:
            async with asyncio.timeout(self.timeout_s):
                while True:
                    self.dialogue.heard(await self._socket.recv())
        except (ConnectionClosed, TimeoutError):
            return

    async def _hear(self, timeout_s: float | None = None) -> Any:
        try:
            async with asyncio.timeout(self.timeout_s if timeout_s is None else timeout_s):
                return self.dialogue.heard(await self._socket.recv())
        except TimeoutError:
            raise silent(self.timeout_s) from None
        except ConnectionClosed as closed:
            raise SourceError(closed_words(closed)) from closed

    async def _await(self, kind: type[Answer]) -> Answer:
        """The next answer of a kind; predictions that come before it are kept."""
        loop = asyncio.get_running_loop()
        until = loop.time() + self.timeout_s
        while (left := until - loop.time()) > 0.0:
            message = await self._hear(left)
            if isinstance(message, kind):
                return message
        raise silent(self.timeout_s)
