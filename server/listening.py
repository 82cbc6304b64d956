"""Open a port, serve the application on it, and announce when the page can be opened."""

from __future__ import annotations

import asyncio
import errno
import http.client
import logging
import signal
import socket
import threading
import time
from collections.abc import Callable

import msgspec
import uvicorn

from pointpred.errors import SourceError
from pointpred.garbage import tune_collector
from pointpred_server.access import WILDCARDS, HostRule
from pointpred_server.allocator import bound_free_memory
from pointpred_server.app import create_app
from pointpred_server.http_protocol import counting
from pointpred_server.request_rates import RequestRates
from pointpred_server.service import Service
from pointpred_server.websocket_protocol import BoundedWebSocketProtocol

FRAME_BYTES = 2**20
"""The framework's own limit lies above every limit of ours, so that our error goes out first."""
SEND_BUFFER_BYTES = 2**16
"""What the kernel may hold unread for a client: more would be old predictions."""
CLOSE_S = 2.0
"""Seconds that clients have to close: closing earlier would reset the connection, and lose the ``bye``."""
REQUESTS_END_S = 3
"""Seconds that requests have to finish when the service stops."""
PROBE_S = 1.0
"""Seconds that the process on a port has to say whether it is pointpred."""
HEALTH_BYTES = 1024
"""Longest answer that is read from it."""
CANCEL_S = 1.0
"""Seconds that cancelled requests have to end."""

REUSE = getattr(socket, "SO_EXCLUSIVEADDRUSE", socket.SO_REUSEADDR)
"""Take a port that a closed service held. On Windows SO_REUSEADDR would also take one that is in use."""

log = logging.getLogger("pointpred.service")


def listen(host: str, port: int, tries: int = 1) -> socket.socket:
    """A listening socket on the first free port of ``port``, ``port + 1``, ...; raises SourceError."""
    for candidate in range(port, port + tries):
        try:
            return _bind(host, candidate)
        except OSError as error:
            # Windows keeps blocks of ports for itself and refuses them: another one may be free.
            if error.errno not in ((errno.EADDRINUSE, errno.EACCES) if tries > 1 else (errno.EADDRINUSE,)):
                raise SourceError(f"cannot listen on {host} port {candidate}: {error.strerror}") from error
        except UnicodeError as error:
            raise SourceError(f"cannot listen on {host!r}: not the name of a host") from error
    if tries == 1 and answers_as_pointpred(host, port):
        raise SourceError(
            f"pointpred already runs on {host} port {port}: stop it with Ctrl-C where it was started, "
            "or choose another port with --port"
        )
    ports = f"port {port} is" if tries == 1 else f"ports {port} to {port + tries - 1} are"
    raise SourceError(f"{ports} in use on {host}; choose another with --port, or --port 0 for any free one")


def answers_as_pointpred(host: str, port: int) -> bool:
    """Whether what listens on a port of this machine is pointpred; False where it does not answer soon."""
    name = "127.0.0.1" if host in WILDCARDS else host
    connection = http.client.HTTPConnection(name, port, timeout=PROBE_S)
    try:
        connection.request("GET", "/healthz")
        health = msgspec.json.decode(connection.getresponse().read(HEALTH_BYTES))
    except (OSError, http.client.HTTPException, msgspec.DecodeError, UnicodeError):
        return False
    finally:
        connection.close()
    return isinstance(health, dict) and health.keys() == {"status", "version"}


def _bind(host: str, port: int) -> socket.socket:
    family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    opened = socket.socket(family, kind, protocol)
    try:
        opened.setsockopt(socket.SOL_SOCKET, REUSE, 1)
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, SEND_BUFFER_BYTES)  # connections inherit it
        opened.bind(address)
        opened.listen(socket.SOMAXCONN)
    except OSError:
        opened.close()
        raise
    return opened


def address(host: str, opened: socket.socket) -> str:
    """The URL to open in a browser on this machine."""
    name = "127.0.0.1" if host in WILDCARDS else host
    return f"http://{f'[{name}]' if ':' in name else name}:{opened.getsockname()[1]}/"


class _Cancellations(logging.Filter):
    """Counts what uvicorn logs of requests that it cancels, and drops those entries: we log one instead."""

    requests = 0

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether an entry is about something else."""
        if str(record.msg).startswith("Cancel %s running task") and isinstance(record.args, tuple):
            self.requests = int(str(record.args[0]))
            return False
        return record.exc_info is None or not isinstance(record.exc_info[1], asyncio.CancelledError)


class PointpredServer(uvicorn.Server):
    """uvicorn that announces when it has begun to answer, and stops the sessions when it is asked to stop."""

    announce: Callable[[], None]
    service: Service

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begin to answer, and announce it."""
        await super().startup(sockets)
        if self.started:
            self.announce()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        """End the sessions, then everything else; whoever connects meanwhile is refused."""
        for listening in (*self.servers, *(sockets or ())):
            listening.close()
        self.service.stop()
        until = time.monotonic() + self.service.left_s(CLOSE_S)
        while self._has_websockets() and time.monotonic() < until:
            await asyncio.sleep(0.01)
        cancellations = _Cancellations()
        library = logging.getLogger("uvicorn.error")
        library.addFilter(cancellations)
        try:
            await super().shutdown(sockets)
            if cancelled := list(self.server_state.tasks):
                await asyncio.wait(cancelled, timeout=self.service.left_s(CANCEL_S))
        finally:
            library.removeFilter(cancellations)
        if cancellations.requests:
            log.warning(
                "%d requests were cancelled: they had not ended %d s after the stop",
                cancellations.requests,
                REQUESTS_END_S,
            )

    def _has_websockets(self) -> bool:
        """Whether a WebSocket is still open."""
        return any(isinstance(one, BoundedWebSocketProtocol) for one in self.server_state.connections)


def make_server(hosts: HostRule, service: Service, announce: Callable[[], None]) -> PointpredServer:
    """The web server, ready to run on a listening socket."""
    server = PointpredServer(web_config(hosts, service))
    server.announce, server.service = announce, service
    return server


def web_config(hosts: HostRule, service: Service) -> uvicorn.Config:
    """How uvicorn serves the application."""
    return uvicorn.Config(
        create_app(hosts, service),
        log_config=None,
        log_level="warning",
        access_log=False,
        http=counting(
            service.refuse_request, RequestRates(service.settings.trust_proxy)
        ),  # httptools, bounded
        ws=BoundedWebSocketProtocol,  # websockets-sansio, with bounds
        ws_max_size=FRAME_BYTES,
        ws_per_message_deflate=False,
        server_header=False,
        proxy_headers=bool(service.settings.trust_proxy),
        forwarded_allow_ips=list(service.settings.trust_proxy),  # else uvicorn asks the environment
        timeout_graceful_shutdown=REQUESTS_END_S,
    )


def _stop_at_hangup(server: PointpredServer) -> None:
    """Stop at SIGHUP, which a terminal that is closed sends, as at SIGTERM; ``nohup`` has it ignored."""
    hangup = getattr(signal, "SIGHUP", None)
    in_main_thread = threading.current_thread() is threading.main_thread()
    if hangup is not None and in_main_thread and signal.getsignal(hangup) is signal.SIG_DFL:
        signal.signal(hangup, server.handle_exit)


def serve(opened: socket.socket, hosts: HostRule, service: Service, announce: Callable[[], None]) -> None:
    """Answer on a listening socket until interrupted; ``announce`` is called when the page can be opened."""
    server = make_server(hosts, service, announce)
    tune_collector()
    bound_free_memory()
    _stop_at_hangup(server)
    try:
        with opened:
            server.run([opened])
    finally:
        service.shut_down()  # where uvicorn has not done so: whatever breaks there, recordings are written
