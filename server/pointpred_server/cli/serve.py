"""``pointpred serve``: the page and the WebSocket, on this machine unless told otherwise."""

from __future__ import annotations

import logging
from pathlib import Path
from socket import socket
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.cli.help_text import option_error
from pointpred.console import remarks
from pointpred.errors import ParameterError, SourceError
from pointpred_server.cli.service_start import ServiceStart

if TYPE_CHECKING:
    from pointpred_server.service import Service
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
    metrics_port: Annotated[
        int | None,
        typer.Option(
            min=0,
            max=65535,
            help="Port of 127.0.0.1 with metrics for Prometheus; 0 takes any free one. Not given: none.",
        ),
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

      pointpred serve --metrics-port 9765
    """
    options = {name: value for name, value in locals().items() if value not in (None, [])}
    from pointpred_server.listening import address
    from pointpred_server.listening import serve as answer
    from pointpred_server.logs import set_up
    from pointpred_server.service import Service

    settings = settings_of(options).guarded()
    style = set_up(settings.log_format)
    opened = open_port(settings)
    if settings.port is None and opened.getsockname()[1] != PORT:
        remarks().print(f"port {PORT} is in use; taking the next free one. --port N chooses another")
    say = logging.getLogger("pointpred.service").info if style == "json" else None
    starting = ServiceStart(settings, address(settings.host, opened), say)
    service = Service(settings)
    if settings.metrics_port is not None:
        starting.tell_metrics(serve_metrics(service, settings.metrics_port))
    try:
        answer(opened, service, starting.announce)
    except KeyboardInterrupt:
        remarks().print("stopped")


def serve_metrics(service: Service, port: int) -> int:
    """Answer Prometheus on a port of loopback; returns the port. Raises SourceError where it is taken."""
    try:
        return service.metrics.serve(port)
    except OSError as error:
        raise SourceError(
            f"cannot serve metrics on 127.0.0.1 port {port}: {error.strerror}; choose another with "
            "--metrics-port, or --metrics-port 0 for any free one"
        ) from error


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
        name = "_".join(str(part) for part in first["loc"])
        if not name:
            raise ParameterError(str(first["ctx"]["error"])) from None
        raise ParameterError(
            f"{option_error(name, first)} (flag --{name.replace('_', '-')} or POINTPRED_{name.upper()})"
        ) from None
