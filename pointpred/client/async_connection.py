"""The calls of ``Connection`` for asyncio."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Iterable
from types import TracebackType
from typing import Any, Self, TypeVar

from msgspec import Struct
from websockets.asyncio.client import ClientConnection
from websockets.asyncio.client import connect as dial
from websockets.exceptions import ConnectionClosed, InvalidHandshake

from pointpred.client.session import (
    ClientSession,
    Row,
    connection_closed,
    dial_options,
    hello_message,
    no_answer,
    no_connection,
    service_address,
)
from pointpred.protocol.client_messages import Goal, Hello, Target
from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import KnownPerson, PredictionMessage, Score, TargetsTaken, Welcome
from pointpred.records import EventColumns, PointerEvent, PredictionColumns

Answer = TypeVar("Answer", bound=Struct)


async def connect_async(
    url: str, *, token: str | None = None, timeout_s: float = 10.0, **hello: Any
) -> AsyncConnection:
    """Open a session as ``connect`` does, and wait for it: ``async with await ...``."""
    message, address = hello_message(**hello), service_address(url)
    try:
        socket = await dial(address, **dial_options(token, timeout_s))
    except (OSError, InvalidHandshake, TimeoutError) as error:
        raise no_connection(address, error) from error
    connection = AsyncConnection(socket, message, timeout_s)
    try:
        await connection.start()
    except BaseException:
        await socket.close()
        raise
    return connection


class AsyncConnection(ClientSession):
    """One session; made by ``connect_async``. One task at a time waits for answers."""

    def __init__(self, socket: ClientConnection, hello: Hello, timeout_s: float) -> None:
        super().__init__(hello, timeout_s)
        self._socket = socket

    async def start(self) -> Welcome:
        """Send hello; ``connect_async`` does."""
        return await self._ask(self.hello_frame(), Welcome)

    async def send(self, events: EventColumns | Iterable[PointerEvent | Row]) -> int:
        """Send events, in as many frames as the limits ask for; returns how many."""
        count = 0
        for frame in self.event_frames(events):
            await self._send(frame)
            count += 1
        return count

    async def predictions(self) -> AsyncIterator[PredictionMessage]:
        """Predictions in order, until the newest event sent has its own."""
        while True:
            while (message := self.take()) is not None:
                yield message
            if self.answered:
                return
            await self._receive(self.timeout_s)

    async def columns(self) -> PredictionColumns:
        """The same predictions as a table."""
        while not self.answered:
            await self._receive(self.timeout_s)
        return self.take_all()

    async def poll(self) -> PredictionColumns:
        """The predictions that are there, without waiting."""
        for _ in range(2):
            await asyncio.sleep(0)  # a turn of the loop to look at the socket, one to read it
        while True:
            try:
                async with asyncio.timeout(0.0):
                    self.receive(await self._socket.recv())
            except TimeoutError:
                return self.take_all()
            except ConnectionClosed as closed:
                raise connection_closed(closed) from closed

    async def targets(self, targets: Iterable[dict[str, Any] | Target]) -> int:
        """Replace the set of targets; returns how many the service has."""
        return (await self._ask(self.targets_frame(targets), TargetsTaken)).count

    async def trial(self, action: str, target: dict[str, float] | Goal | None = None) -> Score | None:
        """Mark that a movement starts, or has ended; the end returns its score."""
        frame = self.trial_frame(action, target)
        if action == "end":
            return await self._ask(frame, Score)
        await self._send(frame)
        return None

    async def configure(self, **changes: Any) -> Welcome:
        """Change ``predictor``, ``parameters``, ``reply``, ``precision``, ``assist`` or ``places``."""
        welcome = await self._ask(self.configure_frame(**changes), Welcome)
        self.configured(**changes)
        return welcome

    async def person(self, known: str | None = None) -> str:
        """What is known of the person, or begin anew with ``known``: as ``Connection.person``."""
        return (await self._ask(self.person_frame(known), KnownPerson)).person

    async def enter(self, key: str, x: float = 0.0, y: float = 0.0) -> None:
        """The next movement is in this window or page, whose origin is at (x, y) px.

        Places are remembered for each ``key``, relative to the origin. Raises ParameterError where a value
        does not fit.
        """
        await self._send(self.enter_frame(key, x, y))

    async def forget(self) -> str:
        """Forget the person and the movement; returns what is then known: "". The window stays."""
        return (await self._ask(self.forget_frame(), KnownPerson)).person

    async def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        await self._send(self.reset_frame())

    async def close(self) -> None:
        """End the session; a second call does nothing."""
        try:
            await self._socket.send(self.bye_frame())
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

    async def _send(self, frame: Frame) -> None:
        try:
            await self._socket.send(frame)
        except ConnectionClosed as closed:
            await self._receive_rest()
            raise connection_closed(closed) from closed

    async def _receive_rest(self) -> None:
        """Receive what the service sent before it closed: raises ServiceError where it sent why."""
        try:
            async with asyncio.timeout(self.timeout_s):
                while True:
                    self.receive(await self._socket.recv())
        except (ConnectionClosed, TimeoutError):
            return

    async def _receive(self, timeout_s: float) -> Struct | None:
        try:
            async with asyncio.timeout(timeout_s):
                return self.receive(await self._socket.recv())
        except TimeoutError:
            raise no_answer(self.timeout_s) from None
        except ConnectionClosed as closed:
            raise connection_closed(closed) from closed

    async def _ask(self, frame: Frame, kind: type[Answer]) -> Answer:
        """Send a frame and wait for the answer of a kind; predictions that come before it are kept."""
        await self._send(frame)
        loop = asyncio.get_running_loop()
        deadline = loop.time() + self.timeout_s
        while (left_s := deadline - loop.time()) > 0.0:
            message = await self._receive(left_s)
            if isinstance(message, kind):
                return message
        raise no_answer(self.timeout_s)
