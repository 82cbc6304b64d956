"""What a session notices while the service is attacked: ``python -m benchmarks.attacked``.

A client sends an event each 10 ms and takes the time from when it was due to its prediction. Meanwhile
another process does one of ``ATTACKS``. The table has the delay before, during and after it, the share of a
processor that the service takes, and its memory. Writes ``pages/attacks/attacked.json``. Linux only.
"""

from __future__ import annotations

import gzip
import json
import multiprocessing
import os
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
from urllib.request import urlopen

import numpy as np
from websockets.frames import Frame, Opcode
from websockets.sync.client import ClientConnection, connect

from benchmarks.machine import machine
from pages.arguments import parse
from pages.data import Table, keep

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
COLUMNS = ("attack", "p50 before, ms", "p50", "p99", "p50 after", "share of a processor", "memory, MB")


def dial(port: int) -> socket.socket:
    return socket.create_connection(("127.0.0.1", port), 10)


def silent(port: int, until: float) -> None:
    """More connections than descriptors, which say nothing."""
    opened = []
    with suppress(OSError):
        opened = [dial(port) for _ in range(MANY)]
    time.sleep(max(0.0, until - time.monotonic()))
    for one in opened:
        one.close()


def slow_headers(port: int, until: float) -> None:
    """Five hundred requests that go on by one byte each half second."""
    opened = [dial(port) for _ in range(500)]
    while time.monotonic() < until:
        for one in opened:
            with suppress(OSError):
                one.send(b"X")
        time.sleep(0.5)


def unread(port: int, until: float) -> None:
    """Five hundred connections that ask for the largest file sixteen times and read nothing."""
    opened = [dial(port) for _ in range(500)]
    for one in opened:
        one.sendall(LARGEST_FILE * 16)
    time.sleep(max(0.0, until - time.monotonic()))
    for one in opened:
        one.close()


def long_queries(port: int, until: float) -> None:
    """Requests with 30,000 empty parameters."""
    while time.monotonic() < until:
        with suppress(OSError), dial(port) as one:
            one.sendall(b"GET /metrics?" + b"&" * 30_000 + b" HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
            one.recv(4096)


def handshakes(port: int, until: float) -> None:
    """One upgrade after another, each left at once."""
    while time.monotonic() < until:
        with suppress(OSError), dial(port) as one:
            one.sendall(UPGRADE)
            one.recv(4096)


def requests(port: int, until: float) -> None:
    """The largest file, asked for again and again on connections of their own."""
    while time.monotonic() < until:
        with suppress(OSError), dial(port) as one:
            one.sendall(LARGEST_FILE.replace(b"\r\n\r\n", b"\r\nConnection: close\r\n\r\n"))
            while one.recv(65536):
                pass


def flood(port: int, until: float, frames: bytes, hello: bool = True) -> None:
    """Frames as fast as they are taken, and a new connection where it is ended."""
    greeting = Frame(Opcode.TEXT, HELLO.encode()).serialize(mask=True) if hello else b""
    while time.monotonic() < until:
        with suppress(OSError), dial(port) as one:
            one.settimeout(1)
            one.sendall(UPGRADE + greeting)
            while time.monotonic() < until:
                one.sendall(frames)
                if not one.recv(65536):
                    break


def text(words: bytes) -> bytes:
    return Frame(Opcode.TEXT, words).serialize(mask=True)


def pings(port: int, until: float) -> None:
    """Pings of the most bytes."""
    flood(port, until, Frame(Opcode.PING, b"x" * 125).serialize(mask=True) * 200)


def bad_text(port: int, until: float) -> None:
    """Text that is no UTF-8."""
    flood(port, until, text(b"\xed\xa0\x80"))


def nested(port: int, until: float) -> None:
    """JSON of the most bytes, as deep as it is long."""
    flood(port, until, text(b"[" * 65_000))


def unknown(port: int, until: float) -> None:
    """Messages of the most bytes with thousands of unknown parameters."""
    names = b",".join(b'"p%d":1' % number for number in range(5000))
    flood(port, until, text(b'{"type":"configure","parameters":{' + names + b"}}"))


def bombs(port: int, until: float) -> None:
    """Uploads that unpack to 2 GB."""
    packed = b"".join(gzip.compress(bytes(2**20), 9) for _ in range(2000))
    head = (
        b"POST /v1/score HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\nContent-Length: %d\r\n\r\n"
        % len(packed)
    )
    while time.monotonic() < until:
        with suppress(OSError), dial(port) as one:
            one.sendall(head + packed)
            while one.recv(65536):
                pass


ATTACKS: tuple[Callable[[int, float], None], ...] = (
    *(
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
        bombs,
    ),
)


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


def processor_s(pid: int) -> float:
    """Processor time of the service so far."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def memory_mb(pid: int) -> float:
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    found = re.search(r"VmRSS:\s+(\d+)", status)
    return int(found[1]) / 1024 if found else 0.0


def attacked(attack: Callable[[int, float], None], port: int, pid: int) -> tuple[str, ...]:
    """One line of the table."""
    context = multiprocessing.get_context("spawn")
    with connect(
        f"ws://127.0.0.1:{port}/v1/stream", compression=None, proxy=None, open_timeout=600
    ) as session:
        session.send(HELLO)
        session.recv(600)
        before = np.median(delays(session, 0, 2.0))
        child = context.Process(target=attack, args=(port, time.monotonic() + SECONDS + 3.0))
        child.start()
        time.sleep(2.0)
        used, began = processor_s(pid), time.monotonic()
        during = delays(session, 1000, SECONDS)
        share = (processor_s(pid) - used) / (time.monotonic() - began)
        child.join(60)
        child.kill()
        after = np.median(delays(session, 5000, 2.0))
    numbers = (before, np.median(during), np.quantile(during, 0.99), after)
    about = " ".join((attack.__doc__ or "").split()).rstrip(".")
    return about, *(f"{number:.1f}" for number in numbers), f"{share:.2f}", f"{memory_mb(pid):.0f}"


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
        while not compiled(port):
            time.sleep(1.0)
        try:
            rows = []
            for attack in ATTACKS:
                rows.append(attacked(attack, port, service.pid))
                print(*rows[-1], sep=", ", flush=True)
        finally:
            service.terminate()
    about = {"seconds": SECONDS, "files": FILES}
    keep("attacks", {"attacked": Table.of(COLUMNS, rows)}, part="attacked", machine=where, numbers=about)


def compiled(port: int) -> bool:
    """Whether the service has nothing left to compile."""
    with urlopen(f"http://127.0.0.1:{port}/v1/compiling", timeout=60) as answer:
        progress = json.load(answer)
    return bool(progress["done"] == progress["of"])


if __name__ == "__main__":
    parse(__doc__)
    main()
