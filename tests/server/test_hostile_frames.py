"""Over a real socket, frames that no client of ours sends: too long, in too many pieces, endless pings."""

from __future__ import annotations

import json
import socket as socket_module
from contextlib import suppress
from functools import partial

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.frames import Frame, Opcode
from websockets.sync.client import ClientConnection

import pointpred_server.websocket_protocol
from pointpred_server.websocket_protocol import BoundedWebSocketProtocol
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, running


def event(t: float) -> str:
    return f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}'


def told(socket: ClientConnection) -> dict[str, object]:
    answer: dict[str, object] = json.loads(socket.recv(PATIENCE_S))
    return answer


def raw(opcode: Opcode, data: bytes, fin: bool = True) -> bytes:
    return Frame(opcode, data, fin).serialize(mask=True)


def throw(socket: ClientConnection, data: bytes) -> None:
    """Send as far as the other side takes it."""
    with suppress(OSError):
        socket.socket.sendall(data)


PINGS = raw(Opcode.PING, b"x" * 125) * 2000
PONGS = raw(Opcode.PONG, b"x") * 2000
BEGUN = raw(Opcode.TEXT, b" ", fin=False)
EMPTY = BEGUN + raw(Opcode.CONT, b"", fin=False) * 2000
ONES = BEGUN + raw(Opcode.CONT, b" ", fin=False) * 45_000
DIVIDED = raw(Opcode.TEXT, b'{"type":"reset"}', fin=False) + raw(Opcode.CONT, b"", fin=False) * 62
DIVIDED += raw(Opcode.CONT, b"")
LONG = raw(Opcode.BINARY, b"\0" * (2**20 + 1))
GROWN = raw(Opcode.BINARY, b"\0" * 2**19, fin=False) + raw(Opcode.CONT, b"\0" * (2**19 + 1), fin=False)


@pytest.mark.parametrize(
    ("frames", "code", "close"),
    [
        pytest.param(PINGS, "too_fast", 1008, id="pings"),
        pytest.param(PONGS, "too_fast", 1008, id="pongs"),
        pytest.param(EMPTY, "too_large", 1009, id="empty pieces"),
        pytest.param(ONES, "too_large", 1009, id="pieces of a byte"),
        pytest.param(DIVIDED * 200, "too_fast", 1008, id="messages in pieces"),
        pytest.param(LONG, "too_large", 1009, id="one frame above the framework's limit"),
        pytest.param(GROWN, "too_large", 1009, id="pieces above the framework's limit"),
    ],
)
def test_is_told_why_and_closed_while_others_go_on(
    frames: bytes, code: str, close: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        pointpred_server.websocket_protocol, "LINGER_S", PATIENCE_S
    )  # nobody is cut for being slow
    with running() as here, here.greeted() as other:
        with here.greeted() as socket:
            socket.send(event(1.0))
            assert told(socket)["t"] == 1.0
            throw(socket, frames)
            answer = told(socket)
            assert (answer["type"], answer["code"], answer["recoverable"]) == ("error", code, False)
            with pytest.raises(ConnectionClosed) as closed:
                socket.recv(PATIENCE_S)
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == close
        other.send(event(2.0))
        assert told(other)["t"] == 2.0
        value = here.service.metrics.registry.get_sample_value
        ended = partial(value, "pointpred_sessions_ended_total", {"code": str(close)})
        soon(lambda: ended() == 1.0, "its session is over")  # counted last of all, by another thread
        assert len(here.service._open) == 1
        assert value("pointpred_refused_total", {"code": code}) == 1.0


def test_a_message_in_some_pieces_and_pings_between_them_are_answered() -> None:
    words = event(1.0).encode()
    pieces = [words[place : place + 1] for place in range(len(words))]
    with running() as here, here.greeted() as socket:
        frames = raw(Opcode.TEXT, pieces[0], fin=False)
        for piece in pieces[1:-1]:
            frames += raw(Opcode.CONT, piece, fin=False) + raw(Opcode.PONG, b"")
        assert len(pieces) < 64
        throw(socket, frames + raw(Opcode.CONT, pieces[-1]))
        assert told(socket)["t"] == 1.0
        assert socket.ping("here").wait(PATIENCE_S)


def test_others_have_their_turn_after_64_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    pieces: list[int] = []  # parsed in each turn
    parse, take = BoundedWebSocketProtocol._parse, BoundedWebSocketProtocol.handle_cont

    def parse_noted(self: BoundedWebSocketProtocol, data: bytes) -> None:
        pieces.append(0)
        parse(self, data)

    def take_noted(self: BoundedWebSocketProtocol, piece: Frame) -> None:
        pieces[-1] += 1
        take(self, piece)

    monkeypatch.setattr(BoundedWebSocketProtocol, "_parse", parse_noted)
    monkeypatch.setattr(BoundedWebSocketProtocol, "handle_cont", take_noted)
    with running() as here, here.greeted() as socket:
        throw(socket, DIVIDED * 30 + raw(Opcode.TEXT, event(1.0).encode()))
        assert told(socket)["t"] == 1.0
    assert sum(pieces) == 30 * 63
    assert max(pieces) <= 64


def test_pings_of_a_client_that_does_not_read_leave_the_memory_flat(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pointpred_server.websocket_protocol, "CONTROL_FRAMES_PER_S", 10**9)
    monkeypatch.setattr(pointpred_server.websocket_protocol, "READ_BYTES", 131)  # as if each had come alone
    with running() as here, socket_module.socket() as mute:
        mute.setsockopt(socket_module.SOL_SOCKET, socket_module.SO_RCVBUF, 4096)
        mute.connect(("127.0.0.1", here.port))
        mute.sendall(
            b"GET /v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n"
        )
        assert mute.recv(4096).startswith(b"HTTP/1.1 101")
        for place in range(40):  # 1.25 MB of answers
            mute.sendall(b"".join(raw(Opcode.PING, b"%0125d" % (250 * place + k)) for k in range(250)))
        mute.sendall(raw(Opcode.PING, b"the newest") + raw(Opcode.TEXT, b"{"))
        soon(lambda: any(one.refusals for one in here.service._open), "everything is taken in")
        (connection,) = here.server.server_state.connections
        assert connection.transport.get_write_buffer_size() <= 2**17
        mute.settimeout(PATIENCE_S)
        heard = b""
        while b"the newest" not in heard:
            part = mute.recv(2**16)
            assert part, "closed"
            heard += part


@pytest.mark.parametrize(
    ("frames", "close"),
    [
        pytest.param(
            raw(Opcode.TEXT, b"\xff") + raw(Opcode.CLOSE, b"\x03\xe8"), 1007, id="text that is no UTF-8"
        ),
        pytest.param(b"\xf1\x80\0\0\0\0", 1002, id="reserved bits"),
    ],
)
def test_what_breaks_the_rules_of_websockets_is_counted_by_its_code_and_logs_no_error(
    frames: bytes, close: int, caplog: pytest.LogCaptureFixture
) -> None:
    with running() as here:
        with here.greeted() as socket:
            throw(socket, frames)
            with pytest.raises(ConnectionClosed):
                socket.recv(PATIENCE_S)
        value = here.service.metrics.registry.get_sample_value
        ended = partial(value, "pointpred_sessions_ended_total", {"code": str(close)})
        soon(lambda: ended() == 1.0, "its session is over")
    assert not [entry for entry in caplog.records if entry.levelno >= 30]
