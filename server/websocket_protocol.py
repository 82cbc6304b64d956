"""uvicorn's WebSocket protocol, with bounds on what a client may do below the messages of a session.

Sessions do not see frames that are too long, messages in too many fragments, floods of pings, and last frames
that nobody reads: they are bounded here.
"""

from __future__ import annotations

import asyncio
from asyncio.transports import BaseTransport
from http import HTTPStatus

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.frames import Frame, Opcode
from websockets.http11 import Request
from websockets.protocol import State

from pointpred.protocol.server_messages import Code, ErrorMessage, encode
from pointpred.protocol.token_bucket import TokenBucket
from pointpred.server.upgrade import FrameReader

UPGRADE_S = 10.0
"""So long the application may take to accept or refuse a connection."""
LINGER_S = 5.0
"""So long a client may take to read its last frames and close."""
WAITING_BYTES = 2**15
"""With more than this unsent, answers wait in the session's outbox, where newer predictions replace them."""
READ_BYTES = 2**14
"""Received data is parsed in pieces of this size: little is parsed after the end of a session."""
FRAGMENTS_MOST = 64
"""Fragments of one message; our own clients send one."""
CONTROL_FRAMES_PER_S = 100
"""Pings and pongs together."""
PONG = bytes([0x80 | Opcode.PONG])


class BoundedWebSocketProtocol(WebSocketsSansIOProtocol):
    """A connection that ends where the client exceeds a bound, and is aborted where it does not close.

    Without the abort, a client that stops reading keeps its connection, and the memory of it, although its
    session has ended.
    """

    _upgrade_timer: asyncio.TimerHandle | None = None  # runs from the request on
    _abort_timer: asyncio.TimerHandle | None = None
    _ended = False  # whether the client has been told why it ends: nothing more is received
    _pong: bytes | None = None  # the newest answer to a ping that has to wait

    async def run_asgi(self) -> None:
        """Run the session, then abort the connection where it does not close in time."""
        await super().run_asgi()
        self._linger()

    def connection_made(self, transport: BaseTransport) -> None:
        """Begin, with a bound on unsent data."""
        super().connection_made(transport)
        self.transport.set_write_buffer_limits(high=WAITING_BYTES)
        self._control_frames = TokenBucket(CONTROL_FRAMES_PER_S, self.loop.time())

    def open(self, request: Request) -> bool:
        """Answer a request that has been parsed; False where its headers do not ask for a WebSocket."""
        self.conn = FrameReader(max_size=self.config.ws_max_size, logger=self.logger)
        self._upgrade_timer = self.loop.call_later(UPGRADE_S, self._end_upgrade)
        self.handle_connect(request)
        return self.response.status_code == HTTPStatus.SWITCHING_PROTOCOLS

    def shutdown(self) -> None:
        """The service stops; a connection that has already failed has nobody to tell."""
        if self.handshake_complete or not self.conn.eof_sent:
            super().shutdown()
        else:
            self.transport.abort()

    def _end_upgrade(self) -> None:
        if not self.handshake_complete:
            self.transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing is left to abort."""
        if self._upgrade_timer is not None:
            self._upgrade_timer.cancel()
        if self._abort_timer is not None:
            self._abort_timer.cancel()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Parse received data, no further than to the end of the session."""
        if len(data) <= READ_BYTES:
            if not self._ended:
                super().data_received(data)
            return
        for place in range(0, len(data), READ_BYTES):
            if self._ended:
                return
            super().data_received(data[place : place + READ_BYTES])

    def resume_writing(self) -> None:
        """The client reads again: it gets the answer to its newest ping."""
        super().resume_writing()
        if self._pong is not None and not self._ended:
            self.transport.write(self._pong)
        self._pong = None

    def handle_cont(self, event: Frame) -> None:
        """A further fragment of a message."""
        if len(self.frames) >= FRAGMENTS_MOST:
            self._refuse("too_large", f"a message has at most {FRAGMENTS_MOST} fragments", 1009)
        elif not self._ended:
            super().handle_cont(event)

    def handle_ping(self) -> None:
        """Answer the newest of the pings that arrived together, as soon as the answer can be sent."""
        if not self._count_control_frame():
            return
        parts = self.conn.data_to_send()
        pongs = [part for part in parts if part.startswith(PONG)]
        others = [part for part in parts if not part.startswith(PONG)]
        if not self.handshake_complete:
            return
        if self.writable.is_set():
            self.transport.write(b"".join([*pongs[-1:], *others]))
        else:
            self._pong = pongs[-1] if pongs else self._pong
            self.transport.write(b"".join(others))

    def handle_pong(self, event: Frame) -> None:
        """The answer to a ping of ours, or an unsolicited one."""
        if self._count_control_frame():
            super().handle_pong(event)

    def handle_parser_exception(self) -> None:
        """What was received is no frame, or a longer one than any session takes."""
        close = self.conn.close_sent
        if close is None:  # before the handshake, where there is nobody to tell
            self.transport.abort()
        elif close.code == 1009:
            self._refuse("too_large", f"a message holds at most {self.config.ws_max_size} bytes", 1009)
        else:
            self._refuse(None, close.reason, close.code)

    def keepalive_timeout(self) -> None:
        """A client that leaves pings unanswered is gone."""
        if self.close_sent:
            return
        super().keepalive_timeout()
        self._end(1011, "keepalive ping timeout", None)

    def _count_control_frame(self) -> bool:
        """Whether one more ping or pong is allowed."""
        if self._ended:
            return False
        if self._control_frames.take(1, self.loop.time()):
            return True
        self._refuse("too_fast", f"at most {CONTROL_FRAMES_PER_S} pings and pongs a second", 1008)
        return False

    def _refuse(self, code: Code | None, message: str, close: int) -> None:
        """Send why the connection ends, end it, and let the client read that; its session is told, too."""
        if self._ended or self.close_sent:
            return
        if not self.handshake_complete:
            self.transport.abort()
            return
        if self.conn.state is State.OPEN:
            self.conn.send_close(close, message[:120])
        parts = [part for part in self.conn.data_to_send() if not part.startswith(PONG)]
        if code is not None:  # ahead of the close frame, which the parser may have written already
            error = encode(ErrorMessage(code, message, None, recoverable=False))
            parts.insert(0, Frame(Opcode.TEXT, error).serialize(mask=False))
        self.transport.write(b"".join(parts))
        self.close_sent = True
        self._end(close, message, code)
        if self.transport.can_write_eof():
            self.transport.write_eof()
        if self.read_paused:  # data left unread would turn the close into a reset
            self.read_paused = False
            self.transport.resume_reading()
        # The base class closes at once unless it waits for the client's close frame.
        self.close_timer = self.loop.call_later(LINGER_S, self.transport.abort)

    def _end(self, close: int, reason: str, refused: Code | None) -> None:
        """Tell the session; whatever it still sends is dropped."""
        self._ended, self.disconnected = True, True
        self.frames, self._pong = [], None
        self.stop_keepalive()
        message = {"type": "websocket.disconnect", "code": close, "reason": reason, "refused": refused}
        self.queue.put_nowait(message)  # type: ignore[arg-type]
        self._linger()

    def _linger(self) -> None:
        """Abort the connection where it does not close by itself in time."""
        if self._abort_timer is None and self in self.connections:
            self._abort_timer = self.loop.call_later(LINGER_S, self.transport.abort)
