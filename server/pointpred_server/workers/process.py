"""A worker process, as the supervisor sees it."""

from __future__ import annotations

import asyncio
import socket
import subprocess
import time
from collections.abc import Callable, Coroutine
from typing import Any

import msgspec

from pointpred_server.child_processes import command, environment
from pointpred_server.workers.counts import CONNECTIONS, TAKEN, WorkerCounts
from pointpred_server.workers.messages import (
    LINE_BYTES,
    Begin,
    Collect,
    Collected,
    FromWorker,
    Started,
    ToWorker,
    from_worker,
    send,
)

Observe = Callable[["WorkerProcess", FromWorker], None]


class WorkerProcess:
    """One process: started, handed connections, asked, ended. Made by ``start``."""

    def __init__(self, number: int, counts: WorkerCounts, observe: Observe) -> None:
        self.number = number
        self.started = False
        """Whether it answers requests."""
        self.answered_at = self.begun_at = time.monotonic()
        self._counts = counts
        self._observe = observe
        self._handed = 0
        self._collected: asyncio.Future[None] | None = None

    async def start(self, settings: dict[str, Any], workers: int) -> Coroutine[Any, Any, int]:
        """Start it; the coroutine returned reads what it sends until it has ended, and returns its exit code.

        Raises OSError.
        """
        control, far_control = socket.socketpair()
        self._connections, far_connections = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
        self._connections.setblocking(False)
        passed = (far_control.fileno(), far_connections.fileno(), self._counts.descriptor)
        with far_control, far_connections:
            try:
                process = await asyncio.create_subprocess_exec(
                    *command("pointpred_server.workers.worker", *map(str, passed)),
                    stdin=subprocess.DEVNULL,
                    pass_fds=passed,
                    env=environment(),
                )
            except BaseException:
                control.close()
                self._connections.close()
                raise
        self._process = process
        reader, self._writer = await asyncio.open_connection(sock=control, limit=LINE_BYTES)
        self.send(Begin(self.number, workers, settings))
        return self._run(reader)

    @property
    def pid(self) -> int:
        """Its process number."""
        return self._process.pid

    @property
    def load(self) -> int:
        """Its connections, those on their way to it included."""
        row = self._counts.rows[self.number]
        return int(row[CONNECTIONS]) + self._handed - int(row[TAKEN])

    @property
    def silent_s(self) -> float:
        """How long it has not answered."""
        return time.monotonic() - self.answered_at

    def excuse(self, seconds: float) -> None:
        """For so long nobody could hear it."""
        self.answered_at += seconds

    def hand(self, connection: socket.socket) -> bool:
        """Give it a connection; False where it takes none now."""
        try:
            socket.send_fds(self._connections, [b"c"], [connection.fileno()])
        except OSError:  # it is held up and its queue is full, or it has ended
            return False
        self._handed += 1
        return True

    def send(self, message: ToWorker) -> None:
        """Write a message; nothing where it has ended."""
        send(self._writer, message)

    async def collect(self, timeout_s: float) -> None:
        """Ask for its metrics, and wait until they have come or the time is over."""
        if self._collected is None:
            self._collected = asyncio.get_running_loop().create_future()
            self.send(Collect())
        await asyncio.wait([self._collected], timeout=timeout_s)

    def kill(self) -> None:
        """End it at once."""
        if self._process.returncode is None:
            self._process.kill()

    async def _run(self, reader: asyncio.StreamReader) -> int:
        try:
            while line := await reader.readline():
                self._receive(from_worker.decode(line))
        except OSError:
            pass  # it ended before it had read everything; a signal now would take its exit code from asyncio
        except (ValueError, msgspec.DecodeError):
            self.kill()  # it is not what was started
        finally:
            code = await self._process.wait()
            self._writer.close()
            self._connections.close()
            if self._collected is not None and not self._collected.done():
                self._collected.set_result(None)
        return code

    def _receive(self, message: FromWorker) -> None:
        self.answered_at = time.monotonic()
        if isinstance(message, Started):
            self.started = True
        self._observe(self, message)
        if isinstance(message, Collected) and self._collected is not None:
            self._collected.set_result(None)
            self._collected = None
