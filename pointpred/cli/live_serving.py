"""The attached device on the page: the service with ``/v1/live`` fed by a session."""

from __future__ import annotations

import socket
import threading
from typing import TYPE_CHECKING

import typer

from pointpred.cli.serve import PORT, TRIES, settings_of

if TYPE_CHECKING:
    from pointpred.server.live.feed import LiveFeed


class Serving:
    """A service on this machine, as ``pointpred serve`` starts it: the environment's settings hold."""

    def __init__(self, feed: LiveFeed, host: str | None, port: int | None) -> None:
        from pointpred.server.hosts import HostRule
        from pointpred.server.listening.listening import address, listen, make_server
        from pointpred.server.service import Service

        given = {name: value for name, value in (("host", host), ("port", port)) if value is not None}
        settings = settings_of(given)
        wanted = settings.port
        self._opened: socket.socket = listen(
            settings.host, PORT if wanted is None else wanted, TRIES if wanted is None else 1
        )
        service = Service(settings)
        service.live = feed
        shown = service.settings
        token = f"?token={shown.token}" if shown.token and shown.show_token else ""
        self.address = address(settings.host, self._opened) + token
        rule = HostRule(settings.host, settings.allow_host)
        self._server = make_server(rule, service, self._announce)

    def run(self, stopping: threading.Event, *, said: bool) -> None:
        """Answer until interrupted or until ``stopping`` is set, which it is afterwards.

        ``said``: print the address once the page can be opened.
        """
        self._said = said
        threading.Thread(target=self._stop_with, args=(stopping,), daemon=True).start()
        try:
            with self._opened:
                self._server.run([self._opened])
        finally:
            stopping.set()

    def _announce(self) -> None:
        if self._said:
            typer.echo(self.address)

    def _stop_with(self, stopping: threading.Event) -> None:
        stopping.wait()
        self._server.should_exit = True
