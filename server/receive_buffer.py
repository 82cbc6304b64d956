"""Buffers the messages of a client while code is still being compiled, and notices that it leaves."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Coroutine
from typing import Any

from pointpred.server.connection import Message, Receive

MOST_MESSAGES = 4096
MOST_BYTES = 1 << 20
"""What is read from a client while it waits. Only by reading does the service notice that a client has left.
A client that sends more than this is read again after the wait."""


class ReceiveBuffer:
    """Delivers the messages of a client in order, each once what it needs is there.

    ``prepare`` returns what to wait for before a message is delivered, ``None`` where there is nothing.
    A message that had to wait has the time of its arrival as ``received_at``: limits go by that time.
    """

    def __init__(
        self,
        receive: Receive,
        prepare: Callable[[Message], Coroutine[Any, Any, None] | None],
        clock: Callable[[], float] | None = None,
    ) -> None:
        """``clock`` gives seconds; the loop's own where none is given."""
        self._clock = clock
        self._receive = receive
        self._prepare = prepare
        self._messages: deque[Message] = deque()
        self._bytes = 0
        self._next_message: asyncio.Future[Message] | None = None

    async def wait_for(self, preparation: Coroutine[Any, Any, None]) -> bool:
        """Whether the client is still there once ``preparation`` has ended; it is cancelled where not."""
        waiting = asyncio.ensure_future(preparation)
        clock = self._clock or asyncio.get_running_loop().time
        try:
            while not waiting.done() and len(self._messages) < MOST_MESSAGES and self._bytes < MOST_BYTES:
                arriving = self._next_message = self._next_message or asyncio.ensure_future(self._receive())
                both: set[asyncio.Future[Any]] = {waiting, arriving}
                await asyncio.wait(both, return_when=asyncio.FIRST_COMPLETED)
                if arriving.done():
                    self._next_message = None
                    message = arriving.result()
                    self._messages.append(message)
                    if message["type"] == "websocket.disconnect":
                        return False
                    message["received_at"] = clock()
                    self._bytes += len(message.get("text") or message.get("bytes") or "")
            await waiting
            return True
        finally:
            waiting.cancel()

    async def __call__(self) -> Message:
        """The next message; that the client has left is delivered at once."""
        message = await self._pop()
        preparation = self._prepare(message)
        if preparation is not None and not await self.wait_for(preparation):
            return self._messages[-1]
        return message

    async def _pop(self) -> Message:
        if self._messages:
            return self._messages.popleft()
        if self._next_message is not None:
            arriving, self._next_message = self._next_message, None
            return await arriving
        return await self._receive()

    def close(self) -> None:
        """Nobody asks for more."""
        if self._next_message is not None:
            self._next_message.cancel()
