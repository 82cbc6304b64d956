"""uvicorn's WebSocket connection, cut off where its last frames are not read."""

from __future__ import annotations

import asyncio
from asyncio.transports import BaseTransport

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol

LINGER_S = 5.0
"""A client may read its last frames and say goodbye for so long."""


class CuttingProtocol(WebSocketsSansIOProtocol):
    """Closing waits until everything written is read, which a client can put off for ever: cut it then.

    Without this a client that stops reading keeps its connection, and the memory of it, although its session
    has ended.
    """

    _cut: asyncio.TimerHandle | None = None

    async def run_asgi(self) -> None:
        """Talk, then give the goodbye a bounded time."""
        await super().run_asgi()
        if self in self.connections:
            self._cut = self.loop.call_later(LINGER_S, self.transport.abort)

    def connection_made(self, transport: BaseTransport) -> None:
        """Begin, with a bound on what may wait to be written."""
        super().connection_made(transport)
        self.transport.set_write_buffer_limits(high=WAITING_BYTES)

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing is left to cut."""
        if self._cut is not None:
            self._cut.cancel()
        super().connection_lost(exc)


WAITING_BYTES = 2**15
"""More than this in the process, and answers wait in the session's outbox, where newer ones replace them."""
