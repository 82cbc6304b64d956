"""uvicorn's HTTP protocol, which closes a connection whose request header is too slow or too long."""

from __future__ import annotations

import asyncio

from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

HEADER_S = 10.0
"""So long a header may take: from the connection, or from the first byte of a further request."""
HEADER_BYTES = 2**16
"""No browser sends a longer one."""


class BoundedHttpProtocol(HttpToolsProtocol):
    """A connection that is closed where the client begins a request and does not go on.

    Bodies and pauses between requests are bounded elsewhere. The bound on bytes is checked after each read,
    so that a header may be longer by as much as is read at once.
    """

    _header_timer: asyncio.TimerHandle | None = None  # runs while a header is incomplete
    _header_bytes = 0

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """The first header is expected."""
        super().connection_made(transport)
        self._expect_header()

    def connection_lost(self, exc: Exception | None) -> None:
        """No header is expected any more."""
        self._stop_timer()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Parse received data, and bound the length of a header."""
        super().data_received(data)
        if self._header_timer is not None:
            self._header_bytes += len(data)
            if self._header_bytes > HEADER_BYTES:
                self.transport.abort()

    def on_message_begin(self) -> None:
        """A request begins."""
        super().on_message_begin()
        if self._header_timer is None:
            self._expect_header()

    def on_headers_complete(self) -> None:
        """Its header is complete."""
        self._stop_timer()
        super().on_headers_complete()

    def _expect_header(self) -> None:
        self._header_bytes = 0
        self._header_timer = self.loop.call_later(HEADER_S, self.transport.close)

    def _stop_timer(self) -> None:
        if self._header_timer is not None:
            self._header_timer.cancel()
            self._header_timer = None
