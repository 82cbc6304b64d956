"""What nginx and HAProxy refuse with the configurations in deploy/, and what they pass on to a service."""

from __future__ import annotations

import socket
import socketserver
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import pytest

from tests.server import reverse_proxies as proxies

PATIENCE_S = 60.0
QUIET_S = 0.5
"""After this long without another byte everything has been answered."""
ANSWER = b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\nConnection: close\r\n\r\nok"
UPGRADE = (
    b"Connection: Upgrade\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n"
)
HOST = b"Host: lab.example\r\n"


class Heard(socketserver.ThreadingTCPServer):
    """A service that keeps what each of its connections brings, but for health checks, and answers 200."""

    daemon_threads = True
    allow_reuse_address = True

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Keeping)
        self.connections: list[bytes] = []


class Keeping(socketserver.BaseRequestHandler):
    """Reads a header, answers, and reads on until the proxy closes."""

    server: Heard

    def handle(self) -> None:
        heard = b""
        self.request.settimeout(1.0)
        try:
            while part := self.request.recv(65536):
                answered = b"\r\n\r\n" in heard
                heard += part
                if not answered and b"\r\n\r\n" in heard:
                    self.request.sendall(ANSWER)
                    self.request.shutdown(socket.SHUT_WR)
        except OSError:
            pass
        if heard and not heard.startswith(b"GET /readyz"):
            self.server.connections.append(heard)


@dataclass
class Guarded:
    """A proxy in front of services that keep what they hear."""

    name: str
    port: int
    services: list[Heard]

    def dial(self) -> socket.socket:
        """A connection to the proxy."""
        return socket.create_connection(("127.0.0.1", self.port), timeout=PATIENCE_S)

    def ask(self, request: bytes) -> tuple[list[int], list[bytes]]:
        """The statuses that come back for what is sent, and what the services heard of it."""
        for service in self.services:
            service.connections.clear()
        answer = b""
        with self.dial() as client:
            client.sendall(request)
            client.settimeout(QUIET_S)
            with suppress(TimeoutError, ConnectionResetError):
                while part := client.recv(65536):
                    answer += part
        statuses = [int(part[:3]) for part in answer.split(b"HTTP/1.1 ")[1:]]
        return statuses, [one for service in self.services for one in service.connections]


@contextmanager
def guarded(name: str, folder: Path) -> Iterator[Guarded]:
    with ExitStack() as stack:
        services = [stack.enter_context(Heard()) for _ in range(2)]
        for service in services:
            threading.Thread(target=service.serve_forever, args=(0.05,), daemon=True).start()
            stack.callback(service.shutdown)
        ports = [service.server_address[1] for service in services]
        port = stack.enter_context(proxies.proxy(name, folder, ports, tls=False))
        yield Guarded(name, port, services)


@pytest.fixture(
    scope="module",
    params=[
        pytest.param(
            name,
            marks=pytest.mark.skipif(proxies.PROGRAMS[name] is None, reason=f"{name} is not installed"),
        )
        for name in ("nginx", "haproxy")
    ],
)
def here(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Guarded]:
    with guarded(request.param, tmp_path_factory.mktemp(request.param)) as opened:
        yield opened


@pytest.mark.parametrize(
    ("request_", "nginx", "haproxy"),
    [
        pytest.param(b"POST / HTTP/1.1\r\n" + HOST + b"Content-Length: 2\r\n\r\nhi", 405, 405, id="POST"),
        pytest.param(b"OPTIONS / HTTP/1.1\r\n" + HOST + b"\r\n", 405, 405, id="OPTIONS"),
        pytest.param(
            b"GET /" + 20_000 * b"a" + b" HTTP/1.1\r\n" + HOST + b"\r\n", 414, 400, id="a long path"
        ),
        pytest.param(
            b"GET / HTTP/1.1\r\n" + HOST + b"X-Long: " + 20_000 * b"a" + b"\r\n\r\n",
            400,
            400,
            id="a long line",
        ),
        pytest.param(
            b"GET / HTTP/1.1\r\n"
            + HOST
            + b"".join(b"X-%d: %s\r\n" % (i, 4000 * b"a") for i in range(12))
            + b"\r\n",
            400,
            400,
            id="a long header",
        ),
        pytest.param(
            b"GET / HTTP/1.1\r\n" + HOST + b"Content-Length: 2000\r\n\r\n" + 2000 * b"a",
            413,
            413,
            id="a long body",
        ),
        pytest.param(
            b"GET / HTTP/1.1\r\n"
            + HOST
            + b"Content-Length: 4\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
            400,
            413,
            id="two kinds of length",
        ),
        pytest.param(
            b"GET / HTTP/1.1\r\n" + HOST + b"Content-Length: 4\r\nContent-Length: 5\r\n\r\nhello",
            400,
            400,
            id="two lengths",
        ),
    ],
)
def test_what_is_refused_reaches_no_service(here: Guarded, request_: bytes, nginx: int, haproxy: int) -> None:
    assert here.ask(request_) == ([nginx if here.name == "nginx" else haproxy], [])


def test_a_body_is_never_passed_on(here: Guarded) -> None:
    """What a service would read as a second request stays with the proxy."""
    hidden = b"GET /hidden HTTP/1.1\r\nHost: localhost\r\n\r\n"
    chunked = b"%x\r\n%s\r\n0\r\n\r\n" % (len(hidden), hidden)
    for body in (
        b"Content-Length: %d\r\n\r\n%s" % (len(hidden), hidden),
        b"Transfer-Encoding: chunked\r\n\r\n" + chunked,
        b"Transfer-Encoding: \tchunked\r\n\r\n" + chunked,
        b"Transfer-Encoding: xchunked\r\n\r\n" + chunked,
        b"Transfer_Encoding: chunked\r\nContent-Length: %d\r\n\r\n%s" % (len(chunked), chunked),
    ):
        _, heard = here.ask(b"GET / HTTP/1.1\r\n" + HOST + body)
        assert b"hidden" not in b"".join(heard), body


def test_requests_of_one_connection_come_to_a_service_on_connections_of_their_own(here: Guarded) -> None:
    statuses, heard = here.ask(3 * (b"GET / HTTP/1.1\r\n" + HOST + b"\r\n"))
    assert statuses == [200, 200, 200]
    assert [one.count(b"GET / HTTP/1.1") for one in heard] == [1, 1, 1]


def test_only_a_stream_may_become_a_websocket_and_nothing_else(here: Guarded) -> None:
    def upgrade_passed_on(path: bytes, kind: bytes) -> bool:
        _, (heard,) = here.ask(
            b"GET " + path + b" HTTP/1.1\r\n" + HOST + UPGRADE + b"Upgrade: " + kind + b"\r\n\r\n"
        )
        return b"upgrade: " in heard.lower()

    assert upgrade_passed_on(b"/v1/stream?token=a", b"websocket")
    assert upgrade_passed_on(b"/v1/live", b"WebSocket")
    assert not upgrade_passed_on(b"/v1/stream", b"h2c")
    assert not upgrade_passed_on(b"/v1/stream", b"h2c, websocket")
    assert not upgrade_passed_on(b"/v1/samples", b"websocket")
    assert not upgrade_passed_on(b"/v1/stream/more", b"websocket")


def test_what_a_client_says_of_its_address_is_replaced(here: Guarded) -> None:
    said = b"X-Forwarded-For: 10.9.8.7\r\nX-Forwarded-Proto: https\r\nX_Forwarded_For: 10.9.8.7\r\n"
    _, (heard,) = here.ask(b"GET / HTTP/1.1\r\n" + HOST + said + b"\r\n")
    lines = heard.lower().split(b"\r\n")
    assert [line for line in lines if line.startswith(b"x-forwarded")] == [
        b"x-forwarded-for: 127.0.0.1",
        b"x-forwarded-proto: http",
    ]
    assert b"10.9.8.7" not in heard
    assert b"host: lab.example" in lines


def test_a_header_that_never_ends_costs_ten_seconds(here: Guarded) -> None:
    """A letter a second keeps no connection open."""
    began = time.monotonic()
    with here.dial() as client:
        client.sendall(b"GET / HTTP/1.1\r\nHost: ")
        client.settimeout(1.0)
        answer = None
        while answer is None and time.monotonic() - began < PATIENCE_S:
            try:
                client.sendall(b"a")
                answer = client.recv(4096)
            except TimeoutError:
                continue
            except OSError:
                answer = b""
    assert 9.0 < time.monotonic() - began < 20.0


def test_an_address_has_so_many_requests_a_second(here: Guarded) -> None:
    """500 at once behind nginx, 1000 in ten seconds behind HAProxy; 100 more in each second that it takes."""
    began = time.monotonic()
    statuses, _ = here.ask(1500 * (b"GET / HTTP/1.1\r\n" + HOST + b"\r\n"))
    assert 450 < statuses.index(429) < 1100 + 100 * (time.monotonic() - began)
    assert set(statuses) == {200, 429}
