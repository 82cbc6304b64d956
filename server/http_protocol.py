"""uvicorn's HTTP protocol, with bounds on what a client may send around the requests of the application."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from http import HTTPStatus
from typing import Any

from httptools import HttpParserError, HttpParserUpgrade
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol, RequestResponseCycle

from pointpred.protocol.server_messages import Code
from pointpred_server.access import usual_address
from pointpred_server.http_reading import HeldReading
from pointpred_server.request_rates import REQUESTS_PER_S, RequestRates
from pointpred_server.request_refusal import Refusal
from pointpred_server.upgrade import check_upgrade, upgrade_request
from pointpred_server.websocket_protocol import BoundedWebSocketProtocol

log = logging.getLogger("pointpred.service")

PIECE_BYTES = 2**13
"""Received data is parsed in pieces of this size, and others have their turn in between: a parser calls back
for each header and each chunk, and a read of 250 kB may hold 60,000 of them."""
HEADER_S = 10.0
"""So long a header may take: from the connection, or from the first byte of a further request."""
HEADER_BYTES = 2**16
"""No browser sends a longer one: names, values and the path together."""
HEADER_LINES = 256
"""Headers of one request."""
TARGET_BYTES = 2**12
"""The path and the query of a request; a query of 64 kB would take tens of ms to read."""
TARGET_FIELDS = 64
"""Parameters of a query, each of which costs time, however short it is."""
PIPELINED = 16
"""Further requests that wait for the first one's response; no browser sends one."""
CHUNKS = 2**14
"""Chunks of a body, each of which costs time, however short it is: those of the longest recording may hold
1 KiB each."""
BODY_BYTES = 2**24
"""Bytes of a body that are thrown away after the response; the connection is closed 5 s after the response,
however much of the body still comes."""
UNREAD_S = 10.0
"""So long a client may read nothing of what is sent to it."""
DRAIN_S = 2.0
"""So long a client whose request is refused may take to read why ..."""
DRAIN_BYTES = 2**20
"""... and so much may it still send. Closing at once would reset the connection, and lose the response."""

TOO_LONG = Refusal(
    HTTPStatus.REQUEST_HEADER_FIELDS_TOO_LARGE,
    "too_large",
    f"the header of a request holds at most {HEADER_BYTES} bytes in {HEADER_LINES} lines",
)
LONG_TARGET = Refusal(
    HTTPStatus.REQUEST_URI_TOO_LONG,
    "too_large",
    f"the path and query of a request hold at most {TARGET_BYTES} bytes, and {TARGET_FIELDS} parameters",
)
TRAILER = Refusal(
    HTTPStatus.BAD_REQUEST, "bad_field", "a request has no trailers: send its headers before its body"
)
MANY_CHUNKS = Refusal(
    HTTPStatus.REQUEST_ENTITY_TOO_LARGE,
    "too_large",
    f"the body of a request holds at most {CHUNKS} chunks: send longer ones, or its Content-Length",
)
EARLY_UPGRADE = Refusal(
    HTTPStatus.BAD_REQUEST,
    "out_of_place",
    "a WebSocket is opened after the responses to earlier requests have been read",
)
NO_HTTP = Refusal(HTTPStatus.BAD_REQUEST, "bad_field", "expected an HTTP request")
TOO_MANY = Refusal(
    HTTPStatus.TOO_MANY_REQUESTS, "too_many", f"at most {PIPELINED} requests may wait for their responses"
)
TOO_OFTEN = Refusal(
    HTTPStatus.TOO_MANY_REQUESTS,
    "too_fast",
    f"at most {REQUESTS_PER_S} requests a second of one address are answered by a worker in the long run",
)


class BoundedHttpProtocol(HttpToolsProtocol):
    """A connection that is closed where the client begins a request, or to read a response, and stops there.

    The body of a request is bounded by what reads it; what of it is left after the response is bounded here.
    """

    flow: HeldReading
    _unparsed = b""  # received data that waits for its turn; nothing more is read meanwhile
    _turn: asyncio.Handle | None = None  # when a piece of it is parsed
    _header_timer: asyncio.TimerHandle | None = None  # runs while a header is incomplete
    _header_bytes = 0  # received while a header is incomplete
    _in_body = False
    _body_bytes = 0
    _chunks = 0  # of this body
    _running: RequestResponseCycle | None = None  # what is answered now; ``cycle`` is the newest request
    _refused = False  # nothing more is parsed
    _linger_timer: asyncio.TimerHandle | None = None  # runs while a client may read why it was refused
    _unread_timer: asyncio.TimerHandle | None = None  # runs while the kernel does not take what is sent
    _unread = 0  # bytes that were thrown away

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """The first header is expected."""
        super().connection_made(transport)
        self.flow = HeldReading(transport)
        self.client = usual_address(self.client)
        self.transport.set_write_buffer_limits(high=0)  # writing pauses as soon as anything is left unsent
        self._expect_header()

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing is expected any more."""
        self._stop_header_timer()
        self._stop_unread_timer()
        self._unparsed = b""
        if self._turn is not None:
            self._turn.cancel()
        if self._linger_timer is not None:
            self._linger_timer.cancel()
        if self._running is not None:
            self._running.disconnected = True
            self._running.message_event.set()
        super().connection_lost(exc)

    def pause_writing(self) -> None:
        """Something is left unsent; the client has some time to read."""
        super().pause_writing()
        self._expect_reading()

    def resume_writing(self) -> None:
        """Everything has been sent."""
        self._stop_unread_timer()
        super().resume_writing()

    def data_received(self, data: bytes) -> None:
        """Parse received data; the rest of much data waits until others had their turn."""
        if self._unparsed:
            self._unparsed += data
        elif len(data) <= PIECE_BYTES:
            self._parse(data)
        else:
            self._unparsed = data
            self._take_turn()

    def _take_turn(self) -> None:
        """Parse one piece of what waits."""
        size = max(PIECE_BYTES, self._body_left() if self._in_body else 0)
        data, self._unparsed, self._turn = self._unparsed[:size], self._unparsed[size:], None
        self._parse(data)
        if self._unparsed and not self.transport.is_closing():
            self.flow.hold()
            self._turn = self.loop.call_soon(self._take_turn)
        else:
            self._unparsed = b""
            self.flow.release()

    def _body_left(self) -> int:
        """Bytes that are still to come of a body of a given length: they are parsed as one."""
        given = [value for name, value in self.headers if name == b"content-length"]
        return int(given[0]) - self._body_bytes if given else 0

    def _parse(self, data: bytes) -> None:
        """Parse one piece, and bound the length of a header that is not complete."""
        if self._refused:
            self._throw_away(len(data), DRAIN_BYTES)
            return
        try:
            self.parser.feed_data(data)
        except HttpParserUpgrade as upgrade:
            if self._should_upgrade():
                early, self._unparsed = data[upgrade.args[0] :] + self._unparsed, b""
                self.handle_websocket_upgrade()
                if early and not self._refused and not self.transport.is_closing():
                    self.transport.get_protocol().data_received(early)  # type: ignore[attr-defined]
        except HttpParserError:
            self._refuse(NO_HTTP)
        if self._header_timer is not None:
            self._header_bytes += len(data)
            if self._header_bytes > HEADER_BYTES:
                self._refuse(TOO_LONG)

    def handle_websocket_upgrade(self) -> None:
        """Hand the connection to a WebSocket, with the request that has been parsed."""
        url, fields = self.url, self.headers
        refusal = check_upgrade(self.parser.get_method(), self.parser.get_http_version(), url, fields)
        if self.flow.write_paused or (self.cycle is not None and not self.cycle.response_complete):
            # Nobody would tell that response to go on, or that the client has gone; nor would the session
            # learn that the client does not read, which the transport says once.
            refusal = EARLY_UPGRADE
        if refusal is not None:
            self._refuse(refusal)
        if self._refused:
            return
        self.flow.release()  # from now on the bounds are those of a WebSocket
        self.connections.discard(self)
        protocol = BoundedWebSocketProtocol(self.config, self.server_state, self.app_state)
        protocol.connection_made(self.transport)
        self.transport.set_protocol(protocol)
        if not protocol.open(upgrade_request(url, fields)):
            self.on_refusal("bad_field")

    def on_refusal(self, code: Code) -> None:
        """A request was refused before the application saw it."""

    def take_request(self) -> bool:
        """Whether one more request of this client is answered."""
        return True

    def on_message_begin(self) -> None:
        """A request begins."""
        super().on_message_begin()
        self._in_body, self._unread, self._body_bytes, self._chunks = False, 0, 0, 0
        self._unset_keepalive_if_required()
        if self._header_timer is None:
            self._expect_header()

    def on_header(self, name: bytes, value: bytes) -> None:
        """A line of its header; one behind a body is kept by nobody."""
        if self._in_body:
            self._refuse(TRAILER)
        elif len(self.headers) >= HEADER_LINES:
            self._refuse(TOO_LONG)
        elif not self._refused:
            super().on_header(name, value)

    def on_headers_complete(self) -> None:
        """Its header is complete; a request that is refused does not reach the application."""
        self._stop_header_timer()
        self._unset_keepalive_if_required()
        if self._refused:
            return
        length = len(self.url) + sum(len(name) + len(value) + 4 for name, value in self.headers)
        if length > HEADER_BYTES:
            self._refuse(TOO_LONG)
        elif len(self.url) > TARGET_BYTES or self.url.count(b"&") >= TARGET_FIELDS:
            self._refuse(LONG_TARGET)
        elif not self.take_request():
            self._refuse(TOO_OFTEN)
        elif len(self.pipeline) >= PIPELINED:
            self._refuse(TOO_MANY)
        if not self._refused:
            super().on_headers_complete()
            self._in_body = True

    def on_chunk_header(self) -> None:
        """The length of a chunk has come."""
        self._chunks += 1
        if self._chunks > CHUNKS:
            self._refuse(MANY_CHUNKS)

    def on_body(self, body: bytes) -> None:
        """A part of a body, thrown away where the response has been sent already."""
        self._body_bytes += len(body)
        if self._refused:
            return
        super().on_body(body)
        if self.cycle is not None and self.cycle.response_complete:
            self._throw_away(len(body), BODY_BYTES)

    def on_message_complete(self) -> None:
        """The request is complete."""
        self._in_body = False
        if not self._refused:
            super().on_message_complete()

    def _start_asgi_task(self, cycle: RequestResponseCycle, app: Any) -> None:
        self._running = cycle
        super()._start_asgi_task(cycle, app)

    def _expect_header(self) -> None:
        self._header_bytes = 0
        self._header_timer = self.loop.call_later(HEADER_S, self.transport.close)

    def _stop_header_timer(self) -> None:
        if self._header_timer is not None:
            self._header_timer.cancel()
            self._header_timer = None

    def _expect_reading(self) -> None:
        """Look after a while whether the client has read anything."""
        unsent = self.transport.get_write_buffer_size()
        self._unread_timer = self.loop.call_later(UNREAD_S, self._check_reading, unsent)

    def _check_reading(self, before: int) -> None:
        if self.transport.get_write_buffer_size() < before:
            self._expect_reading()
            return
        log.info("a response was not read for %g s", UNREAD_S, extra={"code": "slow"})
        self.on_refusal("slow")
        self.transport.abort()

    def _stop_unread_timer(self) -> None:
        if self._unread_timer is not None:
            self._unread_timer.cancel()
            self._unread_timer = None

    def _throw_away(self, count: int, most: int) -> None:
        self._unread += count
        if self._unread > most:
            self.transport.abort()

    def _refuse(self, refusal: Refusal) -> None:
        """Say why, and close; the responses to earlier requests are sent before."""
        if self._refused:
            return
        self._refused, self._unread = True, 0
        self._stop_header_timer()
        log.info("a request was refused: %s", refusal.message, extra={"code": refusal.code})
        self.on_refusal(refusal.code)
        cycle = self.cycle
        if cycle is not None and not cycle.response_complete:
            cycle.keep_alive = False  # the connection closes after the response
            if not self._in_body:
                return
            cycle.disconnected = True  # the rest of its body does not come
            cycle.message_event.set()
            if cycle.response_started:
                self.transport.close()
                return
        self.transport.write(refusal.response())
        if self.transport.can_write_eof():
            self.transport.write_eof()
        self._linger_timer = self.loop.call_later(DRAIN_S, self.transport.abort)


def counting(count: Callable[[Code], None], rates: RequestRates) -> type[BoundedHttpProtocol]:
    """The protocol, with ``count`` called with the code of each request that is refused here."""

    class CountingHttpProtocol(BoundedHttpProtocol):
        """Counts what comes, and what it refuses."""

        _network: str | None = None  # by which requests are counted

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            """See whose requests come."""
            super().connection_made(transport)
            self._network = rates.counted_as(self.client[0]) if self.client is not None else None

        def take_request(self) -> bool:
            """Count it."""
            return self._network is None or rates.take(self._network, self.loop.time())

        def on_refusal(self, code: Code) -> None:
            """Count it."""
            count(code)

    return CountingHttpProtocol
