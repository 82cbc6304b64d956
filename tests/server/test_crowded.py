"""More connections than the process has descriptors: sessions go on, and others are answered again later."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import pytest
from httpx2 import HTTPError, get
from websockets.sync.client import connect

from tests.server.listener import soon
from tests.server.process import Served, served
from tests.server.running import HELLO, PATIENCE_S

FILES = 96
CROWD = 300
SILENT = b""
HALF_AN_UPGRADE = (
    b"GET /v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
)
NO_HELLO = HALF_AN_UPGRADE + b"\r\n"
UNREAD = b"GET /v1/predictors HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n" * 16


@contextmanager
def crowd(port: int, words: bytes) -> Iterator[None]:
    """Many connections that begin and do not go on."""
    with ExitStack() as opened:
        for _ in range(CROWD):
            one = opened.enter_context(socket.create_connection(("127.0.0.1", port), PATIENCE_S))
            one.sendall(words)
        yield


def descriptors(here: Served) -> int:
    return len(list(Path(f"/proc/{here.process.pid}/fd").iterdir()))


def answers(here: Served) -> bool:
    try:
        return get(f"{here.url}/healthz", timeout=2).status_code == 200
    except HTTPError:
        return False


@pytest.fixture(scope="module")
def here() -> Iterator[Served]:
    with served(files=FILES) as running:
        yield running


@pytest.mark.skipif(
    not Path("/proc/self/fd").exists(), reason="descriptors are counted in /proc, as on Linux"
)
@pytest.mark.parametrize(
    "words",
    [SILENT, HALF_AN_UPGRADE, NO_HELLO, UNREAD],
    ids=["silent", "half an upgrade", "no hello", "no response is read"],
)
def test_a_session_goes_on_while_no_descriptor_is_left(here: Served, words: bytes) -> None:
    soon(lambda: answers(here), "the service answers")
    before, logged = descriptors(here), len(here.log)
    with connect(
        f"ws://127.0.0.1:{here.port}/v1/stream", compression=None, open_timeout=PATIENCE_S
    ) as innocent:
        innocent.send(HELLO)
        assert "welcome" in str(innocent.recv(PATIENCE_S))
        with crowd(here.port, words):
            soon(lambda: descriptors(here) == FILES, "no descriptor is left")
            for t in range(20):
                innocent.send(f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}')
                assert f'"t":{t}.0' in str(innocent.recv(PATIENCE_S))
        soon(lambda: answers(here), "others are answered again")
    soon(
        lambda: descriptors(here) <= before + 1, "no connection is left over"
    )  # one in the pool of the client
    assert len(here.log) - logged < 3 * CROWD, "the log is not flooded"
    errors = [line for line in here.log if '"level": "error"' in line]
    assert not errors
