"""uvicorn's WebSocket connection, with bounds on what a client may do below the messages of a session.

Frames that are too long, messages in too many pieces, pings without end, and last frames that nobody reads:
the session never sees these, so they are answered and ended here.
"""

from __future__ import annotations

import asyncio
from asyncio.transports import BaseTransport

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.frames import Frame, Opcode
from websockets.protocol import State

from pointpred.protocol.server_messages import Code, ErrorMessage, encode
from pointpred.protocol.token_bucket import TokenBucket

LINGER_S = 5.0
"""A client may read its last frames and say goodbye for so long."""
WAITING_BYTES = 2**15
"""More than this in the process, and answers wait in the session's outbox, where newer ones replace them."""
PIECE_BYTES = 2**14
"""What comes at once is looked at in pieces of this size: no more is taken in after the end of a session."""
FRAGMENTS_MOST = 64
"""Pieces of one message; a client of ours sends one."""
CONTROLS_PER_S = 100
"""Pings and pongs together."""
PONG = bytes([0x80 | Opcode.PONG])


class CuttingProtocol(WebSocketsSansIOProtocol):
    """A connection that ends for a client that breaks the bounds, and is cut where its end is not read.

    Without this a client that stops reading keeps its connection, and the memory of it, although its session
    has ended.
    """

    _cut: asyncio.TimerHandle | None = None
    _over = False  # whether the client has been told that this is the end: nothing more is taken in
    _pong: bytes | None = None  # the newest answer to a ping that has to wait

    async def run_asgi(self) -> None:
        """Talk, then give the goodbye a bounded time."""
        await super().run_asgi()
        self._linger()

    def connection_made(self, transport: BaseTransport) -> None:
        """Begin, with a bound on what may wait to be written."""
        super().connection_made(transport)
        self.transport.set_write_buffer_limits(high=WAITING_BYTES)
        self._controls = TokenBucket(CONTROLS_PER_S, self.loop.time())

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing is left to cut."""
        if self._cut is not None:
            self._cut.cancel()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Take in what came, no further than to the end of the session."""
        if len(data) <= PIECE_BYTES:
            if not self._over:
                super().data_received(data)
            return
        for place in range(0, len(data), PIECE_BYTES):
            if self._over:
                return
            super().data_received(data[place : place + PIECE_BYTES])

    def resume_writing(self) -> None:
        """The client reads again: it gets the answer to its newest ping."""
        super().resume_writing()
        if self._pong is not None and not self._over:
            self.transport.write(self._pong)
        self._pong = None

    def handle_cont(self, event: Frame) -> None:
        """A further piece of a message."""
        if len(self.frames) >= FRAGMENTS_MOST:
            self._refuse("too_large", f"a message has at most {FRAGMENTS_MOST} fragments", 1009)
        elif not self._over:
            super().handle_cont(event)

    def handle_ping(self) -> None:
        """Answer the newest of the pings that came together, and that when it can be sent."""
        if not self._controlled():
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
        """The answer to a ping of ours, or what pretends to be one."""
        if self._controlled():
            super().handle_pong(event)

    def handle_parser_exception(self) -> None:
        """What came is no frame, or one that is longer than any session takes."""
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

    def _controlled(self) -> bool:
        """Whether one more ping or pong is taken in."""
        if self._over:
            return False
        if self._controls.allows(1, self.loop.time()):
            return True
        self._refuse("too_fast", f"at most {CONTROLS_PER_S} pings and pongs a second", 1008)
        return False

    def _refuse(self, code: Code | None, message: str, close: int) -> None:
        """Say why the connection ends, end it, and let the client read that; its session hears it too."""
        if self._over or self.close_sent:
            return
        if not self.handshake_complete:
            self.transport.abort()
            return
        if self.conn.state is State.OPEN:
            self.conn.send_close(close, message[:120])
        last = [part for part in self.conn.data_to_send() if not part.startswith(PONG)]
        if code is not None:  # ahead of the close frame, which the parser may have written already
            error = encode(ErrorMessage(code, message, None, recoverable=False))
            last.insert(0, Frame(Opcode.TEXT, error).serialize(mask=False))
        self.transport.write(b"".join(last))
        self.close_sent = True
        self._end(close, message, code)
        if self.transport.can_write_eof():
            self.transport.write_eof()
        if self.read_paused:  # what is left unread would turn the end into a reset, unheard
            self.read_paused = False
            self.transport.resume_reading()
        # The base class closes at once unless it waits for the client's close frame.
        self.close_timer = self.loop.call_later(LINGER_S, self.transport.abort)

    def _end(self, close: int, reason: str, refused: Code | None) -> None:
        """Tell the session; whatever it still says is not sent."""
        self._over, self.disconnected = True, True
        self.frames, self._pong = [], None
        self.stop_keepalive()
        message = {"type": "websocket.disconnect", "code": close, "reason": reason, "refused": refused}
        self.queue.put_nowait(message)  # type: ignore[arg-type]
        self._linger()

    def _linger(self) -> None:
        """Cut the connection where it does not end by itself in time."""
        if self._cut is None and self in self.connections:
            self._cut = self.loop.call_later(LINGER_S, self.transport.abort)
