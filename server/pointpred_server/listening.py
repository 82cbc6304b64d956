"""Open a port, serve the application on it, and announce when the page can be opened."""

from __future__ import annotations

import errno
import http.client
import signal
import socket
from collections.abc import Callable
from functools import partial
from typing import Any

import msgspec
import uvicorn

from pointpred.errors import SourceError
from pointpred.garbage import tune_collector
from pointpred_server.access import WILDCARDS
from pointpred_server.app import create_app
from pointpred_server.service import Service
from pointpred_server.websocket_protocol import WebSocketProtocol

HEADER_BYTES = 2**16
"""Longest header of a request."""
REQUESTS_MOST = 256
"""Connections beside those of sessions; a request on one more is answered with 503."""
SEND_BUFFER_BYTES = 2**16
"""What the kernel may hold unread for a client: more would be old predictions."""
END_S = 4
"""Seconds that requests and sessions have to end when the service stops."""
PROBE_S = 1.0
"""Seconds that the process on a port has to say whether it is pointpred."""
HEALTH_BYTES = 1024
"""Longest answer that is read from it."""
REUSE = getattr(socket, "SO_EXCLUSIVEADDRUSE", socket.SO_REUSEADDR)
"""Take a port that a closed service held. On Windows SO_REUSEADDR would also take one that is in use."""


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


def make_server(service: Service, announce: Callable[[], None]) -> uvicorn.Server:
    """The web server, ready to run on a listening socket.

    ``announce`` is called when the page can be opened: connections wait in the socket until then.
    """
    websocket: Any = partial(WebSocketProtocol, service)
    config = uvicorn.Config(
        create_app(service, announce),
        log_config=None,
        log_level="warning",
        access_log=False,
        http="h11",
        h11_max_incomplete_event_size=HEADER_BYTES,
        ws=websocket,
        limit_concurrency=service.settings.max_sessions + REQUESTS_MOST,
        server_header=False,
        proxy_headers=bool(service.settings.trust_proxy),
        forwarded_allow_ips=list(service.settings.trust_proxy),  # else uvicorn asks the environment
        timeout_graceful_shutdown=END_S,
    )
    return uvicorn.Server(config)


def serve(opened: socket.socket, service: Service, announce: Callable[[], None]) -> None:
    """Answer on a listening socket until interrupted; ``announce`` is called when the page can be opened."""
    server = make_server(service, announce)
    tune_collector()
    hangup = getattr(signal, "SIGHUP", None)
    if hangup is not None and signal.getsignal(hangup) is signal.SIG_DFL:
        # A terminal that is closed sends it; ``nohup`` has it ignored.
        signal.signal(hangup, server.handle_exit)
    try:
        with opened:
            server.run([opened])
    finally:
        service.shut_down()  # where uvicorn has not done so: whatever breaks there, recordings are written
