"""One connection of the load generator: a plain socket, no WebSocket library, and what it is to send."""

from __future__ import annotations

import socket
import time
from struct import unpack_from

import msgspec

from benchmarks.service_frames import BINARY, PING, RESET, TEXT, hello, split, targets

ASIDE = (b'{"type":"choice"', b'{"type":"targets"')
"""What answers no frame of events."""


class Plan(msgspec.Struct):
    """What to send; ``rate`` in frames a second and client, ``size`` events a frame.

    ``beside`` is another path, measured in turns with the first.
    """

    port: int
    pid: int
    path: str
    encoding: str
    size: int
    clients: int
    seconds: float
    rate: float | None = None
    predictor: str = "switched"
    targets: int = 0
    beside: str = ""


class Client:
    """One connection."""

    def __init__(self, plan: Plan, path: str) -> None:
        self.path = path
        self.socket = socket.create_connection(("127.0.0.1", plan.port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.sent = 0
        self.answered = 0
        self.rest = b""
        self.given_way = 0
        """How often the server said that predictions gave way to newer ones."""
        self.times: list[float] = []
        self.trips: list[float] = []
        self._greet(plan, path)

    def _greet(self, plan: Plan, path: str) -> None:
        self.socket.sendall(
            f"GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{plan.port}\r\nUpgrade: websocket\r\n"
            "Connection: Upgrade\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
            "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: pointpred.v1\r\n\r\n".encode()
        )
        received = b""
        while b"\r\n\r\n" not in received:
            received += self.socket.recv(4096)
        if not received.startswith(b"HTTP/1.1 101"):
            raise SystemExit(f"no upgrade: {received!r}")
        self.rest = received.partition(b"\r\n\r\n")[2]
        self.socket.sendall(hello(plan.predictor, plan.encoding))
        while not self.rest:
            self.rest += self.socket.recv(4096)
        frames, self.rest = split(self.rest)
        if b'"welcome"' not in frames[0][1]:
            raise SystemExit(f"no welcome: {frames!r}")
        if plan.targets:
            self.socket.sendall(targets(plan.targets))

    def send(self, frames: list[bytes]) -> None:
        """Send the next frame."""
        number = self.sent % len(frames)
        data = frames[number]
        if number == 0 and self.sent:
            data = RESET + data
        self.times.append(time.perf_counter())
        self.sent += 1
        self.socket.sendall(data)

    def read(self, plan: Plan) -> int:
        """Take in what has come; returns how many answers."""
        data = self.socket.recv(1 << 16)
        if not data:
            raise SystemExit("the server closed the connection")
        frames, self.rest = split(self.rest + data) if self.rest else split(data)
        now = time.perf_counter()
        messages = [one for one in frames if one[0] != PING]  # unanswered: a round ends before the timeout
        answers = [one for one in messages if one[0] == BINARY or not one[1].startswith(ASIDE)]
        for opcode, payload in answers:
            self._take(plan, opcode, payload, now)
        return len(answers)

    def _take(self, plan: Plan, opcode: int, payload: bytes, now: float) -> None:
        if opcode == TEXT and b'"slow"' in payload[:40]:
            self.given_way += 1
            return
        if opcode != (BINARY if plan.encoding == "binary" else TEXT) or b'"error"' in payload[:20]:
            raise SystemExit(f"expected an answer, received {payload[:200]!r}")
        if plan.rate and plan.encoding == "binary":  # answers may have given way to newer ones: go by t
            (t,) = unpack_from("<d", payload, 0)
            newest = round(t / period(plan)) + (plan.size - 1 if self.path == "/v1/echo" else 0)
            self.answered = max(self.answered, newest // plan.size + 1)
            self.trips.append(now - self.times[self.answered - 1])
        else:
            self.answered += 1
            self.trips.append(now - self.times[self.answered - 1])


def period(plan: Plan) -> float:
    """Seconds between two events of one client."""
    return 1.0 / ((plan.rate or 1000.0) * plan.size)
