"""Requests that no browser sends, and long ones that a browser may: every one is answered, and ends."""

from __future__ import annotations

import asyncio
import json
import logging
import math
import socket as socket_module
import time
from pathlib import Path
from typing import Any

import pytest

from pointpred.protocol.client_messages import Hello
from pointpred.recorder.writer import Recorder
from pointpred_server.access import usual_address as usual
from pointpred_server.request_rates import REQUESTS_AT_ONCE, REQUESTS_PER_S, RequestRates
from tests.server.listener import soon
from tests.server.running import PATIENCE_S, Running, running
from tests.server.test_hostile_connections import half, refused

UPGRADE = (
    b"Host: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
)
LINE = b"GET /v1/stream HTTP/1.1\r\n"
TOKEN = "open sesame"


def answer(opened: socket_module.socket) -> bytes:
    """Everything until the service closes."""
    heard = b""
    while part := opened.recv(2**16):
        heard += part
    return heard


@pytest.mark.parametrize(
    ("request_bytes", "status"),
    [
        pytest.param(LINE + UPGRADE + b"Cookie: " + b"x" * 8300 + b"\r\n\r\n", 101, id="a cookie of 8.3 kB"),
        pytest.param(LINE + UPGRADE + b"Cookie: " + b"x" * 60_000 + b"\r\n\r\n", 101, id="a cookie of 60 kB"),
        pytest.param(LINE + UPGRADE + b"X-More: a\r\n" * 200 + b"\r\n", 101, id="200 headers"),
        pytest.param(
            b"GET /v1/stream?x=" + b"a" * 4000 + b" HTTP/1.1\r\n" + UPGRADE + b"\r\n", 101, id="a long query"
        ),
        pytest.param(
            b"GET /v1/stream?x=" + b"a" * 9000 + b" HTTP/1.1\r\n" + UPGRADE + b"\r\n", 414, id="one too long"
        ),
        pytest.param(LINE + UPGRADE + b"Cookie: " + b"x" * 100_000 + b"\r\n\r\n", 431, id="100 kB"),
        pytest.param(LINE + UPGRADE + b"X-More: a\r\n" * 2000 + b"\r\n", 431, id="2,000 headers"),
        pytest.param(LINE.replace(b"GET", b"POST") + UPGRADE + b"\r\n", 405, id="POST"),
        pytest.param(LINE.replace(b"1.1", b"1.0") + UPGRADE + b"\r\n", 400, id="HTTP 1.0"),
        pytest.param(LINE + UPGRADE + b"Content-Length: 5\r\n\r\nhello", 400, id="a body"),
        pytest.param(LINE + UPGRADE.replace(b"dGhl", b"!!!!") + b"\r\n", 400, id="a key that is none"),
        pytest.param(LINE + UPGRADE.replace(b"dGhl", b"A" * 9000) + b"\r\n", 400, id="a long key"),
        pytest.param(b"GET /v1/str\xe9am HTTP/1.1\r\n" + UPGRADE + b"\r\n", 400, id="a path not ASCII"),
    ],
)
def test_every_request_for_a_websocket_is_answered_and_counted(request_bytes: bytes, status: int) -> None:
    with running() as here:
        with half(here, request_bytes) as opened:
            if status == 101:
                assert opened.recv(4096).startswith(b"HTTP/1.1 101 ")
            else:
                heard = answer(opened)
                assert heard.startswith(b"HTTP/1.1 %d " % status)
                code = {414: "too_large", 431: "too_large", 405: "out_of_place"}.get(status)
                counted = [refused(here, one) or 0.0 for one in ("too_large", "out_of_place", "bad_field")]
                assert sum(counted) == 1.0
                assert code is None or refused(here, code) == 1.0
        soon(lambda: not here.server.server_state.connections, "it is closed")


def test_a_long_header_is_refused_before_the_token_is_looked_at_and_says_so(
    caplog: pytest.LogCaptureFixture,
) -> None:
    caplog.set_level(logging.INFO, "pointpred")
    long = LINE + UPGRADE + b"A: " + b"x" * 70_000 + b"\r\n\r\n"
    with running(token=TOKEN) as here, half(here, long) as opened:
        head, _, body = answer(opened).partition(b"\r\n\r\n")
        assert b"Connection: close" in head
        assert json.loads(body)["code"] == "too_large"
        assert "65536 bytes" in json.loads(body)["message"]
    assert [entry for entry in caplog.records if "a request was refused" in entry.message]


def test_an_upgrade_that_the_application_does_not_answer_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.websocket_protocol.UPGRADE_S", 0.2)

    async def silent(*arguments: object) -> None:
        await asyncio.Event().wait()

    monkeypatch.setattr("pointpred_server.endpoints.StreamEndpoint._admit", silent)
    monkeypatch.setattr("pointpred_server.listening.REQUESTS_END_S", 1)
    with running() as here, half(here, LINE + UPGRADE + b"\r\n") as opened:
        assert not answer_or_reset(opened)
        soon(lambda: not here.server.server_state.connections, "it is closed")


def answer_or_reset(opened: socket_module.socket) -> bytes:
    try:
        return answer(opened)
    except ConnectionResetError:
        return b""


def test_a_body_that_nobody_asked_for_is_not_read_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.http_protocol.BODY_BYTES", 2**20)
    head = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100000000\r\n\r\n"
    with running() as here, half(here, head) as opened:
        with pytest.raises((ConnectionResetError, BrokenPipeError)):
            opened.sendall(b"x" * 90_000_000)
        soon(lambda: not here.server.server_state.connections, "it is closed")


@pytest.mark.parametrize("dribble", [b"x", b""])
def test_a_client_that_sends_a_little_after_its_response_does_not_stay(dribble: bytes) -> None:
    head = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 9\r\n\r\n"
    with running() as here:
        here.server.config.timeout_keep_alive = 0.2
        with half(here, head if dribble else head.replace(b"9", b"0")) as opened:
            assert opened.recv(4096).startswith(b"HTTP/1.1 200")
            opened.sendall(dribble or b"\r\n")
            answer_or_reset(opened)
        soon(lambda: not here.server.server_state.connections, "it is closed")


def dribble(opened: socket_module.socket) -> None:
    """Send a body that has no end."""
    while True:
        opened.sendall(b"x")
        time.sleep(0.02)


def test_a_body_that_still_comes_is_cut_some_seconds_after_the_response() -> None:
    head = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 100000000\r\n\r\n"
    with running() as here:
        here.server.config.timeout_keep_alive = 0.2
        with half(here, head) as opened, pytest.raises((ConnectionResetError, BrokenPipeError)):
            dribble(opened)


def test_requests_without_waiting_for_responses_are_bounded() -> None:
    one = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"
    with running() as here, half(here, one * 1000) as opened:
        heard = answer(opened)
        assert heard.count(b"HTTP/1.1 200") <= 17
        assert refused(here, "too_many") == 1.0


def test_a_few_requests_at_once_are_all_answered() -> None:
    one = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"
    last = one.replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n")
    with running() as here, half(here, one * 9 + last) as opened:
        assert answer(opened).count(b"HTTP/1.1 200") == 10


def test_the_service_stops_cleanly_beside_an_upgrade_that_was_refused(tmp_path: Path) -> None:
    with running(record=tmp_path) as here:
        opened = half(here, LINE.replace(b"GET", b"POST") + UPGRADE + b"\r\n")
        assert opened.recv(4096).startswith(b"HTTP/1.1 405 ")
    opened.close()
    assert here.service.recorder is not None
    assert here.service.recorder.open("late", Hello(1)) is None, "it was closed"


@pytest.mark.parametrize(
    ("target", "status"),
    [
        (b"/metrics?" + b"&".join([b"a=1"] * 64), 401),
        (b"/metrics?" + b"&".join([b"a=1"] * 65), 414),
        (b"/metrics?" + b"&" * 30_000, 414),
        (b"/metrics?a=" + b"b" * 4085, 401),
        (b"/metrics?a=" + b"b" * 4086, 414),
        (b"/" + b"%41" * 2000, 414),
    ],
    ids=["64 parameters", "65 parameters", "30,000 parameters", "4 KiB", "a byte more", "a long path"],
)
def test_a_long_query_is_refused_before_anything_reads_it(target: bytes, status: int) -> None:
    request = b"GET " + target + b" HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"
    with running(token=TOKEN) as here, half(here, request) as opened:
        assert answer(opened).startswith(b"HTTP/1.1 %d " % status)
        assert refused(here, "too_large") == (1.0 if status == 414 else None)


def test_writing_recordings_may_take_what_a_client_that_hangs_has_left_of_the_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seconds: list[float] = []
    close = Recorder.close

    def measured(self: Recorder, timeout_s: float = math.inf) -> bool:
        seconds.append(timeout_s)
        return close(self)

    monkeypatch.setattr(Recorder, "close", measured)
    monkeypatch.setattr("pointpred_server.service.STOP_TOTAL_S", 0.3)
    monkeypatch.setattr("pointpred_server.listening.REQUESTS_END_S", 1)
    with running(record=tmp_path) as here:
        opened = half(here, LINE + UPGRADE + b"\r\n")
        assert opened.recv(4096).startswith(b"HTTP/1.1 101 ")
    opened.close()
    assert seconds == [0.0], "it was closed once, and no time was left"


FILE = b"GET /web/vendor/uPlot.esm.js HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"


def reading_slowly(here: Running, sent: bytes, held: int = 4096) -> socket_module.socket:
    """A client for which the kernel holds few bytes that it has not read."""
    opened = socket_module.socket()
    opened.setsockopt(socket_module.SOL_SOCKET, socket_module.SO_RCVBUF, held)
    opened.settimeout(PATIENCE_S)
    opened.connect(("127.0.0.1", here.port))
    opened.sendall(sent)
    return opened


@pytest.mark.parametrize("sent", [FILE * 10, FILE * 2 + b"GET / HTT"], ids=["ten files", "half a request"])
def test_a_client_that_reads_no_response_is_cut(sent: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.http_protocol.UNREAD_S", 0.3)
    with running() as here, reading_slowly(here, sent):
        soon(lambda: refused(here, "slow") == 1.0, "it is noticed")
        soon(lambda: not here.server.server_state.connections, "it is closed")
        soon(lambda: not here.server.server_state.tasks, "nothing holds the file any more")


def test_a_client_that_leaves_before_its_responses_is_no_error(caplog: pytest.LogCaptureFixture) -> None:
    with running() as here:
        with reading_slowly(here, FILE * 10) as opened:
            assert opened.recv(1)
        soon(lambda: not here.server.server_state.connections, "it has left")
        soon(lambda: not here.server.server_state.tasks, "nothing holds the file any more")
    assert not [entry for entry in caplog.records if entry.levelno >= logging.WARNING]


def test_a_response_that_was_left_unread_when_its_connection_closed_is_cut(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The response has been written, and the part that the kernel did not take is small."""
    monkeypatch.setattr("pointpred_server.http_protocol.UNREAD_S", 0.3)
    monkeypatch.setattr("pointpred_server.app.CLIENT_MODULE", "/" * 500_000)
    request = b"GET /pointpred.js HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"
    with running() as here, reading_slowly(here, request):
        soon(lambda: refused(here, "slow") == 1.0, "it is noticed")
        soon(lambda: not here.server.server_state.connections, "it is closed")


def test_a_client_that_reads_slowly_gets_its_response(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.http_protocol.UNREAD_S", 0.8)
    monkeypatch.setattr("pointpred_server.app.CLIENT_MODULE", "/" * 1_000_000)
    request = b"GET /pointpred.js HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"
    with running() as here, reading_slowly(here, request, 2**17) as opened:
        heard = 0
        while part := opened.recv(100_000, socket_module.MSG_WAITALL):
            heard += len(part)
            time.sleep(0.15)
        assert heard > 1_000_000
        assert refused(here, "slow") is None


def test_a_websocket_is_not_opened_before_an_earlier_response_has_been_read() -> None:
    """The rest of that response would wait for ever."""
    with running() as here:
        with reading_slowly(here, FILE * 2 + LINE + UPGRADE + b"\r\n") as opened:
            soon(lambda: refused(here, "out_of_place") == 1.0, "it is refused")
            assert b"HTTP/1.1 101 " not in answer(opened)
        soon(lambda: not here.server.server_state.tasks, "nothing holds the file any more")


def test_a_websocket_is_not_opened_while_the_client_reads_no_refusal(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its session would never learn that what it sends is not read; the response itself is complete."""
    monkeypatch.setattr("pointpred_server.access.HOST_REFUSED", b"x" * 8_000_000)
    foreign = b"GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"
    with running() as here, reading_slowly(here, foreign) as opened:
        connections = here.server.server_state.connections
        soon(lambda: any(one.cycle and one.cycle.response_complete for one in connections), "it is refused")
        assert all(one.flow.write_paused for one in connections)
        opened.sendall(LINE + UPGRADE + b"\r\n")
        soon(lambda: refused(here, "out_of_place") == 1.0, "it is refused")


@pytest.mark.parametrize(
    ("address", "settings", "answered"),
    [
        ("192.0.2.7", {}, 3),
        ("::ffff:192.0.2.7", {}, 3),
        ("2001:db8::7", {}, 3),
        ("127.0.0.1", {}, 5),
        ("192.0.2.7", {"trust_proxy": ["192.0.2.0/24"], "token": TOKEN}, 5),
    ],
)
def test_requests_of_another_machine_are_limited(
    address: str, settings: dict[str, Any], answered: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pointpred_server.http_protocol.usual_address", lambda client: usual((address, 1)))
    monkeypatch.setattr("pointpred_server.request_rates.REQUESTS_AT_ONCE", 3)
    monkeypatch.setattr("pointpred_server.request_rates.REQUESTS_PER_S", 1e-6)
    request = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n"
    heard = []
    with running(**settings) as here:
        for sent in [request] * 4 + [LINE + UPGRADE + b"\r\n"]:
            with half(here, sent) as opened:
                heard.append(opened.recv(4096)[9:12])
        assert heard == [b"200", b"200", b"200", b"200", b"101"][:answered] + [b"429"] * (5 - answered)
        assert refused(here, "too_fast") == ((5.0 - answered) or None)


def test_requests_are_admitted_again_and_old_networks_forgotten() -> None:
    rates = RequestRates()
    times = [at / 1000 for at in range(60_000)]
    for neighbour in range(100):
        assert rates.take(f"198.51.100.{neighbour}", 0.0)
    admitted = sum(rates.take("192.0.2.7", now) for now in times)
    assert admitted == pytest.approx(REQUESTS_AT_ONCE + 60 * REQUESTS_PER_S, abs=2)
    assert rates.take("192.0.2.8", 60.0), "others are not limited by it"
    assert rates.take("192.0.2.7", 111.0)
    assert len(rates._full_at) == 1
