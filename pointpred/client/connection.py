"""Connections for scripts and for asyncio: every call that has an answer waits for it."""

from __future__ import annotations

import asyncio
import ssl
import threading
import time
from collections.abc import AsyncIterator, Iterable, Iterator
from contextlib import ExitStack, suppress
from types import TracebackType
from typing import Any, Self, TypeVar

from msgspec import Struct
from websockets.asyncio.client import ClientConnection as AsyncSocket
from websockets.asyncio.client import connect as dial_async
from websockets.exceptions import ConnectionClosed, InvalidHandshake
from websockets.sync.client import ClientConnection as Socket
from websockets.sync.client import connect as dial

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
from pointpred.protocol.client_messages import Conditions, Goal, Hello, Rectangle
from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import KnownPerson, PredictionMessage, Score, TargetsTaken, Welcome
from pointpred.records import EventColumns, PointerEvent, PredictionColumns

Answer = TypeVar("Answer", bound=Struct)


def _encryption(address: str) -> ssl.SSLContext | None:
    """TLS 1.2 for wss.

    websockets reads on one thread and writes on another. With TLS 1.3, in which a server sends tickets after
    the handshake, one request in 300 had no answer; with TLS 1.2 none of 4,353.
    """
    if not address.startswith("wss:"):
        return None
    context = ssl.create_default_context()
    context.maximum_version = ssl.TLSVersion.TLSv1_2
    return context


def connect(url: str, *, token: str | None = None, timeout_s: float = 10.0, **hello: Any) -> Connection:
    """Open a session; use it as a context manager.

    ``url``: of the service or of its stream, http or ws. ``hello``: ``predictor``, ``parameters``,
    ``device``, ``screen``, ``reply``, ``encoding``, ``person`` as in the protocol; ``encoding`` is binary by
    default. No answer for ``timeout_s`` is an error. Raises SourceError where the service cannot be reached,
    ServiceError where it refuses, ParameterError where a field does not fit.
    """
    message, address = hello_message(**hello), service_address(url)
    try:
        opened = dial(address, ssl=_encryption(address), **dial_options(token, timeout_s))
        socket = ExitStack().enter_context(opened)  # websockets 17 wants to be entered; `close` leaves
    except (OSError, InvalidHandshake, TimeoutError) as error:
        raise no_connection(address, error) from error
    connection = Connection(socket, message, timeout_s)
    try:
        connection.start()
    except BaseException:
        socket.close()
        raise
    return connection


class Connection(ClientSession):
    """One session; made by ``connect``. Not safe for threads."""

    def __init__(self, socket: Socket, hello: Hello, timeout_s: float) -> None:
        super().__init__(hello, timeout_s)
        self._socket = socket

    def start(self) -> Welcome:
        """Send hello; ``connect`` does."""
        return self._ask(self.hello_frame(), Welcome)

    def send(self, events: EventColumns | Iterable[PointerEvent | Row]) -> int:
        """Send events, in as many frames as the limits ask for; returns how many."""
        count = 0
        for frame in self.event_frames(events):
            self._send(frame)
            count += 1
        return count

    def predictions(self) -> Iterator[PredictionMessage]:
        """Predictions in order, until the newest event sent has its own; null where nothing is justified.

        Raises ServiceError for an event that was refused; call again for what comes after.
        """
        while True:
            while (message := self.take()) is not None:
                yield message
            if self.answered:
                return
            self._receive(self.timeout_s)

    def columns(self) -> PredictionColumns:
        """The same predictions as a table."""
        while not self.answered:
            self._receive(self.timeout_s)
        return self.take_all()

    def poll(self) -> PredictionColumns:
        """The predictions that are there, without waiting."""
        while True:
            try:
                self.receive(self._socket.recv(timeout=0))
            except TimeoutError:
                return self.take_all()
            except ConnectionClosed as closed:
                raise connection_closed(closed) from closed

    def targets(self, targets: Iterable[dict[str, Any] | Rectangle]) -> int:
        """Replace the set of targets; returns how many the service has."""
        return self._ask(self.targets_frame(targets), TargetsTaken).count

    def trial(
        self,
        action: str,
        target: dict[str, float] | Goal | None = None,
        conditions: Conditions | None = None,
    ) -> Score | None:
        """Mark that a movement starts, or has ended; the end returns its score.

        ``conditions``: what the trial is (block, participant, ...), which a service that records keeps beside
        it; those of the end add to those of the start, and all trials have the names of the first.
        """
        frame = self.trial_frame(action, target, conditions)
        if action == "end":
            return self._ask(frame, Score)
        self._send(frame)
        return None

    def configure(self, **changes: Any) -> Welcome:
        """Change ``predictor``, ``parameters``, ``reply``, ``precision``, ``assist`` or ``places``."""
        welcome = self._ask(self.configure_frame(**changes), Welcome)
        self.configured(**changes)
        return welcome

    def person(self, known: str | None = None) -> str:
        """What finished movements taught of the person, for ``person=`` of another session; "" for nobody.

        ``known``, where it is given, replaces it, and the session begins anew; "" forgets the person. A
        movement that still goes on is not in it: ``reset`` finishes it.
        """
        return self._ask(self.person_frame(known), KnownPerson).person

    def enter(self, key: str, x: float = 0.0, y: float = 0.0) -> None:
        """The next movement is in this window or page, whose origin is at (x, y) px.

        Places are remembered for each ``key``, relative to the origin. Raises ParameterError where a value
        does not fit.
        """
        self._send(self.enter_frame(key, x, y))

    def forget(self) -> str:
        """Forget the person and the movement; returns what is then known: "". The window stays."""
        return self._ask(self.forget_frame(), KnownPerson).person

    def reset(self) -> None:
        """Forget every event: the next one starts a movement."""
        self._send(self.reset_frame())

    def close(self) -> None:
        """End the session; a second call does nothing."""
        # While a full queue waits, nothing more is read from the socket: not even the close of the service.
        emptying = threading.Thread(target=self._empty, name="closing", daemon=True)
        emptying.start()
        try:
            self._socket.send(self.bye_frame())
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

    def _send(self, frame: Frame) -> None:
        try:
            self._socket.send(frame)
        except ConnectionClosed as closed:
            self._receive_rest()
            raise connection_closed(closed) from closed

    def _receive_rest(self) -> None:
        """Receive what the service sent before it closed: raises ServiceError where it sent why."""
        try:
            while True:
                self.receive(self._socket.recv(timeout=0))
        except (ConnectionClosed, TimeoutError):
            return

    def _receive(self, timeout_s: float) -> Struct | None:
        try:
            return self.receive(self._socket.recv(timeout=timeout_s))
        except TimeoutError:
            raise no_answer(self.timeout_s) from None
        except ConnectionClosed as closed:
            raise connection_closed(closed) from closed

    def _ask(self, frame: Frame, kind: type[Answer]) -> Answer:
        """Send a frame and wait for the answer of a kind; predictions that come before it are kept."""
        self._send(frame)
        deadline = time.monotonic() + self.timeout_s
        while (left_s := deadline - time.monotonic()) > 0.0:
            message = self._receive(left_s)
            if isinstance(message, kind):
                return message
        raise no_answer(self.timeout_s)


async def connect_async(
    url: str, *, token: str | None = None, timeout_s: float = 10.0, **hello: Any
) -> AsyncConnection:
    """Open a session as ``connect`` does, and wait for it: ``async with await ...``."""
    message, address = hello_message(**hello), service_address(url)
    try:
        socket = await dial_async(address, **dial_options(token, timeout_s))
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

    def __init__(self, socket: AsyncSocket, hello: Hello, timeout_s: float) -> None:
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

    async def targets(self, targets: Iterable[dict[str, Any] | Rectangle]) -> int:
        """Replace the set of targets; returns how many the service has."""
        return (await self._ask(self.targets_frame(targets), TargetsTaken)).count

    async def trial(
        self,
        action: str,
        target: dict[str, float] | Goal | None = None,
        conditions: Conditions | None = None,
    ) -> Score | None:
        """Mark that a movement starts, or has ended; the end returns its score: as ``Connection.trial``."""
        frame = self.trial_frame(action, target, conditions)
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
