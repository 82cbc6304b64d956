"""Over a real socket: frames as they may come, what breaks a rule, who is turned away, who leaves."""

from __future__ import annotations

import json
import logging
import socket
import struct
import threading
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from functools import partial
from typing import Any, Self

import pytest
from httpx2 import get
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.frames import Opcode
from websockets.server import ServerProtocol

import pointpred_server.service
import pointpred_server.websocket_protocol
from pointpred.clock import Instant
from pointpred.logs import PlainLines
from pointpred_server.logs import JsonLines
from pointpred_server.sessions.pointing import PointingSession
from tests.server.listener import soon
from tests.server.running import HELLO, PATIENCE_S, Running, ends, event, running, told

TOKEN = "open sesame"
EACH = HELLO.replace('"switched"', '"switched","reply":"event"')
LINE = b"GET /v1/stream HTTP/1.1\r\n"
UPGRADE = (
    b"Host: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
)
MASK = b"\1\2\3\4"
TEXT, BINARY, CONT, PING, PONG, CLOSE = (
    Opcode.TEXT,
    Opcode.BINARY,
    Opcode.CONT,
    Opcode.PING,
    Opcode.PONG,
    Opcode.CLOSE,
)


def frame(opcode: int, data: bytes, *, fin: bool = True, rsv: int = 0) -> bytes:
    """A frame of a client, also one that breaks a rule."""
    size = len(data)
    length = bytes([0x80 | min(size, 127)])
    if size > 125:
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

    def __init__(self, port: int, hello: str = HELLO) -> None:
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE_S)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.sendall(LINE + UPGRADE + b"\r\n")
        self.reader = self.socket.makefile("rb")
        while self.reader.readline() != b"\r\n":
            pass
        self.socket.sendall(frame(TEXT, hello.encode()))
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
        """Opcode and data of the next frame."""
        first, second = self.reader.read(2)
        length = second & 0x7F
        if length > 125:
            length = int.from_bytes(self.reader.read(2 if length == 126 else 8), "big")
        return first & 0xF, self.reader.read(length)

    def predicted(self) -> float:
        """The time of the next answer, which is a prediction."""
        opcode, data = self.receive()
        assert opcode == TEXT
        answer = json.loads(data)
        assert answer["type"] == "prediction", answer
        return float(answer["t"])

    def closed(self) -> tuple[int, list[str]]:
        """The code of the close frame, and the codes of the errors before it."""
        errors = []
        while True:
            opcode, data = self.receive()
            if opcode == CLOSE:
                return int.from_bytes(data[:2], "big"), errors
            if b'"error"' in data:
                errors.append(json.loads(data)["code"])


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
        pytest.param(frame(BINARY, packed(1)), [1], id="1.2 one record"),
        pytest.param(frame(BINARY, packed(1, 5)), [1.004], id="1.2 five records"),
        pytest.param(frame(TEXT, text(1)) * 2 + frame(TEXT, text(2)), [1, 1, 2], id="frames together"),
        pytest.param(frame(PONG, b"x") + frame(BINARY, packed(1)), [1], id="2.8 a pong before"),
        pytest.param(
            frame(TEXT, text(1)[:9], fin=False) + frame(CONT, text(1)[9:]) + frame(TEXT, text(2)),
            [1, 2],
            id="5.3 in two, and one whole",
        ),
        pytest.param(
            frame(BINARY, packed(1)[:9], fin=False)
            + frame(CONT, b"", fin=False)
            + frame(CONT, packed(1)[9:]),
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
    client.send(frame(TEXT, text(3)))  # a short frame, read by hand, wherever the one before it ended
    assert client.predicted() == 3
    client.send(frame(TEXT, text(4)) + frame(CLOSE, (1000).to_bytes(2, "big")), piece)
    assert client.predicted() == 4, "what came before the close is answered"
    assert client.closed() == (1000, [])


def test_a_frame_of_the_most_bytes_is_predicted(client: Client) -> None:
    client.send(frame(TEXT, text(1, 65535)))  # 1.1.6
    assert client.predicted() == 1
    client.send(frame(TEXT, text(2, 65536)), 997)  # 1.1.8
    assert client.predicted() == 2


@pytest.mark.parametrize("piece", [0, 1], ids=["at once", "byte by byte"])
def test_a_ping_inside_a_message_is_answered_before_it(piece: int, client: Client) -> None:
    whole = text(1)
    client.send(frame(TEXT, whole[:5], fin=False) + frame(PING, b"here") + frame(CONT, whole[5:]), piece)
    assert client.receive() == (PONG, b"here")
    assert client.predicted() == 1


GOOD = frame(TEXT, text(1))
LONG = frame(BINARY, b"\0" * (2**20 + 1))
GROWN = frame(BINARY, b"\0" * 2**19, fin=False) + frame(CONT, b"\0" * (2**19 + 1), fin=False)
BEGUN = frame(TEXT, b" ", fin=False)


@pytest.mark.parametrize("before", [b"", GOOD], ids=["alone", "behind a good frame"])
@pytest.mark.parametrize("piece", [0, 1], ids=["at once", "byte by byte"])
@pytest.mark.parametrize(
    ("data", "code"),
    [
        pytest.param(frame(PING, b"x" * 126), 1002, id="2.5 a long ping"),
        *(pytest.param(frame(TEXT, text(2), rsv=rsv), 1002, id=f"3 text, rsv {rsv}") for rsv in (1, 2, 4)),
        pytest.param(frame(CLOSE, b"", rsv=7), 1002, id="3.7 close, rsv 7"),
        *(pytest.param(frame(code, b""), 1002, id=f"4 opcode {code}") for code in (3, 7, 11, 15)),
        pytest.param(frame(PING, b"x", fin=False), 1002, id="5.1 a ping in pieces"),
        pytest.param(frame(CONT, packed(2)), 1002, id="5.9 nothing to continue"),
        pytest.param(
            frame(TEXT, b"{", fin=False) + frame(BINARY, packed(2)), 1002, id="5.18 no continuation"
        ),
        pytest.param(frame(TEXT, text(2)[:-3] + b"\xed\xa0\x80"), 1007, id="6.3 a surrogate"),
        pytest.param(frame(TEXT, text(2) + b"\xce"), 1007, id="6.6 half a character"),
        pytest.param(frame(TEXT, b"{\xf4\x90", fin=False) + frame(CONT, b"}"), 1007, id="6.4 in two"),
        pytest.param(frame(CLOSE, b"a"), 1002, id="7.3.2 close with one byte"),
        pytest.param(frame(CLOSE, (1005).to_bytes(2, "big")), 1002, id="7.9.4 close with 1005"),
        pytest.param(bytes([0x82, 30]) + packed(2) + GOOD, 1002, id="no mask, and a good frame behind it"),
        pytest.param(b"\x82\xff" + b"\xff" * 8 + MASK, 1009, id="the highest length"),
    ],
)
def test_a_violation_ends_the_session_with_its_code(
    data: bytes, code: int, piece: int, before: bytes, client: Client, here: Running
) -> None:
    client.send(before + data, piece)
    assert client.closed()[0] == code
    with Client(here.port) as other:
        other.send(frame(BINARY, packed(3)))
        assert other.predicted() == 3


@pytest.mark.parametrize(
    ("frames", "code", "close"),
    [
        pytest.param(frame(PING, b"x" * 125) * 2000, "too_fast", 1008, id="pings"),
        pytest.param(frame(PONG, b"x") * 2000, "too_fast", 1008, id="pongs"),
        pytest.param(BEGUN + frame(CONT, b"", fin=False) * 2000, "too_fast", 1008, id="empty pieces"),
        pytest.param(BEGUN + frame(CONT, b" ", fin=False) * 45_000, "too_fast", 1008, id="pieces of a byte"),
        pytest.param(LONG, "too_large", 1009, id="a message of more than 1 MiB"),
        pytest.param(GROWN, "too_large", 1009, id="one that grows beyond it"),
    ],
)
def test_a_flood_below_the_messages_is_told_why_and_closed_while_others_go_on(
    frames: bytes, code: str, close: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pointpred_server.websocket_protocol, "LINGER_S", PATIENCE_S)
    with running() as here, Client(here.port) as other:
        with Client(here.port) as flooding:
            flooding.send(GOOD)
            assert flooding.predicted() == 1
            flooding.send(frames)
            assert flooding.closed() == (close, [code])
        other.send(frame(TEXT, text(2)))
        assert other.predicted() == 2
        value = here.service.metrics.registry.get_sample_value
        ended = partial(value, "pointpred_sessions_ended_total", {"code": str(close)})
        soon(lambda: ended() == 1.0, "its session is over")
        assert len(here.service._open) == 1
        assert value("pointpred_refused_total", {"code": code}) == 1.0


def test_what_breaks_in_a_session_ends_that_session_only(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    real, secret = PointingSession.receive, 7315.25

    def broken(self: PointingSession, sent: str | bytes, now: Instant) -> None:
        if sent == '{"type":"reset"}':
            raise RuntimeError(f"at {secret}")
        real(self, sent, now)

    monkeypatch.setattr(PointingSession, "receive", broken)
    with running() as here, here.greeted() as other, here.greeted() as one:
        one.send('{"type":"reset"}')
        ends(one, "internal", 1011)
        other.send(event(1.0))
        assert told(other)["t"] == 1.0
        soon(lambda: len(here.service._open) == 1, "the broken session is gone")
    (entry,) = (record for record in caplog.records if record.levelno == logging.ERROR)
    for style in (JsonLines(), PlainLines()):
        line = style.format(entry)
        assert "RuntimeError at" in line
        assert "test_websocket.py" in line
        assert str(secret) not in line


def test_a_client_that_never_reads_is_told_and_then_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its session ends as too slow, and its connection with it, although it stays open on its side."""
    monkeypatch.setattr(pointpred_server.service, "TICK_S", 0.2)
    monkeypatch.setattr(pointpred_server.websocket_protocol, "STUCK_S", 1.0)
    monkeypatch.setattr(pointpred_server.websocket_protocol, "LINGER_S", 0.5)
    with running(max_events_per_s=10**8) as here, Client(here.port, EACH) as silent:
        silent.socket.settimeout(1.0)
        for second in range(2000):
            silent.send(frame(BINARY, packed(float(second), 64)))
        soon(lambda: not here.service._open, "the session is over")
        soon(lambda: not here.server.server_state.connections, "the connection is cut")
        value = here.service.metrics.registry.get_sample_value
        assert value("pointpred_sessions_ended_total", {"code": "1013"}) == 1.0
        assert (value("pointpred_predictions_dropped_total") or 0.0) > 1000


def test_a_client_that_sends_much_leaves_others_their_turn(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever waits of one client: after ``READ_BYTES`` of it, all others are heard."""
    real, order, busy, go_on = PointingSession.receive, [], threading.Event(), threading.Event()

    def noted(self: PointingSession, sent: str | bytes, now: Instant) -> None:
        if sent == '{"type":"reset"}':
            busy.set()
            assert go_on.wait(PATIENCE_S)
        order.append(sent)
        real(self, sent, now)

    with running() as here, Client(here.port) as third, Client(here.port) as much, Client(here.port) as one:
        monkeypatch.setattr(PointingSession, "receive", noted)
        third.send(frame(TEXT, b'{"type":"reset"}'))
        assert busy.wait(PATIENCE_S)
        much.send(frame(BINARY, packed(1)) * 1500)
        one.send(frame(BINARY, packed(2)))
        go_on.set()
        assert one.predicted() == 2
        soon(lambda: len(order) == 1502, "all is heard")
    before = order.index(packed(2)) - 1
    assert before * len(frame(BINARY, packed(1))) <= 2 * pointpred_server.websocket_protocol.READ_BYTES


def test_what_comes_after_the_end_is_not_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """A client that goes on to send takes no time from others, and is cut."""
    real, looked_at = ServerProtocol.receive_data, []

    def noted(self: ServerProtocol, data: bytes) -> None:
        looked_at.append(len(data))
        real(self, data)

    monkeypatch.setattr(pointpred_server.websocket_protocol, "LINGER_S", 1.0)
    with running() as here, Client(here.port) as flooding:
        monkeypatch.setattr(ServerProtocol, "receive_data", noted)
        flooding.send(frame(PING, b"") * 2000)
        assert flooding.closed() == (1008, ["too_fast"])
        flooding.send(frame(PING, b"") * 50_000)
        soon(lambda: not here.server.server_state.connections, "the connection is cut")
    assert sum(looked_at) < 20_000


def test_a_slow_reader_gets_the_newest_and_goes_on() -> None:
    with running(max_events_per_s=10**8) as here, Client(here.port, EACH) as slow:
        (session,) = here.service._open
        for second in range(3000):
            slow.send(frame(BINARY, packed(float(second), 64)))
        soon(lambda: session.events == 3000 * 64, "all is taken in, whatever is read")
        answers = 0
        while b'"t":2999.063' not in slow.receive()[1]:
            answers += 1
        assert answers < 3000 * 64
        assert session.outbox.dropped_total > 1000


def test_a_client_that_says_nothing_is_asked_and_then_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pointpred_server.service, "TICK_S", 0.1)
    monkeypatch.setattr(pointpred_server.websocket_protocol, "PING_S", 0.5)
    monkeypatch.setattr(pointpred_server.websocket_protocol, "PONG_S", 0.5)
    with running() as here, Client(here.port) as client:
        for _ in range(2):
            assert client.receive() == (PING, b"")
            client.send(frame(PONG, b""))
        assert client.receive() == (PING, b"")
        assert client.closed() == (1011, [])


def test_a_client_without_hello_is_sent_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.sessions.lifecycle.HELLO_S", 0.5)
    with running() as here, here.connect() as one:
        ends(one, "idle", 1008)


def test_how_sessions_end_is_counted() -> None:
    with running() as here:
        value = here.service.metrics.registry.get_sample_value
        with here.greeted(EACH) as one:
            one.send('{"type":"events","events":[[1,5,6,null,null,0],[2,5,6,null,null,0]]}')
            assert [told(one)["t"], told(one)["t"]] == [1.0, 2.0]
        with Client(here.port) as lost:
            lost.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        for code in ("1000", "1006"):
            soon(lambda code=code: value("pointpred_sessions_ended_total", {"code": code}) == 1.0, code)
        counted = {
            name: value(f"pointpred_{name}_total")
            for name in ("frames", "events", "predictions", "predictions_dropped")
        }
        assert counted == {"frames": 3.0, "events": 2.0, "predictions": 2.0, "predictions_dropped": 0.0}


@pytest.mark.parametrize(
    ("request_bytes", "status"),
    [
        pytest.param(LINE + UPGRADE + b"Cookie: " + b"x" * 8000 + b"\r\n\r\n", 101, id="a cookie of 8 kB"),
        pytest.param(LINE.replace(b"stream", b"x") + UPGRADE + b"\r\n", 404, id="another path"),
        pytest.param(LINE.replace(b"stream", b"live") + UPGRADE + b"\r\n", 404, id="no device"),
        pytest.param(LINE + UPGRADE + b"Cookie: " + b"x" * 20_000 + b"\r\n\r\n", 400, id="20 kB"),
        pytest.param(LINE + UPGRADE + b"X-More: a\r\n" * 2000 + b"\r\n", 400, id="2,000 headers"),
        pytest.param(LINE.replace(b"GET", b"POST") + UPGRADE + b"\r\n", 405, id="POST"),
        pytest.param(LINE + UPGRADE.replace(b"dGhl", b"!!!!") + b"\r\n", 400, id="a key that is none"),
        pytest.param(LINE + UPGRADE.replace(b"13", b"12") + b"\r\n", 400, id="another version"),
        pytest.param(LINE + UPGRADE.replace(b"127.0.0.1", b"evil.example") + b"\r\n", 403, id="another host"),
        pytest.param(LINE + UPGRADE + b"Origin: http://evil.example\r\n\r\n", 403, id="another site"),
    ],
)
@pytest.mark.parametrize("behind", [b"", b"garbage behind it" * 9], ids=["alone", "with garbage behind it"])
def test_every_request_for_a_websocket_is_answered(
    request_bytes: bytes, behind: bytes, status: int, caplog: pytest.LogCaptureFixture
) -> None:
    with running() as here:
        with socket.create_connection(("127.0.0.1", here.port), PATIENCE_S) as opened:
            opened.sendall(request_bytes + behind)
            heard = opened.recv(4096)
            assert heard.startswith(b"HTTP/1.1 %d " % status)
            if status != 101:
                opened.shutdown(socket.SHUT_WR)
                while opened.recv(4096):
                    pass
        soon(lambda: not here.server.server_state.connections, "it is closed")
    assert not [one for one in caplog.records if one.levelno >= logging.ERROR]


def test_who_is_turned_away_is_counted() -> None:
    with running(max_sessions=1, token=TOKEN) as here:
        refused = partial(
            here.service.metrics.registry.get_sample_value, "pointpred_connections_refused_total"
        )
        with pytest.raises(InvalidStatus), here.connect("?token=open+sesame", origin="http://evil.example"):
            pass
        for path, headers, status in (
            ("/healthz", {"Host": "evil.example"}, 403),
            ("/v1/samples", {}, 401),
            ("/v1/samples", {"Authorization": "Basic open sesame"}, 401),
            ("/v1/samples", {"Authorization": "bearer open sesame"}, 200),
        ):
            answer = get(f"{here.url}{path}", headers=headers, timeout=PATIENCE_S)
            assert answer.status_code == status, (path, headers)
        with here.connect() as one:
            ends(one, "unauthorized", 1008)
        assert refused({"code": "unauthorized"}) == 5.0
        with here.connect("?token=open+sesame"):
            soon(lambda: len(here.service._open) == 1, "one session is open")
            with here.connect("?token=open+sesame") as one:
                ends(one, "too_many", 1013)
        assert refused({"code": "too_many"}) == 1.0


@pytest.mark.parametrize(
    ("proto", "scheme", "trusted", "admitted"),
    [
        (None, "http", True, True),
        (None, "https", True, False),
        ("https", "https", True, True),
        ("https", "http", True, False),
        ("https", "https", False, False),
        ("https", "http", False, True),
    ],
)
def test_a_page_is_our_own_by_scheme_and_host(
    proto: str | None, scheme: str, trusted: bool, admitted: bool
) -> None:
    """The scheme is what a proxy says, where one is trusted."""
    with running(token=TOKEN, trust_proxy=["127.0.0.1"] if trusted else []) as here, ExitStack() as stack:
        if not admitted:
            stack.enter_context(pytest.raises(InvalidStatus))
        with here.connect(
            origin=f"{scheme}://127.0.0.1:{here.port}",
            additional_headers={"X-Forwarded-Proto": proto} if proto else {},
        ):
            pass


@pytest.mark.parametrize(
    ("shown", "admitted"),
    [
        ("127.0.0.1", 3),
        ("::1", 3),
        ("::ffff:127.0.0.1", 3),
        ("192.0.2.7", 1),
        ("10.0.0.1, 192.0.2.7", 1),
        ("192.0.2.7, 127.0.0.1", 1),
    ],
)
def test_an_address_of_another_machine_has_a_share_of_the_sessions(shown: str, admitted: int) -> None:
    """A proxy on this machine is believed, and sessions of this machine have no share of their own."""
    settings: dict[str, Any] = {"token": TOKEN, "trust_proxy": ["127.0.0.1"], "max_per_address": 1}
    headers = {"Authorization": f"Bearer {TOKEN}", "X-Forwarded-For": shown}
    with running(**settings) as here:
        for _ in range(2):  # those that are over are not counted
            answers = []
            with ExitStack() as sessions:
                for _ in range(3):
                    one = sessions.enter_context(here.connect(additional_headers=headers))
                    with suppress(ConnectionClosed):
                        one.send(HELLO)
                    answers.append(told(one)["type"])
            assert answers == ["welcome"] * admitted + ["error"] * (3 - admitted)
            soon(lambda: not here.service._open, "they are over")


def test_a_plain_request_of_the_stream_is_told_what_the_path_speaks(here: Running) -> None:
    answer = get(f"{here.url}/v1/stream", timeout=PATIENCE_S)
    assert answer.status_code == 426
    assert "WebSocket" in answer.text
    assert answer.headers["Upgrade"] == "websocket"
