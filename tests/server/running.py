"""A real service for tests: uvicorn in a thread, on a free port of loopback."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Subprotocol

from pointpred.protocol.client_messages import SUBPROTOCOL
from pointpred_server.listening import listen, make_server
from pointpred_server.service import Service
from pointpred_server.settings import Settings

HELLO = '{"type":"hello","version":1,"predictor":"switched"}'
PATIENCE_S = 120.0
"""For what is bound to come, however busy the machine is."""


def event(t: float) -> str:
    """A message of one event."""
    return f'{{"type":"events","events":[[{t},5,6,null,null,0]]}}'


def told(socket: ClientConnection) -> dict[str, Any]:
    """The next message of a service."""
    answer: dict[str, Any] = json.loads(socket.recv(PATIENCE_S))
    return answer


def ends(socket: ClientConnection, code: str, close: int) -> None:
    """An error that ends the session comes next, then the close with its reason."""
    answer = told(socket)
    assert (answer["type"], answer["code"], answer["recoverable"]) == ("error", code, False)
    with pytest.raises(ConnectionClosed) as closed:
        socket.recv(PATIENCE_S)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == close
    assert closed.value.rcvd.reason


@dataclass
class Running:
    """Where a service answers."""

    service: Service
    port: int
    server: Any

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"

    def connect(self, query: str = "", **options: Any) -> ClientConnection:
        """A WebSocket to the stream."""
        url = f"ws://127.0.0.1:{self.port}/v1/stream{query}"
        settings = {"open_timeout": PATIENCE_S, "ping_interval": None, "compression": None, **options}
        return connect(url, subprotocols=[Subprotocol(SUBPROTOCOL)], **settings)

    @contextmanager
    def greeted(self, hello: str = HELLO, **options: Any) -> Iterator[ClientConnection]:
        """A WebSocket whose hello was answered."""
        with self.connect(**options) as socket:
            socket.send(hello)
            assert '"type":"welcome"' in socket.recv(PATIENCE_S)
            yield socket


@contextmanager
def running(
    prepare: Callable[[Service], None] = lambda service: None, *, host: str = "127.0.0.1", **settings: Any
) -> Iterator[Running]:
    """Serve until the block ends; ``settings`` as for ``pointpred serve``, ``prepare`` before it begins."""
    service = Service(Settings(host=host, **settings))
    prepare(service)
    opened = listen(host, 0)
    up = threading.Event()
    server = make_server(service, up.set)
    thread = threading.Thread(target=server.run, args=([opened],))
    thread.start()
    try:
        assert up.wait(PATIENCE_S)
        yield Running(service, opened.getsockname()[1], server)
    finally:
        server.should_exit = True
        thread.join(PATIENCE_S)
        opened.close()
        assert not thread.is_alive()
