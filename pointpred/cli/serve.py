"""``pointpred serve``: the page, on this machine unless told otherwise."""

from __future__ import annotations

from typing import Annotated

import typer

from pointpred.cli.screen import remarks

PORT = 8765
TRIES = 20
"""Ports tried, from the usual one upwards, when no port was asked for."""


def serve(
    host: Annotated[str, typer.Option(help="Address to listen on.")] = "127.0.0.1",
    port: Annotated[
        int | None,
        typer.Option(
            min=0, max=65535, help=f"Port; 0 takes any free one. Not given: the first free from {PORT}."
        ),
    ] = None,
    allow_host: Annotated[
        list[str] | None, typer.Option(help="A further name this service may be called by; repeatable.")
    ] = None,
) -> None:
    """Serve the page with the embedded sample; prints its address once it can be opened.

    Try:

      pointpred serve

      pointpred serve --port 0

      pointpred serve --host 0.0.0.0 --allow-host lab.example
    """
    from pointpred.server.hosts import HostRule
    from pointpred.server.listening import address, listen
    from pointpred.server.listening import serve as answer

    opened = listen(host, PORT if port is None else port, TRIES if port is None else 1)
    if port is None and opened.getsockname()[1] != PORT:
        remarks().print(f"port {PORT} is in use; taking the next free one")

    def announce() -> None:
        typer.echo(address(host, opened))
        remarks().print("Open it in a browser. Ctrl-C stops.")

    try:
        answer(opened, HostRule(host, allow_host or ()), announce)
    except KeyboardInterrupt:
        remarks().print("stopped")
