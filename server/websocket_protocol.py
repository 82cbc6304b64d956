"""uvicorn's WebSocket protocol, with bounds on what a client may do below the messages of a session.

Sessions do not see frames that are too long, messages in too many fragments, floods of pings, and last frames
that nobody reads: they are bounded here. A session that attaches itself gets its messages, and sends its
answers, by plain calls instead of ASGI's ``receive`` and ``send``, which cost more than a prediction.
"""

from __future__ import annotations

import asyncio
import socket
from asyncio.transports import BaseTransport
from http import HTTPStatus
from time import perf_counter

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.frames import Frame, Opcode
from websockets.http11 import Request
from websockets.protocol import State

from pointpred.protocol.frames import Frame as Message
from pointpred.protocol.server_messages import Code, ErrorMessage, encode
from pointpred.protocol.token_bucket import TokenBucket
from pointpred_server.access import usual_address
from pointpred_server.connection import FRAMES, FRAMES_AT_ONCE, Receiver, Violation
from pointpred_server.sessions.lifecycle import STANDSTILL_S
from pointpred_server.upgrade import FrameReader
from pointpred_server.websocket_frames import WHOLE_MESSAGES, frame_end, framed, whole_message

UPGRADE_S = 10.0
"""So long the application may take to accept or refuse a connection."""
LINGER_S = 5.0
"""So long a client may take to read its last frames and close."""
WAITING_BYTES = 2**15
"""With more than this unsent, answers wait in the session's outbox, where newer predictions replace them."""
READ_BYTES = 2**14
"""Received data is parsed in pieces of this size: others have their turn in between, and little is parsed
after the end of a session."""
RECEIVE_BUFFER_BYTES = 2**16
"""What the kernel may hold unread of a session's events; it takes twice as much for its own records. A
client whose events come faster than they are used has to wait with more. Less than a packet of the loopback
interface would stop a client again and again."""
FRAGMENTS_MOST = 64
"""Fragments of one message; our own clients send one."""
FRAGMENTS_PER_S = 5000
"""Fragments of all messages: parsing one takes 4 us. Messages in one frame are not counted."""
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
    _heard = True  # whether anything has come since the last ping
    _ended = False  # whether the client has been told why it ends: nothing more is received
    _pong: bytes | None = None  # the newest answer to a ping that has to wait
    _receiver: Receiver | None = None
    _detached = False  # whether there was a receiver, which takes nothing more
    _held = False  # whether the receiver takes nothing for now
    _unparsed = b""  # the beginning of a frame, or what waits for its turn
    _read_at = 0.0  # when the first of it was read
    _turn: asyncio.Handle | None = None  # when that is parsed
    _parser_bytes = 0  # so many more bytes belong to the parser: it has begun to read a frame
    can_write = True

    async def run_asgi(self) -> None:
        """Run the session, then abort the connection where it does not close in time."""
        self.scope["extensions"][FRAMES] = {"socket": self}
        await super().run_asgi()
        self._linger()

    def attach(self, receiver: Receiver) -> None:
        """Give messages to a receiver from now on; ASGI's ``receive`` gives none any more."""
        self._receiver = receiver
        kernel = self.transport.get_extra_info("socket")
        kernel.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER_BYTES)
        while not self.queue.empty():
            early = self.queue.get_nowait()
            if early["type"] == "websocket.receive":
                receiver.receive([early.get("text") or early.get("bytes") or b""])
            elif early["type"] == "websocket.disconnect":
                receiver.disconnect(None)
        self._read_on()

    def detach(self) -> None:
        """Drop what comes from the client from now on; only its close frame has a meaning."""
        self._receiver, self._detached = None, True
        self.resume_frames()

    def write(self, frame: Message) -> None:
        """Send a message, unless the connection has ended or is about to."""
        if self.conn.state is State.OPEN and not self.disconnected and not self.transport.is_closing():
            self.transport.write(framed(frame))

    def pause_frames(self) -> None:
        """Read nothing more from the client."""
        self._held = True
        self._pause_reading()

    def resume_frames(self) -> None:
        """Read again."""
        if self._held:
            self._held = False
            self._begin_turn()

    def connection_made(self, transport: BaseTransport) -> None:
        """Begin, with a bound on unsent data."""
        super().connection_made(transport)
        self.client = usual_address(self.client)
        self.transport.set_write_buffer_limits(high=WAITING_BYTES)
        self._control_frames = TokenBucket(CONTROL_FRAMES_PER_S, self.loop.time())
        self._fragments = TokenBucket(FRAGMENTS_PER_S, self.loop.time())

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
        """What came before is still given on, in turns; nothing is left to abort."""
        if self._unparsed and not self._ended:
            self._held = False  # the receiver may hold it again at each turn
            self._take_turn()
            if self._turn is not None:
                self._turn.cancel()
                self._turn = self.loop.call_soon(self.connection_lost, exc)
                return
        if self._upgrade_timer is not None:
            self._upgrade_timer.cancel()
        if self._abort_timer is not None:
            self._abort_timer.cancel()
        self.can_write = True
        super().connection_lost(exc)
        if self._receiver is not None:
            self._receiver.disconnect(None)

    def data_received(self, data: bytes) -> None:
        """Take in received data, no further than to the end of the session."""
        self._heard = True
        if self._unparsed:
            data = self._unparsed + data
        else:
            self._read_at = perf_counter()
        if self._held or self._turn is not None:
            self._unparsed = data
        else:
            self._parse(data)

    def _parse(self, data: bytes) -> None:
        """Give on the messages in received data; of much data the rest waits until others had their turn."""
        messages: list[Message] = []
        at, size, most = 0, len(data), FRAMES_AT_ONCE
        while at < size and not self._ended:
            if at >= READ_BYTES or len(messages) >= most:
                self._begin_turn()
                break
            end = at + self._parser_bytes if self._parser_bytes else frame_end(data, at)
            message = None
            if end == 0:
                break  # the rest of its header has not come
            if not self._parser_bytes and data[at] in WHOLE_MESSAGES and self.conn.current_size is None:
                if size < end <= at + READ_BYTES:
                    break  # the rest of the frame has not come
                message = whole_message(data, at, end) if end <= size else None
            if message is not None:
                messages.append(message)
                at = end
                continue
            self._deliver(messages)
            messages, begin = [], at
            at, count = self._end_of_others(data, at, end)
            most -= count
            self._parser_bytes = max(end - size, 0)
            super().data_received(data[begin:at])
            if self.conn.close_rcvd is not None:
                at = size
        self._unparsed = b"" if self._ended or at >= size else data[at:]
        self._deliver(messages)

    def _end_of_others(self, data: bytes, begin: int, end: int) -> tuple[int, int]:
        """Where the frames end that the parser reads together, such as fragments, and how many they are."""
        size, count = len(data), 1
        if data[begin] in WHOLE_MESSAGES and self.conn.current_size is None:
            return min(end, size), count
        while end < size and data[end] not in WHOLE_MESSAGES and count < FRAMES_AT_ONCE:
            following = frame_end(data, end)
            if not 0 < following <= min(size, begin + READ_BYTES):
                break
            end, count = following, count + 1
        return min(end, size), count

    def _deliver(self, messages: list[Message]) -> None:
        if not messages or self.close_sent or self._ended or self._detached:
            return
        if self._receiver is not None:
            self._receiver.receive(messages, self._read_at)
            return
        for message in messages:  # an application that uses ASGI's ``receive``
            kind = "text" if isinstance(message, str) else "bytes"
            self.queue.put_nowait({"type": "websocket.receive", kind: message})  # type: ignore[arg-type]
        self._pause_reading()

    def send_receive_event_to_app(self) -> None:
        """Give on a message that the parser has read."""
        data, self.frames = b"".join(self.frames), []
        if self.curr_msg_data_type == "bytes":
            self._deliver([data])
            return
        try:
            text = data.decode()
        except UnicodeDecodeError as error:
            self._refuse(None, f"a text must be UTF-8: {error.reason} at byte {error.start}", 1007)
        else:
            self._deliver([text])

    def _begin_turn(self) -> None:
        """Parse what is unparsed once others had their turn; nothing is read before."""
        if self._turn is None:
            self._turn = self.loop.call_soon(self._take_turn)
            self._pause_reading()

    def _take_turn(self) -> None:
        if self._turn is not None:
            self._turn.cancel()
            self._turn = None
        if not self._held:
            data, self._unparsed = self._unparsed, b""
            self._parse(data)
            self._read_on()

    def _pause_reading(self) -> None:
        if not self.read_paused and not self.transport.is_closing():
            self.read_paused = True
            self.transport.pause_reading()

    def _read_on(self) -> None:
        """Read again where nothing is against it."""
        if self.read_paused and not self._held and self._turn is None and not self.transport.is_closing():
            self.read_paused = False
            self.transport.resume_reading()

    def pause_writing(self) -> None:
        """The client does not read."""
        super().pause_writing()
        self.can_write = False

    def resume_writing(self) -> None:
        """The client reads again: it gets the answer to its newest ping, and what waits."""
        super().resume_writing()
        self.can_write = True
        if self._pong is not None and not self._ended:
            self.transport.write(self._pong)
        self._pong = None
        if self._receiver is not None:
            self._receiver.flush()

    def handle_cont(self, event: Frame) -> None:
        """A further fragment of a message."""
        if self._ended:
            return
        # The second fragment counts for the first as well, which looks like a whole message.
        count = 2 if len(self.frames) == 1 else 1
        if len(self.frames) >= FRAGMENTS_MOST:
            self._refuse("too_large", f"a message has at most {FRAGMENTS_MOST} fragments", 1009)
        elif not self._fragments.take(count, self.loop.time()):
            self._refuse("too_fast", f"at most {FRAGMENTS_PER_S} fragments of messages a second", 1008)
        else:
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

    def handle_close(self, event: Frame) -> None:
        """The client leaves, or answers our close frame."""
        super().handle_close(event)
        if self._receiver is not None:
            self._receiver.disconnect(None)

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

    def send_keepalive_ping(self) -> None:
        """From now on something must come."""
        self._heard = False
        super().send_keepalive_ping()

    def keepalive_timeout(self) -> None:
        """A client that leaves a ping unanswered and sends nothing else is gone.

        The answer may be behind frames that wait; and where this process stood still it may have come and
        not been read.
        """
        if self.close_sent:
            return
        now, patience_s = self.loop.time(), self.ping_timeout or 0.0
        if self._heard or now - self.ping_sent_at > patience_s + STANDSTILL_S:
            self._heard, self.ping_sent_at = False, now
            self.pong_timer = self.loop.call_later(patience_s, self.keepalive_timeout)
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
        self.queue.put_nowait({"type": "websocket.disconnect", "code": close, "reason": reason})
        if self._receiver is not None:
            self._receiver.disconnect(Violation(refused, reason, close))
        self._linger()

    def _linger(self) -> None:
        """Abort the connection where it does not close by itself in time."""
        if self._abort_timer is None and self in self.connections:
            self._abort_timer = self.loop.call_later(LINGER_S, self.transport.abort)
