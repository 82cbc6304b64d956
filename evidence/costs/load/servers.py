"""The servers under load, in processes of their own on cores of their own; and two yardsticks beside them.

``python -m evidence.costs.load.servers asgi|raw`` prints its port and sends everything back. ``asgi`` is an
ASGI application of six lines on the uvicorn that the service runs on, with uvicorn's own WebSocket protocol;
``raw`` has no WebSocket at all, only uvloop.
"""

from __future__ import annotations

import asyncio
import io
import os
import socket
import subprocess
import sys
import tarfile
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import urlopen

import msgspec
import uvicorn
import uvloop

from evidence import ROOT
from evidence.arguments import parse
from evidence.machine import FIRST, family, on_cores, processor_s

PATIENCE_S = 600.0
IDLE_S = 0.5
"""A server that uses under a fiftieth of this time in so long is idle."""
RAISED = {"POINTPRED_MAX_SESSIONS": "1000", "POINTPRED_MAX_EVENTS_PER_S": "100000000"}
"""Limits for clients that send as fast as they are answered; at 8 kHz they stay within the usual ones."""


class Server(msgspec.Struct, frozen=True):
    """Where a server listens, and its processes."""

    port: int
    pids: tuple[int, ...]


def checkout(commit: str) -> Path:
    """The files of a commit of this repository, in the build folder."""
    folder = ROOT / "build" / "load" / commit
    command = ["git", "archive", commit]
    archive = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        files.extractall(folder, filter="tar")
    return folder


@contextmanager
def service(*, cores: set[int] = FIRST, root: Path = ROOT, raised: bool = False) -> Iterator[Server]:
    """``pointpred serve`` of the source tree in ``root``, once it is ready."""
    words = ["-m", "pointpred", "serve", "--port", "0"]
    limits = RAISED if raised else {"POINTPRED_MAX_SESSIONS": "1000"}
    path = os.pathsep.join((str(root), str(root / "server")))
    with _process(words, cores, root, {**limits, "PYTHONPATH": path}) as (process, lines):
        address = next(line.strip() for line in lines if line.startswith("http"))
        wait_until_ready(address)
        _wait_until_idle(process.pid)
        yield Server(int(address.rstrip("/").rpartition(":")[2]), family(process.pid))


@contextmanager
def echo(kind: str, *, cores: set[int] = FIRST) -> Iterator[Server]:
    """``asgi`` or ``raw``: a server that sends everything back, from ``evidence.costs.load.servers``."""
    words = ["-m", "evidence.costs.load.servers", kind]
    with _process(words, cores, ROOT, {"PYTHONPATH": str(ROOT)}) as (process, lines):
        yield Server(int(next(lines)), (process.pid,))


@contextmanager
def _process(
    words: Sequence[str], cores: set[int], root: Path, environment: dict[str, str]
) -> Iterator[tuple[subprocess.Popen[str], Iterator[str]]]:
    with tempfile.TemporaryFile("w+", encoding="utf-8") as log:
        with on_cores(cores):
            process = subprocess.Popen(
                [sys.executable, *words],
                stdout=subprocess.PIPE,
                stderr=log,
                text=True,
                cwd=root,
                env={**os.environ, **environment},
            )
        with process:
            assert process.stdout is not None
            try:
                yield process, iter(process.stdout)
            except StopIteration:
                log.seek(0)
                end = log.read()[-2000:]
                raise SystemExit(f"{' '.join(words)} ended before it listened:\n{end}") from None
            finally:
                process.terminate()


def wait_until_ready(address: str) -> None:
    """Until a service says that it is ready; raises SystemExit where that takes too long."""
    until = time.monotonic() + PATIENCE_S
    while time.monotonic() < until:
        try:
            with urlopen(f"{address}readyz"):
                return
        except (HTTPError, ConnectionError):
            pass
        time.sleep(0.05)
    raise SystemExit(f"the service was not ready after {PATIENCE_S:g} s")


def _wait_until_idle(pid: int) -> None:
    """Until the start is over; a build of before compiles then."""
    used_s = 0.0
    while abs((now_s := sum(map(processor_s, family(pid)))) - used_s) > IDLE_S / 50:
        used_s = now_s
        time.sleep(IDLE_S)


async def application(scope: Any, receive: Any, send: Any) -> None:
    """Accept a WebSocket and send back what comes."""
    await receive()
    await send({"type": "websocket.accept"})
    while (message := await receive())["type"] == "websocket.receive":
        await send({**message, "type": "websocket.send"})


class Echo(asyncio.Protocol):
    """Send back what comes."""

    def connection_made(self, transport: Any) -> None:
        """Keep the connection."""
        self.transport = transport

    def data_received(self, data: bytes) -> None:
        """Send it back."""
        self.transport.write(data)


async def serve_raw(opened: socket.socket) -> None:
    """Serve until killed."""
    server = await asyncio.get_running_loop().create_server(Echo, sock=opened)
    await server.serve_forever()


def main(kind: str) -> None:
    """Listen on a free port of loopback and serve until killed."""
    opened = socket.create_server(("127.0.0.1", 0))
    print(opened.getsockname()[1], flush=True)
    if kind == "raw":
        uvloop.run(serve_raw(opened))
    else:
        config = uvicorn.Config(
            application,
            ws="websockets-sansio",
            lifespan="off",
            log_level="warning",
            ws_per_message_deflate=False,
        )
        uvicorn.Server(config).run([opened])


if __name__ == "__main__":
    main(*parse(__doc__, metavar="kind", choices=("asgi", "raw"), most=1))
