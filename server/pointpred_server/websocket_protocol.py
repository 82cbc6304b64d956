"""A WebSocket: the request to open it, then its frames into a session and the answers back.

uvicorn reads the request and hands the connection over; the sans-I/O protocol of ``websockets`` reads and
checks frames. Everything else that happens between a socket and a session is in this file.
"""

from __future__ import annotations

import asyncio
import logging
import socket
from collections.abc import Callable
from http import HTTPStatus
from time import perf_counter
from typing import Any
from urllib.parse import unquote

from uvicorn.config import Config
from uvicorn.server import ServerState
from websockets.frames import CloseCode, Frame, Opcode
from websockets.http11 import Request, Response
from websockets.protocol import State
from websockets.server import ServerProtocol

from pointpred.clock import Instant, now
from pointpred.logs import place_of
from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred.protocol.server_messages import Code, ErrorMessage, ServerMessage, encode
from pointpred_server.access import HOST_REFUSED, Scope, admits_origin, believe_proxy, header, origin_advice
from pointpred_server.service import Refusal, Service
from pointpred_server.sessions.lifecycle import LOST, SLOW, STANDSTILL_S, Session

log = logging.getLogger("pointpred.service")

READ_BYTES = 2**11
"""So much is read of one client before others have their turn."""
RECEIVE_BUFFER_BYTES = 2**16
"""What the kernel may hold unread of a client: one whose events come faster than they are used has to wait
with more. Less than a packet of the loopback interface would stop a client again and again."""
WAITING_BYTES = 2**15
"""With more than this unsent, answers wait in the session's outbox, where newer predictions replace them."""
MESSAGE_BYTES = 2**20
"""Longest message that is read: above every limit of a session, which says more."""
STUCK_S = 10.0
"""A session ends whose client has read too little for so long, although answers wait."""
LINGER_S = 5.0
"""So long a client may take to read its last frames and close."""
STOP_LINGER_S = 3.0
"""So long where the service stops: less than uvicorn waits."""
PING_S, PONG_S = 20.0, 20.0
"""A client that sends nothing for so long is asked whether it is there, and is gone where nothing comes."""

WHOLE = MASKED = 0x80
"""In the first byte of a frame: a message ends with it. In the second: it is masked, as a client must."""
TEXT, BINARY = WHOLE + Opcode.TEXT, WHOLE + Opcode.BINARY
SHORT_BYTES, LENGTH_OF_TWO, HEAD_BYTES = 125, 126, 6
"""The second byte is the length of payloads up to the first of these, or says that the length is in the two
bytes behind it; then the mask of a client and the payload follow, without that at the sixth byte."""
STOPS = "the server stops"
"""What clients are told at the end."""
CLEAN = (1000, 1001, 1005)
"""Codes of a client that leaves in order; others would be any label of a metric that a client likes."""
PATHS = ("/v1/stream", "/v1/live")
NO_REQUEST = b"HTTP/1.1 400 Bad Request\r\nConnection: close\r\nContent-Length: 0\r\n\r\n"
NO_DEVICE = (
    "no device is attached; to show a mouse here, run 'pointpred live --serve' "
    "on the machine it is plugged into"
)


class WebSocketProtocol(asyncio.BufferedProtocol):
    """One connection, from the request on; uvicorn's class for WebSockets, without its application."""

    def __init__(
        self, service: Service, config: Config, server_state: ServerState, app_state: dict[str, Any]
    ) -> None:
        self.session: Session | None = None
        self.messages = 0
        """Messages received."""
        self._service = service
        self._connections = server_state.connections
        self._frames = ServerProtocol(max_size=MESSAGE_BYTES, select_subprotocol=_subprotocol)
        self._buffer = memoryview(bytearray(READ_BYTES))
        self._partial = 0  # bytes of a frame that has not ended
        self._pieces: list[bytes] = []  # of a message that has not ended
        self._text = False  # whether that is a text
        self._can_write = True
        self._paused_at = self._heard_at = now()
        self._pinged = False
        self._closing: asyncio.TimerHandle | None = None
        self._deaf = False
        """Whether a client goes on to send much after the end: that is not even looked at."""

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Uvicorn hands the connection over."""
        self._transport = transport
        self._loop = asyncio.get_running_loop()
        self._connections.add(self)  # type: ignore[arg-type]
        transport.set_write_buffer_limits(high=WAITING_BYTES)
        kernel = transport.get_extra_info("socket")
        kernel.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER_BYTES)

    def data_received(self, data: bytes) -> None:
        """The request, as uvicorn writes it out; frames come in the buffer."""
        self._frames.receive_data(data)
        request = next(iter(self._frames.events_received()), None)
        if not isinstance(request, Request):
            self._transport.write(NO_REQUEST)
            self._transport.close()
            return
        scope = self._scope(request)
        refused = self._refuse_request(scope)
        response = refused or self._frames.accept(request)
        self._frames.send_response(response)
        self._send()
        if response.status_code != HTTPStatus.SWITCHING_PROTOCOLS:
            if refused is None:
                self._service.count_refusal("bad_field")
            self._linger()
            return
        opened = self._service.open_session(scope, self)
        if isinstance(opened, Refusal):
            self._write(encode(ErrorMessage(opened.code, opened.message, recoverable=False)).decode())
            self._close(opened.close, opened.message)
        else:
            self.session = opened
            opened.run_aside = self._run_aside
            self.flush()
        # uvicorn sets this protocol next; only from then on the transport may read into its buffer.
        self._read_later()

    def _read_later(self) -> None:
        """Read on once all others have had their turn: uvloop reads up to 32 times before it asks them."""
        self._transport.pause_reading()
        self._loop.call_soon(self._read_on)

    def _read_on(self) -> None:
        if not self._transport.is_closing():
            self._transport.resume_reading()

    def _scope(self, request: Request) -> Scope:
        """The request as ASGI has it; the client is the one that a trusted proxy names."""
        path, _, query = request.path.partition("?")
        peer = self._transport.get_extra_info("peername")
        scope: Scope = {
            "path": unquote(path),
            "query_string": query.encode("latin-1", "replace"),
            "headers": [
                (name.lower().encode(), value.encode("latin-1", "replace"))
                for name, value in request.headers.raw_items()
            ],
            "scheme": "ws",
            "client": tuple(peer[:2]) if isinstance(peer, tuple) else None,
        }
        believe_proxy(scope, self._service.settings.trust_proxy)
        return scope

    def _refuse_request(self, scope: Scope) -> Response | None:
        """Why no WebSocket is opened: another host name, another site's page, another path."""
        service = self._service
        if not service.hosts.admits(scope):
            return self._response(HTTPStatus.FORBIDDEN, "unauthorized", HOST_REFUSED)
        if not admits_origin(scope, service.settings.allow_origin):
            origin = header(scope, b"origin")
            service.origins.add(origin)
            return self._response(HTTPStatus.FORBIDDEN, "unauthorized", origin_advice(origin))
        if scope["path"] not in PATHS:
            return self._response(
                HTTPStatus.NOT_FOUND, "bad_field", f"a WebSocket is at {' or '.join(PATHS)}"
            )
        if scope["path"] == "/v1/live" and service.live is None and service.has_token(scope):
            return self._response(HTTPStatus.NOT_FOUND, "out_of_place", NO_DEVICE)
        return None

    def _response(self, status: HTTPStatus, code: Code, message: str) -> Response:
        """An error in the shape that errors have everywhere."""
        self._service.count_refusal(code)
        response = self._frames.reject(status, encode(ErrorMessage(code, message)).decode())
        del response.headers["Content-Type"]
        response.headers["Content-Type"] = "application/json"
        return response

    def get_buffer(self, sizehint: int) -> memoryview:
        """Where the transport puts what it reads next."""
        return self._buffer

    def buffer_updated(self, nbytes: int) -> None:
        """Take in the messages of what was read."""
        self._heard_at = at = now()
        if nbytes == READ_BYTES:
            self._read_later()
            self._deaf = self._deaf or self._closing is not None
        if self._deaf:
            return
        message = None if self._partial or self._pieces else self._short_message(nbytes)
        if message is not None:
            self._receive(message, at)
            return
        frames = self._frames
        frames.receive_data(self._buffer[:nbytes].tobytes())
        self._partial += nbytes
        if frames.state is State.OPEN:
            self._send()  # pongs; a close frame goes after the answers to what came before
        for frame in frames.events_received():
            assert isinstance(frame, Frame)
            self._partial -= len(frame.data) + _head_bytes(len(frame.data))
            self._take(frame, at)
        if frames.state is not State.OPEN:
            self._end_as(frames)
        self._send()

    def _end_as(self, frames: ServerProtocol) -> None:
        """End the session where its client has left, or has broken a rule of WebSockets."""
        session, left, sent = self.session, frames.close_rcvd, frames.close_sent
        if session is None or session.close is not None:
            return
        if left is not None:
            session.end(left.code if left.code in CLEAN else LOST, "the client has left")
        elif sent is not None and sent.code == CloseCode.MESSAGE_TOO_BIG:
            session.fail("too_large", f"a message holds at most {MESSAGE_BYTES} bytes", sent.code)
        elif sent is not None:
            session.end(sent.code, sent.reason)
        self.flush()

    def _short_message(self, nbytes: int) -> str | bytes | None:
        """What was read where that is one message in one frame: a fifth of the time of all checks.

        ``None`` for everything else, and for what breaks a rule: ``websockets`` says which.
        """
        read, head = self._buffer, HEAD_BYTES
        first, size = read[0], read[1] - MASKED
        if size == LENGTH_OF_TWO:
            head, size = HEAD_BYTES + 2, read[2] << 8 | read[3]
        if nbytes != head + size or size < 0 or (first != BINARY and first != TEXT):
            return None
        mask = int.from_bytes((read[head - 4 : head].tobytes() * (size // 4 + 1))[:size])
        payload = (int.from_bytes(read[head:nbytes]) ^ mask).to_bytes(size)
        if first == BINARY:
            return payload
        try:
            return payload.decode()
        except UnicodeDecodeError:
            return None

    def _take(self, frame: Frame, at: Instant) -> None:
        """Take in one frame: a message, a piece of one, or a ping."""
        session, opcode = self.session, frame.opcode
        if session is None or session.close is not None or opcode is Opcode.CLOSE:
            return
        data, alone = bytes(frame.data), frame.fin and not self._pieces
        if not alone or opcode is Opcode.PING or opcode is Opcode.PONG:
            session.receive_piece(at)
            self.flush()
        if opcode is Opcode.PING or opcode is Opcode.PONG:
            return
        if not alone:
            self._text = opcode is Opcode.TEXT if not self._pieces else self._text
            self._pieces.append(data)
            if not frame.fin:
                return
            data = b"".join(self._pieces)
            self._pieces.clear()
        else:
            self._text = opcode is Opcode.TEXT
        try:
            message = data.decode() if self._text else data
        except UnicodeDecodeError as error:
            self._frames.fail(
                CloseCode.INVALID_DATA, f"a text must be UTF-8: {error.reason} at byte {error.start}"
            )
        else:
            self._receive(message, at)

    def _receive(self, message: str | bytes, at: Instant) -> None:
        """Give a message to the session, and send what it answers."""
        session = self.session
        if session is None:
            return
        self.messages += 1
        predictions = session.outbox.predictions
        try:
            session.receive(message, at)
        except Exception as error:
            self._fail(error)
        self.flush()
        if session.outbox.predictions != predictions and not session.outbox.waiting:
            self._service.metrics.delays.observe(perf_counter() - at.s)

    def _fail(self, error: Exception) -> None:
        """Something broke on this side: the session ends, the process and other sessions go on."""
        assert self.session is not None
        # The message might quote an event: the entry names the place, not the values.
        log.error("session failed", extra={"session": self.session.name, "error": place_of(error)})
        self.session.fail()

    def flush(self) -> None:
        """Send what can be sent now; the rest once the client reads again."""
        session = self.session
        if session is None or self._transport.is_closing():
            return
        while self._can_write and (answers := session.outbox.take()):
            for answer in answers:
                self._write(answer)
        if session.close is not None and self._closing is None:
            for answer in session.outbox.take():
                self._write(answer)
            self._close(session.close.code, session.close.reason)

    def _write(self, answer: str | bytes) -> None:
        first, payload = (TEXT, answer.encode()) if isinstance(answer, str) else (BINARY, answer)
        size = len(payload)
        if size <= SHORT_BYTES:
            self._transport.write(bytes((first, size)) + payload)
        elif size < 2**16:
            self._transport.write(bytes((first, LENGTH_OF_TWO, size >> 8, size & 255)) + payload)
        else:
            self._transport.write(Frame(Opcode(first - WHOLE), payload).serialize(mask=False))

    def _close(self, code: int, reason: str) -> None:
        """Send why the connection ends, unless the client has closed it."""
        if self._frames.state is State.OPEN:
            self._frames.send_close(code, reason)
        self._send()
        self._linger()

    def _send(self) -> None:
        """Send what ``websockets`` has to: pongs, close frames, the end."""
        for data in self._frames.data_to_send():
            if data:
                self._transport.write(data)
            elif self._transport.can_write_eof():
                self._transport.write_eof()
                self._linger()

    def _linger(self) -> None:
        """Abort the connection where the client does not close it in time."""
        if self._closing is None:
            seconds = STOP_LINGER_S if self._service.stopping else LINGER_S
            self._closing = self._loop.call_later(seconds, self._transport.abort)

    def _run_aside(self, work: Callable[[], ServerMessage]) -> None:
        """Have another thread do what takes long, and send what comes of it."""
        done = self._loop.run_in_executor(self._service.aside, work)
        done.add_done_callback(self._finish_aside)

    def _finish_aside(self, done: asyncio.Future[ServerMessage]) -> None:
        if self.session is None or self.session.close is not None or done.cancelled():
            return
        if (error := done.exception()) is not None:
            assert isinstance(error, Exception)
            self._fail(error)
        else:
            self.session.send(done.result())
        self.flush()

    def tick(self, at: Instant, late_s: float) -> None:
        """A second has passed: end what is silent, or is not read; ask whether the client is there.

        ``late_s``: as in ``Session.tick``.
        """
        session = self.session
        if session is None or session.close is not None:
            return
        if late_s > STANDSTILL_S:
            self._paused_at = self._heard_at = at
        try:
            session.tick(at, late_s)
        except Exception as error:
            self._fail(error)
        if not self._can_write and at.since(self._paused_at) >= STUCK_S:
            session.fail("slow", SLOW, 1013)
        silent_s = at.since(max(self._heard_at, session.patient_until))
        if silent_s >= PING_S + PONG_S:
            session.end(1011, "nothing comes, not even the answer to a ping")
        elif silent_s < PING_S:
            self._pinged = False
        elif not self._pinged and self._can_write:
            self._pinged = True
            self._frames.send_ping(b"")
            self._send()
        self.flush()

    def pause_writing(self) -> None:
        """The client does not read."""
        self._can_write, self._paused_at = False, now()

    def resume_writing(self) -> None:
        """The client reads again."""
        self._can_write = True
        self.flush()

    def connection_lost(self, exc: Exception | None) -> None:
        """Nothing comes or can be sent any more."""
        self._connections.discard(self)
        if self._closing is not None:
            self._closing.cancel()
        if self.session is not None:
            self._service.close_session(self.session)

    def shutdown(self) -> None:
        """Uvicorn stops: tell the client."""
        self._service.stopping = True
        if self._closing is not None:
            self._closing.cancel()
            self._closing = None
            self._linger()
        if self.session is None:
            self._transport.close()
        else:
            self.session.stop(STOPS)
            self.flush()


def _head_bytes(size: int) -> int:
    """Bytes of a client's frame before a payload of so many."""
    return HEAD_BYTES + (0 if size <= SHORT_BYTES else 2 if size < 2**16 else 8)


def _subprotocol(frames: ServerProtocol, offered: Any) -> Any:
    """Ours where the client offers it; a client may go without one."""
    return SUBPROTOCOL if SUBPROTOCOL in offered else None
