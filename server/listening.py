"""Open a port, serve the application on it, and say so once the page can be opened."""

from __future__ import annotations

import errno
import socket
from collections.abc import Callable

import uvicorn

from pointpred.errors import SourceError
from pointpred.server.app import create_app
from pointpred.server.hosts import WILDCARDS, HostRule

STOP_S = 5
"""Seconds that requests under way get to finish when the service stops."""


def listen(host: str, port: int, tries: int = 1) -> socket.socket:
    """A listening socket on the first free port of ``port``, ``port + 1``, ...; raises SourceError."""
    for candidate in range(port, port + tries):
        try:
            return _bind(host, candidate)
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise SourceError(f"cannot listen on {host} port {candidate}: {error.strerror}") from error
    ports = f"port {port} is" if tries == 1 else f"ports {port} to {port + tries - 1} are"
    raise SourceError(f"{ports} in use on {host}; choose another with --port, or --port 0 for any free one")


def _bind(host: str, port: int) -> socket.socket:
    family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    opened = socket.socket(family, kind, protocol)
    try:
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
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


class _Server(uvicorn.Server):
    """uvicorn that says when it has begun to answer."""

    announce: Callable[[], None]

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            self.announce()


def serve(opened: socket.socket, hosts: HostRule, announce: Callable[[], None]) -> None:
    """Answer on a listening socket until interrupted; ``announce`` is called when the page can be opened."""
    config = uvicorn.Config(
        create_app(hosts),
        log_level="warning",
        access_log=False,
        ws="none",
        server_header=False,
        timeout_graceful_shutdown=STOP_S,
    )
    server = _Server(config)
    server.announce = announce
    with opened:
        server.run([opened])
