"""A client whose answer to a ping is late goes on while it sends; one that sends nothing is gone."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Iterator

import pytest

from evidence.costs.soak.sessions import CLOSE, PING, TEXT, frame, split, upgrade
from pointpred_server.websocket_protocol import BoundedWebSocketProtocol
from tests.server.running import HELLO, PATIENCE_S, Running, running

EVENT = b'{"type":"events","events":[[%d.0,1.0,2.0,null,null,0]]}'


class Quiet:
    """A client that answers no ping."""

    def __init__(self, port: int) -> None:
        self.socket = socket.create_connection(("127.0.0.1", port), PATIENCE_S)
        self.socket.sendall(upgrade(port))
        assert self.socket.recv(1 << 16).endswith(b"\r\n\r\n")
        self._rest = b""
        self._frames: list[tuple[int, bytes]] = []
        self.send(HELLO.encode())
        assert b"welcome" in self.next()[1]

    def send(self, message: bytes) -> None:
        self.socket.sendall(frame(TEXT, message))

    def next(self) -> tuple[int, bytes]:
        """The next frame that is no ping."""
        while True:
            while not self._frames:
                frames, self._rest = split(self._rest + self.socket.recv(1 << 16))
                self._frames += [one for one in frames if one[0] != PING]
            return self._frames.pop(0)


@pytest.fixture
def service() -> Iterator[Running]:
    with running() as one:
        yield one


def on_loop(protocol: BoundedWebSocketProtocol, *calls: Callable[[], None]) -> None:
    """Call methods of a connection where its event loop runs, one after another."""
    done = threading.Event()
    for call in calls:
        protocol.loop.call_soon_threadsafe(call)
    protocol.loop.call_soon_threadsafe(done.set)
    assert done.wait(PATIENCE_S)


def test_only_a_client_that_sends_nothing_is_gone(service: Running) -> None:
    client = Quiet(service.port)
    (protocol,) = service.server.server_state.connections
    assert isinstance(protocol, BoundedWebSocketProtocol)
    on_loop(protocol, protocol.send_keepalive_ping)
    client.send(EVENT % 1)
    assert b"prediction" in client.next()[1]
    on_loop(protocol, protocol.keepalive_timeout)
    client.send(EVENT % 2)
    assert b"prediction" in client.next()[1]
    on_loop(protocol, protocol.send_keepalive_ping, protocol.keepalive_timeout)
    opcode, payload = client.next()
    assert opcode == CLOSE
    assert int.from_bytes(payload[:2], "big") == 1011
    client.socket.close()
