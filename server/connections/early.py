"""A client that connects while code is still being compiled: its messages wait, and leaving is noticed."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable, Coroutine, MutableMapping
from typing import Any

Message = MutableMapping[str, Any]

MOST = 4096
MOST_BYTES = 1 << 20
"""Frames read from the client while it waits, and their size in bytes. Only by reading does the service
notice that a client has left. A client that sends more than this is read again after the wait."""


class Early:
    """Hands on what a client sends, each message once what it needs is there.

    ``lacks`` gives what there is to wait for before a message is handed on, ``None`` where there is nothing.
    A message that had to wait says under ``heard`` when it came: limits go by that time.
    """

    def __init__(
        self,
        receive: Callable[[], Awaitable[Message]],
        lacks: Callable[[Message], Coroutine[Any, Any, None] | None],
        clock: Callable[[], float] | None = None,
    ) -> None:
        """``clock`` gives seconds, as the loop's own, which is taken where none is given."""
        self._clock = clock
        self._receive = receive
        self._lacks = lacks
        self._heard: deque[Message] = deque()
        self._bytes = 0
        self._coming: asyncio.Future[Message] | None = None

    async def stays(self, until: Coroutine[Any, Any, None]) -> bool:
        """Whether the client is still there at the end of ``until``, which is given up where it is not."""
        waiting = asyncio.ensure_future(until)
        clock = self._clock or asyncio.get_running_loop().time
        try:
            while not waiting.done() and len(self._heard) < MOST and self._bytes < MOST_BYTES:
                coming = self._coming = self._coming or asyncio.ensure_future(self._receive())
                both: set[asyncio.Future[Any]] = {waiting, coming}
                await asyncio.wait(both, return_when=asyncio.FIRST_COMPLETED)
                if coming.done():
                    self._coming = None
                    message = coming.result()
                    if message["type"] == "websocket.disconnect":
                        self._heard.append(message)
                        return False
                    message["heard"] = clock()
                    self._heard.append(message)
                    self._bytes += len(message.get("text") or message.get("bytes") or "")
            await waiting
            return True
        finally:
            waiting.cancel()

    async def __call__(self) -> Message:
        """What comes next, in order; that the client has left comes at once."""
        message = await self._next()
        if (until := self._lacks(message)) is not None and not await self.stays(until):
            return self._heard[-1]
        return message

    async def _next(self) -> Message:
        if self._heard:
            return self._heard.popleft()
        if self._coming is not None:
            coming, self._coming = self._coming, None
            return await coming
        return await self._receive()

    def leave(self) -> None:
        """Nobody asks for more."""
        if self._coming is not None:
            self._coming.cancel()
