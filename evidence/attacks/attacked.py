"""What a session notices while the service is attacked: ``python -m evidence attacks attacked``.

A client sends an event each 10 ms and takes the time from when it was due to its prediction. Meanwhile
another process does one of ``ATTACKS``. The table has how often it did that (connections, or blocks of
frames), the delay before, during and after it, the share of a processor that the service takes, and its
memory. It ends where an attack fails or does nothing. Linux only.
"""

from __future__ import annotations

import multiprocessing
import re
import resource
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from websockets.frames import Frame, Opcode
from websockets.sync.client import ClientConnection, connect

from evidence.arguments import parse
from evidence.costs.load.servers import wait_until_ready
from evidence.data import Table, keep
from evidence.machine import machine, processor_s

SECONDS, EVERY_S = 8.0, 0.01
FILES = 1024
"""Descriptors of the service; more connections than that are tried."""
MANY = 1200
HELLO = '{"type":"hello","version":1,"predictor":"kinematic-adaptive"}'
GET = b"GET /v1/stream HTTP/1.1\r\nHost: 127.0.0.1\r\n"
UPGRADE = GET + (
    b"Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    b"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
)
LARGEST_FILE = b"GET /web/vendor/uPlot.esm.js HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"
COLUMNS = (
    "attack",
    "times",
    "p50 before, ms",
    "p50",
    "p99",
    "p50 after",
    "share of a processor",
    "memory, MB",
)


def dial(port: int) -> socket.socket:
    return socket.create_connection(("127.0.0.1", port), 10)


def opened(port: int, most: int) -> list[socket.socket]:
    """So many connections, or as many as the service and this process can have."""
    connections: list[socket.socket] = []
    with suppress(OSError):
        while len(connections) < most:
            connections.append(dial(port))
    return connections


def keep_open(connections: list[socket.socket], until: float) -> int:
    """Do nothing with connections, then close them; how many they were."""
    time.sleep(max(0.0, until - time.monotonic()))
    for one in connections:
        one.close()
    return len(connections)


def again(port: int, until: float, attack: Callable[[socket.socket], object]) -> int:
    """Do something on one new connection after another; how often that was begun."""
    count = 0
    while time.monotonic() < until:
        with suppress(OSError), dial(port) as one:
            count += 1
            attack(one)
    return count


def silent(port: int, until: float) -> int:
    """More connections than descriptors, which say nothing."""
    return keep_open(opened(port, MANY), until)


def slow_headers(port: int, until: float) -> int:
    """Five hundred requests that go on by one byte each half second."""
    connections = opened(port, 500)
    while time.monotonic() < until:
        for one in connections:
            with suppress(OSError):
                one.send(b"X")
        time.sleep(0.5)
    return len(connections)


def unread(port: int, until: float) -> int:
    """Five hundred connections that ask for the largest file sixteen times and read nothing."""
    connections = opened(port, 500)
    for one in connections:
        with suppress(OSError):
            one.sendall(LARGEST_FILE * 16)
    return keep_open(connections, until)


def long_queries(port: int, until: float) -> int:
    """Requests with 30,000 empty parameters."""

    def ask(one: socket.socket) -> None:
        one.sendall(b"GET /v1/samples?" + b"&" * 30_000 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        one.recv(4096)

    return again(port, until, ask)


def handshakes(port: int, until: float) -> int:
    """One upgrade after another, each left at once."""

    def upgrade(one: socket.socket) -> None:
        one.sendall(UPGRADE)
        one.recv(4096)

    return again(port, until, upgrade)


def requests(port: int, until: float) -> int:
    """The largest file, asked for again and again on connections of their own."""

    def ask(one: socket.socket) -> None:
        one.sendall(LARGEST_FILE.replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n"))
        while one.recv(65536):
            pass

    return again(port, until, ask)


def flood(port: int, until: float, frames: bytes, hello: bool = True) -> int:
    """Frames as fast as they are taken, and a new connection where it is ended; how often they were sent."""
    greeting = Frame(Opcode.TEXT, HELLO.encode()).serialize(mask=True) if hello else b""
    count = 0

    def send(one: socket.socket) -> None:
        nonlocal count
        one.settimeout(1)
        one.sendall(UPGRADE + greeting)
        while time.monotonic() < until:
            one.sendall(frames)
            count += 1
            if not one.recv(65536):
                break

    again(port, until, send)
    return count


def text(words: bytes) -> bytes:
    return Frame(Opcode.TEXT, words).serialize(mask=True)


def pings(port: int, until: float) -> int:
    """Pings of the most bytes."""
    return flood(port, until, Frame(Opcode.PING, b"x" * 125).serialize(mask=True) * 200)


def bad_text(port: int, until: float) -> int:
    """Text that is no UTF-8."""
    return flood(port, until, text(b"\xed\xa0\x80"))


def nested(port: int, until: float) -> int:
    """JSON of the most bytes, as deep as it is long."""
    return flood(port, until, text(b"[" * 65_000))


def unknown(port: int, until: float) -> int:
    """Messages of the most bytes with thousands of unknown parameters."""
    names = b",".join(b'"p%d":1' % number for number in range(5000))
    return flood(port, until, text(b'{"type":"configure","parameters":{' + names + b"}}"))


def fragments(port: int, until: float) -> int:
    """Messages in 64 fragments."""
    middle = [Frame(Opcode.CONT, b"", fin=False)] * 62
    frames = [Frame(Opcode.TEXT, b"{", fin=False), *middle, Frame(Opcode.CONT, b"")]
    return flood(port, until, b"".join(one.serialize(mask=True) for one in frames) * 4)


def refused_targets(port: int, until: float) -> int:
    """More targets than a session may have."""
    one = b'{"id":"%d","x":0,"y":0,"width":1,"height":1}'
    many = b",".join(one % number for number in range(1300))
    return flood(port, until, text(b'{"type":"targets","targets":[' + many + b"]}"))


Attack = Callable[[int, float], int]
ATTACKS: tuple[Attack, ...] = (
    silent,
    slow_headers,
    unread,
    long_queries,
    handshakes,
    requests,
    pings,
    bad_text,
    nested,
    unknown,
    fragments,
    refused_targets,
)


def carry_out(attack: Attack, port: int, until: float, count: Any) -> None:
    """In a process of its own, with as many descriptors as it may have."""
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    count.value = attack(port, until)


class Attacker:
    """A process that attacks a service for some seconds."""

    def __init__(self, attack: Attack, port: int, seconds: float) -> None:
        context = multiprocessing.get_context("spawn")
        self._attack, self._count = attack, context.Value("q", 0)
        until = time.monotonic() + seconds
        self._process = context.Process(target=carry_out, args=(attack, port, until, self._count))
        self._process.start()

    def finish(self) -> int:
        """How often it was done; raises SystemExit where the attack failed, did not end or did nothing."""
        self._process.join(60)
        self._process.kill()
        self._process.join()
        if self._process.exitcode != 0 or self._count.value == 0:
            name, code = self._attack.__name__, self._process.exitcode
            raise SystemExit(
                f"the attack '{name}' did nothing: exit code {code}, done {self._count.value} times"
            )
        return int(self._count.value)


def delays(session: ClientConnection, first: int, seconds: float) -> np.ndarray:
    """Milliseconds from when each event was due to its prediction; ``first``: the number of the first."""
    result = []
    begin = time.monotonic()
    for number in range(int(seconds / EVERY_S)):
        due = begin + number * EVERY_S
        time.sleep(max(0.0, due - time.monotonic()))
        t = (first + number) * EVERY_S
        session.send(f'{{"type":"events","events":[[{t},{number % 500},6,null,null,0]]}}')
        while '"prediction"' not in str(session.recv(60)):
            pass
        result.append(1e3 * (time.monotonic() - due))
    return np.array(result)


def memory_mb(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    found = re.search(r"VmRSS:\s+(\d+)", status)
    return int(found[1]) / 1024 if found else 0.0


def attacked(attack: Attack, port: int, pid: int) -> tuple[str, ...]:
    """One line of the table."""
    with connect(
        f"ws://127.0.0.1:{port}/v1/stream", compression=None, proxy=None, open_timeout=600
    ) as session:
        session.send(HELLO)
        session.recv(600)
        before = np.median(delays(session, 0, 2.0))
        attacker = Attacker(attack, port, SECONDS + 3.0)
        time.sleep(2.0)
        used, began = processor_s(pid), time.monotonic()
        during = delays(session, 1000, SECONDS)
        share = (processor_s(pid) - used) / (time.monotonic() - began)
        times = attacker.finish()
        after = np.median(delays(session, 5000, 2.0))
    numbers = (before, np.median(during), np.quantile(during, 0.99), after)
    about = " ".join((attack.__doc__ or "").split()).rstrip(".")
    shown = (f"{number:.1f}" for number in numbers)
    return about, str(times), *shown, f"{share:.2f}", f"{memory_mb(pid):.0f}"


def main() -> None:
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", "--log-format", "json"]
    limit = partial(resource.setrlimit, resource.RLIMIT_NOFILE, (FILES, FILES))
    where = machine(load=True)
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=limit
    ) as service:
        assert service.stdout is not None
        found = re.search(r":(\d+)/", service.stdout.readline())
        assert found is not None
        port = int(found[1])
        wait_until_ready(f"http://127.0.0.1:{port}/")
        try:
            rows = []
            for attack in ATTACKS:
                rows.append(attacked(attack, port, service.pid))
                print(*rows[-1], sep=", ", flush=True)
        finally:
            service.terminate()
    about = {"seconds": SECONDS, "files": FILES}
    keep("attacks", {"attacked": Table.of(COLUMNS, rows)}, part="attacked", machine=where, numbers=about)


if __name__ == "__main__":
    parse(__doc__)
    main()
