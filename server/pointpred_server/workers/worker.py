"""A worker: ``python -m pointpred_server.workers.worker CONTROL CONNECTIONS COUNTS``, three descriptors.

The supervisor starts it, and sends the settings first and accepted connections later. It ends when the
supervisor asks it to or has ended itself.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import signal
import socket
import sys
from collections.abc import Coroutine, Iterator
from typing import Any, cast

import msgspec

from pointpred.garbage import tune_collector
from pointpred_server.access import HostRule
from pointpred_server.allocator import bound_free_memory
from pointpred_server.http_protocol import BoundedHttpProtocol
from pointpred_server.listening import PointpredServer, web_config
from pointpred_server.logs import set_up
from pointpred_server.network_counts import NetworkCounts
from pointpred_server.service import Service
from pointpred_server.settings import Settings
from pointpred_server.workers.counts import CONNECTIONS, SESSIONS, TAKEN, WorkerCounts
from pointpred_server.workers.dispatcher import NO_FILES_S
from pointpred_server.workers.families import families_of
from pointpred_server.workers.messages import (
    LINE_BYTES,
    AskText,
    Begin,
    Collect,
    Collected,
    FromWorker,
    ServiceReady,
    Started,
    Text,
    send,
    to_worker,
)

METRICS_S = 5.0
"""Seconds that the supervisor may take to send the metrics of all workers."""
AT_ONCE = 16
"""Connections taken before other work has its turn."""

log = logging.getLogger("pointpred.service")


class OtherWorkers:
    """What a service of several workers knows of all of them: ``Peers`` of its ``Service``."""

    def __init__(self, number: int, counts: WorkerCounts) -> None:
        self.ready = False
        """Whether every worker has started."""
        self.ask: asyncio.StreamWriter | None = None
        self._row = counts.rows[number]
        self._counts = counts
        self._texts: list[asyncio.Future[str]] = []

    @property
    def sessions(self) -> int:
        """Sessions of all workers."""
        return self._counts.sessions

    def count_sessions(self, own: int) -> None:
        """How many sessions this worker has."""
        self._row[SESSIONS] = own

    def count_connections(self, own: int, taken: int = 0) -> None:
        """How many connections this worker has, and how many it was handed since the last call."""
        self._row[CONNECTIONS] = own
        self._row[TAKEN] += taken

    async def metrics(self) -> bytes:
        """The metrics of all workers, in the exposition format; raises TimeoutError."""
        assert self.ask is not None
        text: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        self._texts.append(text)
        send(self.ask, AskText())
        async with asyncio.timeout(METRICS_S):
            return (await text).encode()

    def take_text(self, text: str) -> None:
        """The supervisor's answer to the earliest request."""
        if not (waiting := self._texts.pop(0)).done():
            waiting.set_result(text)


class WorkerServer(PointpredServer):
    """uvicorn on connections that the supervisor has accepted."""

    def prepare(self, control: socket.socket, connections: socket.socket, peers: OtherWorkers) -> None:
        """What it is to talk over; before it runs."""
        self._control, self._connections, self._peers = control, connections, peers
        self._tasks: set[asyncio.Task[None]] = set()

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begin to answer, and report it."""
        loop = asyncio.get_running_loop()
        reader, self._writer = await asyncio.open_connection(sock=self._control, limit=LINE_BYTES)
        self._peers.ask = self._writer
        await super().startup([])
        self._connections.setblocking(False)
        loop.add_reader(self._connections, self._take_connections)
        self._start(self._listen(reader))
        self._send(Started())

    async def on_tick(self, counter: int) -> bool:
        """Ten times a second: count the connections."""
        self._count()
        return await super().on_tick(counter)

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """Take no further connection, end the sessions, and send the last metrics."""
        asyncio.get_running_loop().remove_reader(self._connections)
        await super().shutdown(sockets)
        self._send_metrics()
        with contextlib.suppress(OSError):
            await self._writer.drain()
        self._writer.close()

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """SIGTERM stops this worker; Ctrl-C and a closed terminal are the supervisor's to handle."""
        signal.signal(signal.SIGTERM, lambda number, frame: setattr(self, "should_exit", True))
        yield

    def _take_connections(self) -> None:
        for _ in range(AT_ONCE):
            try:
                _, descriptors, _, _ = socket.recv_fds(self._connections, 1, 1)
            except BlockingIOError:
                return
            if not descriptors:
                log.error("a connection is lost: this process may open no further file")
                self._count(taken=1)
                self._wait_for_files()
                return
            for descriptor in descriptors:
                self._start(self._open(socket.socket(fileno=descriptor)))

    def _wait_for_files(self) -> None:
        """Take no connection for a moment: those that wait are not lost, and further ones go to others."""
        loop = asyncio.get_running_loop()
        loop.remove_reader(self._connections)
        loop.call_later(NO_FILES_S, self._go_on)

    def _go_on(self) -> None:
        if not self.should_exit:
            asyncio.get_running_loop().add_reader(self._connections, self._take_connections)

    async def _open(self, connection: socket.socket) -> None:
        """Answer on a connection."""
        connection.setblocking(False)
        try:
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            await asyncio.get_running_loop().connect_accepted_socket(self._protocol, connection)
        except OSError:  # it was closed meanwhile
            connection.close()
        self._count(taken=1)

    def _protocol(self) -> asyncio.Protocol:
        """What uvicorn makes for a connection that it has accepted itself."""
        kind = cast(type[BoundedHttpProtocol], self.config.http_protocol_class)
        return kind(self.config, self.server_state, self.lifespan.state)

    def _count(self, taken: int = 0) -> None:
        self._peers.count_connections(len(self.server_state.connections), taken)

    async def _listen(self, reader: asyncio.StreamReader) -> None:
        """Do what the supervisor asks, until it asks to stop or has ended."""
        with contextlib.suppress(OSError):
            while line := await reader.readline():
                message = to_worker.decode(line)
                if isinstance(message, Collect):
                    self._send_metrics()
                elif isinstance(message, ServiceReady):
                    self._peers.ready = True
                elif isinstance(message, Text):
                    self._peers.take_text(message.text)
                else:  # Stop
                    break
        self.should_exit = True

    def _send_metrics(self) -> None:
        self.service.update_metrics()
        self._send(Collected(families_of(self.service.metrics.registry)))

    def _send(self, message: FromWorker) -> None:
        send(self._writer, message)

    def _start(self, coroutine: Coroutine[Any, Any, None]) -> None:
        task = asyncio.get_running_loop().create_task(coroutine)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


def first_message(control: socket.socket) -> Begin:
    """What the supervisor sends first; raises EOFError where it has ended."""
    with control.makefile("rb", buffering=0) as file:  # takes nothing of what comes next
        line = file.readline()
    if not line:
        raise EOFError("the supervisor has ended")
    return msgspec.json.decode(line, type=Begin)


def main(arguments: list[str]) -> None:
    """Serve until the supervisor asks to stop."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    control, connections, counted = map(int, arguments)
    control_socket = socket.socket(fileno=control)
    begin = first_message(control_socket)
    settings = Settings(**begin.settings)
    set_up(settings.log_format, begin.number)
    service = Service(settings)
    counts = WorkerCounts(begin.workers, settings.max_sessions, counted)
    peers = OtherWorkers(begin.number, counts)
    service.peers, service.networks = peers, NetworkCounts(counts.networks, begin.number)
    server = WorkerServer(web_config(HostRule(settings.host, settings.allow_host), service))
    server.announce, server.service = lambda: None, service
    server.prepare(control_socket, socket.socket(fileno=connections), peers)
    tune_collector()
    bound_free_memory()
    server.run([])


if __name__ == "__main__":
    main(sys.argv[1:])
