"""``pointpred serve``: the page and the WebSocket, on this machine unless told otherwise."""

from __future__ import annotations

import logging
from collections.abc import Iterable, Iterator
from inspect import Parameter
from socket import socket
from typing import TYPE_CHECKING, Any

from pointpred.cli.help_text import option_error
from pointpred.cli.options import option, with_options
from pointpred.cli.shared_options import tell_others
from pointpred.console import remarks
from pointpred.errors import ParameterError, SourceError
from pointpred_server.cli.service_start import ServiceStart
from pointpred_server.settings import Settings

if TYPE_CHECKING:
    from pointpred_server.service import Service

PORT = 8765
TRIES = 20
"""Ports tried, from the usual one upwards, when no port was asked for."""


FLAGS = {
    "host": "ADDRESS",
    "port": "NUMBER",
    "metrics_port": "NUMBER",
    "allow_host": "HOST",
    "allow_origin": "ORIGIN",
    "trust_proxy": "ADDRESS",
    "token": "SECRET",
    "record": "FOLDER",
    "coefficients": "NAME=FILE",
}
"""The settings that have a flag, and what stands for a value of each."""


def flags(names: Iterable[str] = tuple(FLAGS)) -> Iterator[Parameter]:
    """The options of these settings."""
    for name in names:
        metavar, setting = FLAGS[name], Settings.model_fields[name]
        several = isinstance(setting.default, tuple | dict)
        words = f"{setting.description} Repeatable." if several else setting.description
        yield option(name, (list[str] if several else str) | None, metavar=metavar, help=words)


def settings_of(**options: Any) -> Settings:
    """The settings from flags and environment; raises ParameterError in one line for a wrong one."""
    from pydantic import ValidationError

    try:
        return Settings(**{name: value for name, value in options.items() if value not in (None, [])})
    except ValidationError as error:
        first = error.errors()[0]
        name = "_".join(str(part) for part in first["loc"])
        if not name:
            raise ParameterError(str(first["ctx"]["error"])) from None
        flag = f"flag --{name.replace('_', '-')} or " if name in FLAGS else ""
        raise ParameterError(f"{option_error(name, first)} ({flag}POINTPRED_{name.upper()})") from None


@with_options("settings", flags(), settings_of)
def serve(settings: Settings) -> None:
    """Serve the live page and the WebSocket; prints the address once the page can be opened.

    Every option can also be set in the environment: POINTPRED_PORT, POINTPRED_TOKEN, ... Limits are set there
    alone, such as POINTPRED_MAX_SESSIONS; docs/reference/settings.md lists them.

    Try:

      pointpred serve

      pointpred serve --port 9000

      POINTPRED_PORT=9000 make run

      pointpred serve --port 0 --record sessions

      pointpred serve --host 0.0.0.0 --allow-host lab.example

      POINTPRED_MAX_SESSIONS=8 pointpred serve --metrics-port 9765
    """
    from pointpred_server.listening import address
    from pointpred_server.listening import serve as answer
    from pointpred_server.logs import set_up
    from pointpred_server.service import Service

    tell_others()
    settings = settings.guarded()
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
