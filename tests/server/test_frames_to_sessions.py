"""Frames of events as no library writes them: a pointing session predicts, or ends with the code of RFC 6455.

The numbers are the cases of the Autobahn suite whose frames these are; cases without a number are not in it.
"""

from __future__ import annotations

import json
import socket
import struct
import threading
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Self

import pytest

from pointpred.protocol.frames import Frame
from pointpred_server.connection import Violation
from pointpred_server.websocket_protocol import BoundedWebSocketProtocol
from tests.server.listener import soon
from tests.server.longest_messages import targets
from tests.server.running import HELLO, PATIENCE_S, Running, running

MASK = b"\x01\x02\x03\x04"
UPGRADE = (
    b"GET /v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
)
CONTINUED, TEXT, BINARY, CLOSE, PING, PONG = 0, 1, 2, 8, 9, 10


def frame(opcode: int, data: bytes, *, fin: bool = True, rsv: int = 0) -> bytes:
    """A masked frame."""
    size = len(data)
    if size < 126:
        length = bytes([0x80 | size])
    else:
        length = b"\xfe" + size.to_bytes(2, "big") if size < 1 << 16 else b"\xff" + size.to_bytes(8, "big")
    masked = bytes(byte ^ MASK[place % 4] for place, byte in enumerate(data))
    return bytes([fin << 7 | rsv << 4 | opcode]) + length + MASK + masked


def text(t: float, size: int = 0) -> bytes:
    """One event as JSON, with spaces up to a size."""
    return (b'{"type":"events","events":[[%g,5,6,null,null,0]]}' % t).ljust(size)


def packed(t: float, events: int = 1) -> bytes:
    """Events as packed records, the first at t."""
    return b"".join(struct.pack("<dddhhH", t + 1e-3 * one, 5.0, 6.0, 1, 1, 0) for one in range(events))


class Client:
    """A client that reads and writes bytes, and knows what a frame of a server is."""

    def __init__(self, port: int) -> None:
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE_S)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.sendall(UPGRADE)
        self.reader = self.socket.makefile("rb")
        while self.reader.readline() != b"\r\n":
            pass
        self.socket.sendall(frame(TEXT, HELLO.encode()))
        try:
            assert b"welcome" in self.receive()[1]
        except BaseException:
            self.__exit__()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.reader.close()
        self.socket.close()

    def send(self, data: bytes, piece: int = 0) -> None:
        with suppress(OSError):  # the service may have ended the connection
            for place in range(0, len(data), piece or len(data)):
                self.socket.sendall(data[place : place + (piece or len(data))])

    def receive(self) -> tuple[int, bytes]:
        """Opcode and data of the next frame; pings are answered."""
        while True:
            first, second = self.reader.read(2)
            length = second & 0x7F
            if length > 125:
                length = int.from_bytes(self.reader.read(2 if length == 126 else 8), "big")
            data = self.reader.read(length)
            if first & 0xF != PING:
                return first & 0xF, data
            self.send(frame(PONG, data))

    def predicted(self) -> float:
        """The time of the next answer, which is a prediction."""
        opcode, data = self.receive()
        assert opcode == TEXT
        answer = json.loads(data)
        assert answer["type"] == "prediction", answer
        return float(answer["t"])

    def closed(self) -> int:
        """The code of the close frame, after whatever is answered before."""
        while True:
            opcode, data = self.receive()
            if opcode == CLOSE:
                return int.from_bytes(data[:2], "big")


@pytest.fixture(scope="module")
def here() -> Iterator[Running]:
    with running(max_sessions=1000) as service:
        yield service


@pytest.fixture
def client(here: Running) -> Iterator[Client]:
    with Client(here.port) as opened:
        yield opened


@pytest.mark.parametrize("piece", [0, 1, 7], ids=["at once", "byte by byte", "in sevens"])
@pytest.mark.parametrize(
    ("data", "times"),
    [
        pytest.param(frame(TEXT, text(1)), [1], id="1.1 short"),
        pytest.param(frame(TEXT, text(1, 125)), [1], id="1.1.2 of 125"),
        pytest.param(frame(TEXT, text(1, 126)), [1], id="1.1.3 of 126"),
        pytest.param(frame(TEXT, text(1, 128)), [1], id="1.1.5 of 128"),
        pytest.param(frame(BINARY, packed(1)), [1], id="1.2 one record"),
        pytest.param(frame(BINARY, packed(1, 5)), [1.004], id="1.2 five records"),
        pytest.param(frame(TEXT, text(1)) * 2 + frame(TEXT, text(2)), [1, 1, 2], id="frames together"),
        pytest.param(frame(PONG, b"x") + frame(BINARY, packed(1)), [1], id="2.8 a pong before"),
        pytest.param(
            frame(TEXT, text(1)[:9], fin=False) + frame(CONTINUED, text(1)[9:]), [1], id="5.3 in two"
        ),
        pytest.param(
            frame(BINARY, packed(1)[:9], fin=False)
            + frame(CONTINUED, b"", fin=False)
            + frame(CONTINUED, packed(1)[9:]),
            [1],
            id="6.1.3 in three, one of them empty",
        ),
    ],
)
def test_events_are_predicted_however_they_are_framed(
    data: bytes, times: list[float], piece: int, client: Client
) -> None:
    client.send(data, piece)
    assert [client.predicted() for _ in times] == times
    client.send(frame(CLOSE, (1000).to_bytes(2, "big")), piece)
    assert client.closed() == 1000


def test_a_frame_of_the_most_bytes_is_predicted(client: Client) -> None:
    client.send(frame(TEXT, text(1, 65535)))  # 1.1.6
    assert client.predicted() == 1
    client.send(frame(TEXT, text(2, 65536)), 997)  # 1.1.8
    assert client.predicted() == 2


@pytest.mark.parametrize("piece", [0, 1], ids=["at once", "byte by byte"])
def test_a_ping_inside_a_message_is_answered_before_it(piece: int, client: Client) -> None:
    whole = text(1)
    client.send(frame(TEXT, whole[:5], fin=False) + frame(PING, b"here") + frame(CONTINUED, whole[5:]), piece)
    assert client.receive() == (PONG, b"here")
    assert client.predicted() == 1


GOOD = frame(TEXT, text(1))


@pytest.mark.parametrize("before", [b"", GOOD], ids=["alone", "behind a good frame"])
@pytest.mark.parametrize("piece", [0, 1], ids=["at once", "byte by byte"])
@pytest.mark.parametrize(
    ("data", "code"),
    [
        pytest.param(frame(PING, b"x" * 126), 1002, id="2.5 a long ping"),
        *(pytest.param(frame(TEXT, text(2), rsv=rsv), 1002, id=f"3 text, rsv {rsv}") for rsv in (1, 2, 4)),
        pytest.param(frame(BINARY, packed(2), rsv=5), 1002, id="3.5 records, rsv 5"),
        pytest.param(frame(CLOSE, b"", rsv=7), 1002, id="3.7 close, rsv 7"),
        *(pytest.param(frame(code, b""), 1002, id=f"4 opcode {code}") for code in (3, 4, 5, 6, 7, 11, 15)),
        pytest.param(frame(PING, b"x", fin=False), 1002, id="5.1 a ping in pieces"),
        pytest.param(frame(CONTINUED, packed(2)), 1002, id="5.9 nothing to continue"),
        pytest.param(
            frame(TEXT, b"{", fin=False) + frame(BINARY, packed(2)), 1002, id="5.18 no continuation"
        ),
        pytest.param(frame(TEXT, text(2)[:-3] + b"\xed\xa0\x80"), 1007, id="6.3 a surrogate"),
        pytest.param(frame(TEXT, text(2) + b"\xce"), 1007, id="6.6 half a character at the end"),
        pytest.param(
            frame(TEXT, text(2) + b"\xce") + frame(CLOSE, b""), 1007, id="6.6 half a character, and a close"
        ),
        pytest.param(frame(TEXT, b"{\xf4\x90", fin=False) + frame(CONTINUED, b"}"), 1007, id="6.4 in two"),
        pytest.param(frame(CLOSE, b"a"), 1002, id="7.3.2 close with one byte"),
        pytest.param(frame(CLOSE, (1005).to_bytes(2, "big")), 1002, id="7.9.4 close with 1005"),
        pytest.param(bytes([0x82, 30]) + packed(2), 1002, id="no mask"),
        pytest.param(bytes([0x82, 30]) + packed(2) + GOOD, 1002, id="no mask, and a good frame behind it"),
        pytest.param(b"\x82\xff" + b"\xff" * 8 + MASK, 1009, id="the highest length"),
        pytest.param(b"\x82\xff" + (2**40).to_bytes(8, "big") + MASK, 1009, id="a length of a terabyte"),
    ],
)
def test_a_violation_ends_the_session_with_its_code(
    data: bytes, code: int, piece: int, before: bytes, client: Client, here: Running
) -> None:
    client.send(before + data, piece)
    assert client.closed() == code
    with Client(here.port) as other:
        other.send(frame(BINARY, packed(3)))
        assert other.predicted() == 3


class Holding:
    """A receiver that takes messages and wants no more for now, each time."""

    def __init__(self, protocol: BoundedWebSocketProtocol) -> None:
        self.protocol = protocol
        self.messages = 0
        self.left = False

    def receive(self, frames: Sequence[Frame], read_at: float | None = None) -> None:
        self.messages += len(frames)
        self.protocol.pause_frames()

    def flush(self) -> None:
        """It sends nothing."""

    def disconnect(self, refusal: Violation | None) -> None:
        self.left = True


def test_what_was_read_before_a_connection_was_lost_is_taken_in() -> None:
    """Also where the receiver holds reading at each turn; others have their turns in between."""
    with running() as here, Client(here.port):
        (session,) = here.service._open
        connection, _ = here.service._open[session]
        assert connection is not None
        protocol = connection._socket
        assert isinstance(protocol, BoundedWebSocketProtocol)
        receiver, done = Holding(protocol), threading.Event()
        taken: list[int] = []  # so far, at each turn of the loop

        def note() -> None:
            taken.append(receiver.messages)
            if not receiver.left:
                protocol.loop.call_soon(note)

        def lose() -> None:
            protocol.pause_frames()
            protocol._receiver = receiver
            protocol.data_received(frame(TEXT, text(1.0)) * 1000)
            protocol.transport.abort()
            protocol.loop.call_soon(protocol.loop.call_soon, done.set)
            note()

        protocol.loop.call_soon_threadsafe(lose)
        assert done.wait(PATIENCE_S)
        soon(lambda: receiver.left, "it is lost")
        assert receiver.messages == 1000
        assert len(set(taken)) >= 1000 // 64
        protocol.loop.call_soon_threadsafe(connection.disconnect, None)


def test_frames_in_one_packet_with_the_request_are_taken_in() -> None:
    with running() as here, socket.create_connection(("127.0.0.1", here.port), PATIENCE_S) as plain:
        plain.sendall(UPGRADE + frame(TEXT, HELLO.encode()) + frame(TEXT, text(1.0)))
        received = b""
        while b'"prediction"' not in received:
            received += plain.recv(4096) or pytest.fail(f"closed after {received!r}")
        assert received.startswith(b"HTTP/1.1 101 ")


def test_events_at_work_when_their_client_closes_are_recorded(tmp_path: Path) -> None:
    with running(record=tmp_path) as here, Client(here.port) as client:
        client.socket.sendall(frame(TEXT, targets(1000).encode()))
        assert b"targets" in client.receive()[1]
        client.socket.sendall(frame(BINARY, packed(0.0, 100)) + frame(CLOSE, b"\x03\xe8"))
        soon(lambda: not here.service._open, "the session is over")
    (samples,) = tmp_path.glob("*_samples.csv")
    assert samples.read_text().count(",5,6,1,1,0\n") == 100
