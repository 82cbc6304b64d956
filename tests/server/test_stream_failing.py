"""What a connection does when something breaks: a session that fails, a client that never reads again."""

from __future__ import annotations

import asyncio
import json
import logging
import socket as socket_module
import struct
import time
from collections.abc import Callable
from contextlib import suppress

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.frames import Opcode
from websockets.sync.client import ClientConnection

import pointpred_server.connection
import pointpred_server.websocket_protocol
from pointpred.protocol.frames import Frame
from pointpred.protocol.server_messages import Limits
from pointpred_server import listening
from pointpred_server.arrivals import Arrivals
from pointpred_server.connection import Connection
from pointpred_server.logs import JsonLines, PlainLines
from pointpred_server.sessions.lifecycle import Close
from pointpred_server.sessions.pointing import PointingSession
from tests.server.fake_socket import FakeSocket
from tests.server.hurried import HurriedLoop
from tests.server.listener import soon
from tests.server.running import HELLO, PATIENCE_S, Running, running
from tests.server.test_hostile_frames import raw

EACH = HELLO.replace('"switched"', '"switched","reply":"event"')
SECRET = 7315.25


def event(t: float) -> str:
    return f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}'


def told(socket: ClientConnection) -> dict[str, object]:
    answer: dict[str, object] = json.loads(socket.recv(PATIENCE_S))
    return answer


def histogram(here: Running, what: str) -> float:
    value = here.service.metrics.registry.get_sample_value(f"pointpred_event_to_prediction_seconds_{what}")
    assert value is not None
    return value


def ended(here: Running, code: str) -> float | None:
    """How many sessions have ended with a close code."""
    return here.service.metrics.registry.get_sample_value("pointpred_sessions_ended_total", {"code": code})


def test_what_breaks_in_a_session_ends_that_session_only(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    real: Callable[[PointingSession, str | bytes, float], None] = PointingSession.receive

    def broken(self: PointingSession, frame: str | bytes, now: float) -> None:
        if frame == '{"type":"reset"}':
            raise RuntimeError(f"at {SECRET}")
        real(self, frame, now)

    monkeypatch.setattr(PointingSession, "receive", broken)
    with running() as here, here.greeted() as other, here.greeted() as socket:
        socket.send('{"type":"reset"}')
        answer = told(socket)
        assert (answer["type"], answer["code"], answer["recoverable"]) == ("error", "internal", False)
        with pytest.raises(ConnectionClosed) as closed:
            socket.recv(PATIENCE_S)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1011
        other.send(event(1.0))
        assert told(other)["t"] == 1.0
        # The end is counted last of all, by another thread.
        soon(lambda: ended(here, "1011") == 1.0, "the broken session is gone")
        assert len(here.service._open) == 1
        assert 'pointpred_refused_total{code="internal"} 1.0' in here.service.metrics.text().decode()
    (entry,) = (record for record in caplog.records if record.levelno == logging.ERROR)
    for style in (JsonLines(), PlainLines()):
        line = style.format(entry)
        assert "RuntimeError at" in line
        assert "test_stream_failing.py" in line
        assert str(SECRET) not in line


def test_a_client_that_never_reads_again_is_told_and_then_cut(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its session ends as too slow, and its connection with it, although it stays open on its side."""
    monkeypatch.setattr(pointpred_server.connection, "STUCK_S", 1.0)
    monkeypatch.setattr(pointpred_server.connection, "GRACE_S", 1.0)
    monkeypatch.setattr(pointpred_server.websocket_protocol, "LINGER_S", 0.5)
    with running(max_events_per_s=10**8) as here:
        with here.greeted(EACH, max_queue=1, close_timeout=0.1) as silent:
            with suppress(ConnectionClosed):  # it may be cut before it has said everything
                for k in range(12):
                    rows = [[k + 0.001 * i, float(i), 1.0, None, None, 0] for i in range(1000)]
                    silent.send(json.dumps({"type": "events", "events": rows}))
            soon(lambda: not here.service._open, "the session is over")
            soon(lambda: not here.server.server_state.connections, "the connection is cut")
        soon(lambda: ended(here, "1013") == 1.0, "it was too slow")


@pytest.mark.parametrize(("each_s", "close"), [(0.03, None), (60.0, 1013)])
def test_a_slow_reader_goes_on_and_a_stuck_one_is_ended(
    monkeypatch: pytest.MonkeyPatch, each_s: float, close: int | None
) -> None:
    """Something always waits to be sent, far longer than a client may be stuck."""
    monkeypatch.setattr(pointpred_server.connection, "TICK_S", 0.1)
    monkeypatch.setattr(pointpred_server.connection, "STUCK_S", 0.5)
    monkeypatch.setattr(pointpred_server.connection, "GRACE_S", 0.3)

    async def talk() -> Close | None:
        loop = asyncio.get_running_loop()
        session = PointingSession("here", Limits(max_events_per_s=10**6), loop.time())
        frames = iter([HELLO, *(event(float(t)) for t in range(100_000))])

        def write(frame: Frame) -> None:
            socket.can_write = False
            loop.call_later(each_s, read)

        def read() -> None:
            socket.can_write = True
            if socket.receiver is not None:
                socket.there.flush()

        def come() -> None:
            if socket.receiver is not None:
                socket.there.receive([next(frames)])
                loop.call_later(0.002, come)

        socket = FakeSocket(write)
        socket.on_attach = come
        with suppress(TimeoutError):
            await asyncio.wait_for(Connection(session, socket, Arrivals()).run(), 2.0)
        assert session.outbox.dropped_total > 0
        return session.close

    with asyncio.Runner(loop_factory=HurriedLoop) as runner:
        end = runner.run(talk())
    assert (end.code if end else None) == close


def test_what_a_client_sent_before_it_left_is_taken_in() -> None:
    """Its end stands behind its last frames, and the answer to the first of them cannot be sent any more."""
    heard: list[str | bytes] = []

    class Listening(PointingSession):
        def receive(self, frame: str | bytes, now: float) -> None:
            heard.append(frame)
            super().receive(frame, now)

    async def talk() -> None:
        session = Listening("here", Limits(), asyncio.get_running_loop().time())
        socket = FakeSocket()

        def come() -> None:
            socket.there.receive([HELLO, *(event(float(t)) for t in range(100))])
            socket.there.disconnect(None)

        socket.on_attach = come
        await Connection(session, socket, Arrivals()).run()

    asyncio.run(talk())
    assert len(heard) == 101


def test_what_came_before_a_connection_was_cut_is_taken_in_without_answers(
    caplog: pytest.LogCaptureFixture,
) -> None:
    """It is parsed in turns, and its answers find a transport that refuses to send."""
    with running() as here, here.greeted(EACH) as client:
        sent = []
        for i in range(400):
            text = event(float(i)).encode()
            sent.append(raw(Opcode.TEXT, text[:9], fin=False) + raw(Opcode.CONT, text[9:]))
        client.socket.sendall(b"".join(sent))
        client.socket.setsockopt(socket_module.SOL_SOCKET, socket_module.SO_LINGER, struct.pack("ii", 1, 0))
        client.socket.close()
        soon(lambda: not here.service._open, "the session is over")
    assert "session failed" not in caplog.text


def test_the_delay_is_of_predictions_only_and_finer_than_a_millisecond() -> None:
    with running() as here, here.greeted() as socket:
        time.sleep(1.5)  # silence is no delay
        socket.send('{"type":"targets","targets":[]}')
        assert told(socket)["type"] == "targets"
        assert histogram(here, "count") == 0.0
        for i in range(100):
            socket.send(event(float(i)))
            assert told(socket)["t"] == i
        soon(lambda: histogram(here, "count") == 100.0, "every prediction is timed")
        total = histogram(here, "sum")
        assert 0.0 < total < 5.0
        assert abs(total * 1000 - round(total * 1000)) > 1e-9, "a clock of whole milliseconds"


def test_frames_events_and_predictions_are_counted() -> None:
    with running() as here:
        with here.greeted(EACH) as socket:
            socket.send('{"type":"events","events":[[1,5,6,null,null,0],[2,5,6,null,null,0]]}')
            assert [told(socket)["t"], told(socket)["t"]] == [1.0, 2.0]
        soon(lambda: ended(here, "1006") == 1.0, "the session is over")  # counted last of all
        counted = {
            name: here.service.metrics.registry.get_sample_value(f"pointpred_{name}_total")
            for name in ("frames", "events", "predictions", "predictions_dropped")
        }
        assert counted == {"frames": 2.0, "events": 2.0, "predictions": 2.0, "predictions_dropped": 0.0}


def test_a_frame_above_the_framework_limit_ends_one_connection() -> None:
    with running() as here, here.greeted() as other:
        with here.greeted() as socket:
            socket.send(b"\0" * (2**20 + 1))
            assert told(socket)["code"] == "too_large"
            with pytest.raises(ConnectionClosed) as closed:
                socket.recv(PATIENCE_S)
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == 1009
        with here.greeted() as socket:  # what lies between the limits
            socket.send(b"\0" * 2**19)
            assert told(socket)["code"] == "too_large"
        other.send(event(1.0))
        assert told(other)["t"] == 1.0


def test_text_that_is_not_utf8_ends_that_connection_only() -> None:
    with running() as here, here.greeted() as other:
        with here.greeted() as socket:
            socket.send(b'{"type":"\xff"}', text=True)
            with pytest.raises(ConnectionClosed) as closed:
                socket.recv(PATIENCE_S)
            assert closed.value.rcvd is not None
            assert closed.value.rcvd.code == 1007
        other.send(event(1.0))
        assert told(other)["t"] == 1.0


def test_a_client_without_hello_is_sent_away_with_1008(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.sessions.lifecycle.HELLO_S", 0.5)
    with running() as here, here.connect() as socket:
        answer = told(socket)
        assert (answer["code"], answer["recoverable"]) == ("idle", False)
        assert "hello" in str(answer["message"])
        with pytest.raises(ConnectionClosed) as closed:
            socket.recv(PATIENCE_S)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1008


def test_events_before_hello_are_out_of_place_and_hello_still_works() -> None:
    with running() as here, here.connect() as socket:
        for early in (event(1.0), b"\0" * 30):
            socket.send(early)
            assert told(socket)["code"] == "out_of_place"
        socket.send(HELLO)
        assert told(socket)["type"] == "welcome"
        socket.send(event(1.0))
        assert told(socket)["t"] == 1.0


def test_a_slow_client_that_still_sends_gets_the_bye(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Closing at once would reset the connection, and what was said last would be lost."""
    assert listening.CLOSE_S > 1.5  # the second that follows, and some
    monkeypatch.setattr(listening, "CLOSE_S", PATIENCE_S)  # that second may last longer on a busy machine
    monkeypatch.setattr(pointpred_server.websocket_protocol, "LINGER_S", PATIENCE_S)
    with running() as here, socket_module.create_connection(("127.0.0.1", here.port)) as plain:
        key = "AAAAAAAAAAAAAAAAAAAAAA=="
        plain.sendall(
            f"GET /v1/stream HTTP/1.1\r\nHost: 127.0.0.1:{here.port}\r\nUpgrade: websocket\r\n"
            f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
        )
        soon(lambda: b"\r\n\r\n" in plain.recv(4096, socket_module.MSG_PEEK), "the upgrade")
        hello = HELLO.encode()
        plain.sendall(bytes([0x81, 0x80 | len(hello)]) + b"\0\0\0\0" + hello)
        soon(lambda: b"welcome" in plain.recv(4096, socket_module.MSG_PEEK), "the welcome")
        here.server.should_exit = True
        for _ in range(10):  # it goes on sending, and hears nothing for a second
            time.sleep(0.1)
            plain.sendall(bytes([0x82, 0x80]) + b"\0\0\0\0")
        plain.settimeout(PATIENCE_S)
        heard = b""
        while b'"bye"' not in heard:
            more = plain.recv(4096)
            assert more, "closed without a goodbye"
            heard += more
