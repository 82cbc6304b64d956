"""uvicorn's HTTP connection, closed where a header does not come whole in time or in size."""

from __future__ import annotations

import asyncio

from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

HEADER_S = 10.0
"""A header has come whole within this time: from the connection, or from the first byte of a further one."""
HEADER_BYTES = 2**16
"""No browser sends a longer one."""


class PatientProtocol(HttpToolsProtocol):
    """A connection that ends for a client that begins requests and does not go on.

    Bodies and pauses between requests are bounded elsewhere. The bound on bytes is checked after each read,
    so that a header may be longer by as much as is read at once.
    """

    _waiting: asyncio.TimerHandle | None = None  # while a header is to come
    _read = 0  # bytes read meanwhile

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """The first header is to come."""
        super().connection_made(transport)
        self._wait()

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing is to come."""
        self._come()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take in what came, and see that a header does not go on for ever."""
        super().data_received(data)
        if self._waiting is not None:
            self._read += len(data)
            if self._read > HEADER_BYTES:
                self.transport.abort()

    def on_message_begin(self) -> None:
        """A request begins."""
        super().on_message_begin()
        if self._waiting is None:
            self._wait()

    def on_headers_complete(self) -> None:
        """Its header is whole."""
        self._come()
        super().on_headers_complete()

    def _wait(self) -> None:
        self._read = 0
        self._waiting = self.loop.call_later(HEADER_S, self.transport.close)

    def _come(self) -> None:
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None
