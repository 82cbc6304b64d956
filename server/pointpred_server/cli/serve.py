"""``pointpred serve``: the page and the WebSocket, on this machine unless told otherwise."""

from __future__ import annotations

import socket as sockets
from pathlib import Path
from socket import socket
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.cli.help_text import option_error
from pointpred.console import remarks
from pointpred.errors import ParameterError
from pointpred_server.cli.service_start import ServiceStart

if TYPE_CHECKING:
    from pointpred_server.settings import Settings

PORT = 8765
TRIES = 20
"""Ports tried, from the usual one upwards, when no port was asked for."""


def serve(
    host: Annotated[str | None, typer.Option(help="Address to listen on (127.0.0.1).")] = None,
    port: Annotated[
        int | None,
        typer.Option(
            min=0,
            max=65535,
            help=f"Port to listen on; 0 takes any free one. Not given: the first free one from {PORT}.",
        ),
    ] = None,
    workers: Annotated[
        int | None, typer.Option(help="Processes that share the sessions (1); not on Windows.")
    ] = None,
    allow_host: Annotated[
        list[str] | None, typer.Option(help="Another host name this service answers to; repeatable.")
    ] = None,
    allow_origin: Annotated[
        list[str] | None,
        typer.Option(help="Origin of a page elsewhere that may connect, as https://lab.example; repeatable."),
    ] = None,
    trust_proxy: Annotated[
        list[str] | None,
        typer.Option(
            metavar="ADDRESS",
            help="Reverse proxy whose X-Forwarded-... headers are believed, as 127.0.0.1; repeatable.",
        ),
    ] = None,
    token: Annotated[
        str | None, typer.Option(help="Secret of at least 8 characters that clients must send.")
    ] = None,
    record: Annotated[
        Path | None,
        typer.Option(metavar="FOLDER", help="Record every session in this folder. Off by default."),
    ] = None,
    coefficients: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=FILE", help="Coefficients of 'pointpred train' that clients may name; repeatable."
        ),
    ] = None,
    log_format: Annotated[
        str | None, typer.Option(help="json or text. Not given: text in a terminal, json elsewhere.")
    ] = None,
    max_sessions: Annotated[int | None, typer.Option(help="Most sessions at a time.")] = None,
    max_per_address: Annotated[
        int | None,
        typer.Option(
            help="Most sessions of one other machine; of IPv6, of one /64 network. "
            "Not given: half of --max-sessions."
        ),
    ] = None,
    max_events_per_s: Annotated[int | None, typer.Option(help="Most events a second in one session.")] = None,
    max_frame_bytes: Annotated[int | None, typer.Option(help="Most bytes in one frame.")] = None,
    max_targets: Annotated[int | None, typer.Option(help="Most targets in one session.")] = None,
    idle_s: Annotated[
        float | None, typer.Option(help="End a session after this many seconds without a frame.")
    ] = None,
) -> None:
    """Serve the live page and the WebSocket; prints the address once the page can be opened.

    Every option can also be set in the environment: POINTPRED_PORT, POINTPRED_TOKEN, ...

    Try:

      pointpred serve

      pointpred serve --port 9000

      POINTPRED_PORT=9000 make run

      pointpred serve --port 0 --record sessions

      pointpred serve --host 0.0.0.0 --allow-host lab.example

      pointpred serve --workers 4
    """
    options = {name: value for name, value in locals().items() if value not in (None, [])}
    from pointpred_server.listening import address
    from pointpred_server.logs import set_up

    settings = settings_of(options).guarded()
    if settings.workers > 1 and not hasattr(sockets, "send_fds"):
        raise ParameterError(
            f"--workers {settings.workers}: this system cannot hand connections to other processes; "
            "serve with --workers 1"
        )
    set_up(settings.log_format)
    opened = open_port(settings)
    if settings.port is None and opened.getsockname()[1] != PORT:
        remarks().print(f"port {PORT} is in use; taking the next free one. --port N chooses another")
    starting = ServiceStart(settings, address(settings.host, opened))
    try:
        if settings.workers == 1:
            _serve_alone(opened, settings, starting)
        else:
            _serve_with_workers(opened, settings, starting)
    except KeyboardInterrupt:
        remarks().print("stopped")


def _serve_alone(opened: socket, settings: Settings, starting: ServiceStart) -> None:
    """Serve from this process."""
    from pointpred_server.access import HostRule
    from pointpred_server.listening import serve as answer
    from pointpred_server.service import Service

    answer(opened, HostRule(settings.host, settings.allow_host), Service(settings), starting.announce)


def _serve_with_workers(opened: socket, settings: Settings, starting: ServiceStart) -> None:
    """Serve from several processes, which this one starts and watches."""
    from pointpred.recorder.recordings import prepare
    from pointpred_server.workers.supervisor import Supervisor, supervise

    if settings.record is not None:
        prepare(settings.record)
    supervise(Supervisor(opened, settings, starting.announce))


def open_port(settings: Settings) -> socket:
    """A listening socket on the port of the settings, else on the first free one; raises SourceError."""
    from pointpred_server.listening import listen

    port = settings.port
    return listen(settings.host, PORT, TRIES) if port is None else listen(settings.host, port)


def settings_of(options: dict[str, Any]) -> Settings:
    """The settings from flags and environment; raises ParameterError in one line for a wrong one."""
    from pydantic import ValidationError

    from pointpred_server.settings import Settings

    try:
        return Settings(**options)
    except ValidationError as error:
        first = error.errors()[0]
        name = "_".join(str(part) for part in first["loc"]) or "settings"
        raise ParameterError(
            f"{option_error(name, first)} (flag --{name.replace('_', '-')} or POINTPRED_{name.upper()})"
        ) from None
