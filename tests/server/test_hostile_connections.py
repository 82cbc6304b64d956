"""Who is turned away, and what it is told and counted as; connections that never become a request."""

from __future__ import annotations

import asyncio
import json
import logging
import socket as socket_module
import threading
from contextlib import ExitStack, suppress
from typing import Any

import pytest
from httpx2 import get
from uvicorn.protocols.utils import ClientDisconnected
from websockets.exceptions import ConnectionClosed, InvalidStatus

from pointpred_server.connection import FRAMES
from pointpred_server.endpoints import StreamEndpoint
from pointpred_server.service import Service
from tests.server.fake_socket import FakeSocket
from tests.server.listener import soon
from tests.server.running import HELLO, PATIENCE_S, Running, running

TOKEN = "open sesame"


def refused(here: Running, code: str) -> float | None:
    name = "pointpred_connections_refused_total"
    return here.service.metrics.registry.get_sample_value(name, {"code": code})


def test_who_is_turned_away_is_counted() -> None:
    with running(max_sessions=1, token=TOKEN) as here:
        for wrong in ({"origin": "http://evil.example"}, {"additional_headers": {"Host": "evil.example"}}):
            with pytest.raises(InvalidStatus), here.connect("?token=open+sesame", **wrong):
                pass
        assert refused(here, "unauthorized") == 2.0
        assert (
            get(f"{here.url}/healthz", headers={"Host": "evil.example"}, timeout=PATIENCE_S).status_code
            == 403
        )
        assert refused(here, "unauthorized") == 3.0
        assert get(f"{here.url}/metrics", timeout=PATIENCE_S).status_code == 401
        assert refused(here, "unauthorized") == 4.0
        with here.connect() as socket:
            assert json.loads(socket.recv(PATIENCE_S))["code"] == "unauthorized"
            with pytest.raises(ConnectionClosed):
                socket.recv(PATIENCE_S)
        assert refused(here, "unauthorized") == 5.0
        with here.connect("?token=open+sesame"):
            soon(lambda: here.service.full, "one session is open")
            with here.connect("?token=open+sesame") as socket:
                assert json.loads(socket.recv(PATIENCE_S))["code"] == "too_many"
        assert refused(here, "too_many") == 1.0


@pytest.mark.parametrize(
    ("shown", "admitted"),
    [
        ("Bearer open sesame", True),
        ("bearer open sesame", True),
        ("open sesame", False),
        ("Basic open sesame", False),
    ],
)
def test_a_token_comes_after_the_word_bearer_in_any_case(shown: str, admitted: bool) -> None:
    with running(token=TOKEN) as here:
        status = get(
            f"{here.url}/metrics", headers={"Authorization": shown.format(TOKEN)}, timeout=PATIENCE_S
        ).status_code
        assert status == (200 if admitted else 401)


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
    with running(token=TOKEN, trust_proxy=["127.0.0.1"] if trusted else []) as here:
        options = {"origin": f"{scheme}://127.0.0.1:{here.port}"}
        headers = {"X-Forwarded-Proto": proto} if proto else {}
        if admitted:
            with here.connect(**options, additional_headers=headers):
                pass
        else:
            with pytest.raises(InvalidStatus), here.connect(**options, additional_headers=headers):
                pass


def test_a_plain_request_of_the_stream_is_told_what_the_path_speaks() -> None:
    with running() as here:
        answer = get(f"{here.url}/v1/stream", timeout=PATIENCE_S)
    assert answer.status_code == 426
    assert "WebSocket" in answer.text
    assert answer.headers["Upgrade"] == "websocket"


def test_leaving_while_the_service_stops_is_no_error() -> None:
    service, socket = Service(), FakeSocket()

    def come() -> None:
        socket.there.receive([HELLO])
        service.stop()

    async def receive() -> dict[str, str]:
        return {"type": "websocket.connect"}

    async def send(message: dict[str, object]) -> None:
        if message["type"] != "websocket.accept":
            raise ClientDisconnected

    socket.on_attach = come
    extensions = {FRAMES: {"socket": socket}}
    scope = {"type": "websocket", "headers": [], "query_string": b"", "extensions": extensions}
    asyncio.run(StreamEndpoint(service)(scope, receive, send))
    assert not service._open


def half(here: Running, sent: bytes) -> socket_module.socket:
    opened = socket_module.create_connection(("127.0.0.1", here.port))
    opened.settimeout(PATIENCE_S)
    opened.sendall(sent)
    return opened


WHOLE = b"GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"


@pytest.mark.parametrize("sent", [b"", b"GET / HTT", WHOLE[:-2]])
def test_a_connection_without_a_whole_header_is_closed(sent: bytes, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("pointpred_server.http_protocol.HEADER_S", 0.3)
    with running() as here, half(here, sent) as opened:
        ends(here, opened)


def test_an_incomplete_second_header_closes_the_connection(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with running() as here, half(here, WHOLE) as opened:
        healthy(opened)
        # Not before: the first answer takes its time, and so may what comes of the first header.
        monkeypatch.setattr("pointpred_server.http_protocol.HEADER_S", 0.3)
        opened.sendall(b"GET / HTT")
        ends(here, opened)


def ends(here: Running, opened: socket_module.socket) -> None:
    """The service closes a connection, and says nothing more."""
    with suppress(ConnectionResetError):  # what was sent came after the end, where the machine is busy
        assert not opened.recv(4096)
    soon(lambda: not here.server.server_state.connections, "it is closed")


def test_a_header_without_end_is_refused() -> None:
    with running() as here, half(here, WHOLE[:-2]) as opened:
        lines = (b"X-More: " + b"x" * 1000 + b"\r\n") * 50_000  # more than the kernel takes for both
        with pytest.raises((ConnectionResetError, BrokenPipeError)):
            opened.sendall(lines)
        assert refused(here, "too_large") == 1.0
        soon(lambda: not here.server.server_state.connections, "it is closed")


def healthy(opened: socket_module.socket) -> None:
    """Read one whole answer."""
    heard = b""
    while b'"ok"' not in heard or not heard.endswith(b"}"):
        part = opened.recv(4096)
        assert part, "closed"
        heard += part


def test_the_header_timer_spares_later_requests_and_sessions(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(
        "pointpred_server.http_protocol.HEADER_S", 2.0
    )  # a first header may take a while, too
    with running() as here, here.greeted() as socket, half(here, WHOLE) as opened:
        healthy(opened)
        with pytest.raises(TimeoutError):
            socket.recv(2.5)
        opened.sendall(WHOLE)
        healthy(opened)
        socket.send('{"type":"events","events":[[1,5,6,null,null,0]]}')
        assert json.loads(socket.recv(PATIENCE_S))["t"] == 1.0
    assert not [entry for entry in caplog.records if entry.levelno >= logging.WARNING]


@pytest.mark.skipif(not socket_module.has_dualstack_ipv6(), reason="no socket for IPv4 and IPv6 here")
@pytest.mark.parametrize(
    ("shown", "admitted"),
    [("127.0.0.1", 3), ("::1", 3), ("::ffff:127.0.0.1", 3), ("192.0.2.7", 1), ("192.0.2.8:4711", 1)],
)
def test_addresses_are_the_same_on_a_socket_for_ipv4_and_ipv6(shown: str, admitted: int) -> None:
    """A proxy on this machine is believed, and sessions of this machine have no share of their own."""
    settings: dict[str, Any] = {"token": TOKEN, "trust_proxy": ["127.0.0.1"], "max_per_address": 1}
    headers = {"Authorization": f"Bearer {TOKEN}", "X-Forwarded-For": shown}
    answers = []
    with running(host="::", **settings) as here, ExitStack() as sessions:
        for _ in range(3):
            socket = sessions.enter_context(here.connect(additional_headers=headers))
            with suppress(ConnectionClosed):
                socket.send(HELLO)
            answers.append(json.loads(socket.recv(PATIENCE_S))["type"])
    assert answers == ["welcome"] * admitted + ["error"] * (3 - admitted)


def test_an_endless_request_is_cancelled_when_the_service_stops(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr("pointpred_server.listening.REQUESTS_END_S", 1)
    begun = threading.Event()

    async def endless(self: Service) -> bytes:
        begun.set()
        await asyncio.sleep(PATIENCE_S)
        return b""

    monkeypatch.setattr(Service, "metrics_text", endless)
    with running() as here:
        opened = half(here, b"GET /metrics HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        assert begun.wait(PATIENCE_S), "it is under way"
    opened.close()
    (entry,) = (one for one in caplog.records if one.levelno >= logging.WARNING)
    assert entry.args == (1, 1), "requests that had not ended, seconds after the stop"
    assert entry.exc_info is None


def test_an_address_of_another_machine_has_a_share_of_the_sessions(monkeypatch: pytest.MonkeyPatch) -> None:
    with running(max_sessions=4) as here:
        with ExitStack() as others:
            for _ in range(4):
                others.enter_context(here.greeted())  # this machine has no share of its own
            soon(lambda: here.service.full, "every session is open")
        soon(lambda: not here.service._open, "they are over")
        monkeypatch.setattr("pointpred_server.endpoints._address", lambda scope: "192.0.2.7")
        with here.greeted(), here.greeted():
            with here.connect() as socket:
                error = json.loads(socket.recv(PATIENCE_S))
                assert (error["code"], error["message"][:2]) == ("too_many", "2 ")
            monkeypatch.setattr("pointpred_server.endpoints._address", lambda scope: "192.0.2.8")
            with here.greeted():
                pass
        soon(lambda: not here.service._open, "they are over")
        with here.service.networks.place("192.0.2.7") as sessions:
            assert sessions == 1, "those that are over are not counted"
