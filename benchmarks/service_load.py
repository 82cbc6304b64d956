"""The load generator, in a process of its own: plain sockets, frames made beforehand, no WebSocket library.

``python -m benchmarks.service_load PLAN``, where PLAN is JSON, prints what it measured as JSON. Without a
``rate`` each client sends its next frame when the last one is answered; with one it keeps to the clock, the
clients evenly staggered, whatever comes back.
"""

from __future__ import annotations

import json
import select
import socket
import sys
import time
from pathlib import Path
from struct import unpack_from

import msgspec
import numpy as np

from benchmarks.service_frames import BINARY, RESET, TEXT, events, hello, split, targets

WARM_S = 0.3
FRAMES = 4000
ASIDE = (b'{"type":"choice"', b'{"type":"targets"')
"""What answers no frame of events."""


class Plan(msgspec.Struct):
    """What to send; ``rate`` in frames a second and client, ``size`` events a frame."""

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


class Client:
    """One connection."""

    def __init__(self, plan: Plan) -> None:
        self.socket = socket.create_connection(("127.0.0.1", plan.port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.sent = 0
        self.answered = 0
        self.rest = b""
        self.given_way = 0
        """How often the server said that predictions gave way to newer ones."""
        self.times: list[float] = []
        self.trips: list[float] = []
        self._greet(plan)

    def _greet(self, plan: Plan) -> None:
        self.socket.sendall(
            f"GET {plan.path} HTTP/1.1\r\nHost: 127.0.0.1:{plan.port}\r\nUpgrade: websocket\r\n"
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
        found, self.rest = split(self.rest + data) if self.rest else split(data)
        now = time.perf_counter()
        answers = [one for one in found if one[0] == BINARY or not one[1].startswith(ASIDE)]
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
            newest = round(t / period(plan)) + (plan.size - 1 if plan.path == "/v1/echo" else 0)
            self.answered = max(self.answered, newest // plan.size + 1)
            self.trips.append(now - self.times[self.answered - 1])
        else:
            self.answered += 1
            self.trips.append(now - self.times[self.answered - 1])


def period(plan: Plan) -> float:
    """Seconds between two events of one client."""
    return 1.0 / ((plan.rate or 1000.0) * plan.size)


def cpu_s(pid: int) -> float:
    """Processor time of all threads of a process so far, in steps of nanoseconds."""
    tasks = Path(f"/proc/{pid}/task").glob("*/schedstat")
    return sum(int(task.read_text().split()[0]) for task in tasks) / 1e9


def closed_loop(plan: Plan, clients: list[Client], frames: list[bytes], until: float) -> None:
    """Every client has one frame under way."""
    waiting = select.epoll()
    by_number = {client.socket.fileno(): client for client in clients}
    for number in by_number:
        waiting.register(number, select.EPOLLIN)
    for client in clients:
        if client.sent == client.answered:
            client.send(frames)
    while time.perf_counter() < until:
        for number, _ in waiting.poll(0.1):
            client = by_number[number]
            if client.read(plan):
                client.send(frames)
    waiting.close()


def open_loop(plan: Plan, clients: list[Client], frames: list[bytes], until: float) -> None:
    """Every client keeps to the clock."""
    gap = 1.0 / (plan.rate or 1.0)
    start = time.perf_counter()
    due = [start + gap * number / len(clients) for number in range(len(clients))]
    by_socket = {client.socket: client for client in clients}
    turn = 0
    while (now := time.perf_counter()) < until:
        while due[turn] <= now:
            clients[turn].send(frames)
            due[turn] += gap
            turn = (turn + 1) % len(clients)
        pause = max(0.0, due[turn] - time.perf_counter())
        for ready in select.select(by_socket, [], [], pause)[0]:
            by_socket[ready].read(plan)


def main() -> None:
    """Carry out a plan."""
    plan = msgspec.json.decode(sys.argv[1], type=Plan)
    count = int((plan.rate or 0) * (plan.seconds + 1.0)) or FRAMES
    frames = events(plan.encoding, count, plan.size, period(plan))
    clients = [Client(plan) for _ in range(plan.clients)]
    go = open_loop if plan.rate else closed_loop
    go(plan, clients, frames, time.perf_counter() + WARM_S)
    before = [(client.sent, len(client.trips)) for client in clients]
    server, own, start = cpu_s(plan.pid), time.process_time(), time.perf_counter()
    go(plan, clients, frames, start + plan.seconds)
    took = time.perf_counter() - start
    server, own = cpu_s(plan.pid) - server, time.process_time() - own
    trips = np.concatenate([c.trips[first:] for c, (_, first) in zip(clients, before, strict=True)])
    answers = len(trips)
    sent = sum(c.sent - first for c, (first, _) in zip(clients, before, strict=True))
    p50, p99 = np.percentile(trips, [50, 99]) * 1e3
    told = {
        "messages_per_s": answers / took,
        "sent_per_s": sent / took,
        "server_us": server / max(answers, 1) * 1e6,
        "server_share": server / took,
        "own_share": own / took,
        "p50_ms": p50,
        "p99_ms": p99,
        "given_way": sum(client.given_way for client in clients),
    }
    print(json.dumps(told))


if __name__ == "__main__":
    main()
