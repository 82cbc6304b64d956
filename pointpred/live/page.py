"""The session on the page: a service whose ``/v1/live`` is fed by it."""

from __future__ import annotations

import socket
import threading
from collections.abc import Sequence

import typer
from msgspec.structs import replace

from pointpred.live.session import LiveSession, LiveState
from pointpred.protocol.live_messages import Attached, Status
from pointpred.records import Pair
from pointpred_server.access import HostRule
from pointpred_server.listening import address, make_server
from pointpred_server.live_feed import LiveFeed
from pointpred_server.service import Service
from pointpred_server.settings import Settings


def live_feed(session: LiveSession, predictor: str, cpi: float | None, dpi: float) -> LiveFeed:
    """The feed of a session for viewers of the page."""
    source = session.source
    attached = Attached(source.name, source.clock, session.space, session.words, predictor, cpi, dpi)
    feed = LiveFeed(attached, lambda: status_of(session.state()))

    def update_device(pairs: Sequence[Pair]) -> None:
        """Another device may be followed by now."""
        if (feed.attached.name, feed.attached.clock) != (source.name, source.clock):
            feed.attached = replace(feed.attached, name=source.name, clock=source.clock)

    session.watchers += [update_device, feed.take]
    return feed


def status_of(state: LiveState) -> Status:
    """The state of a session as the message to its viewers."""
    return Status(**{name: getattr(state, name) for name in Status.__struct_fields__})


class PageService:
    """A service on a listening socket, as ``pointpred serve`` starts it, with the feed of a session."""

    def __init__(self, feed: LiveFeed, settings: Settings, listening: socket.socket) -> None:
        self._listening = listening
        service = Service(settings)
        service.live = feed
        self.address = address(settings.host, listening) + service.settings.address_query
        self._announced = True
        self._server = make_server(HostRule(settings.host, settings.allow_host), service, self._announce)

    def run(self, stopping: threading.Event, *, announce: bool) -> None:
        """Serve until interrupted or until ``stopping`` is set, which it is afterwards.

        ``announce``: print the address once the page can be opened.
        """
        self._announced = announce
        threading.Thread(target=self._stop_with, args=(stopping,), daemon=True).start()
        try:
            with self._listening:
                self._server.run([self._listening])
        finally:
            stopping.set()

    def _announce(self) -> None:
        if self._announced:
            typer.echo(self.address)

    def _stop_with(self, stopping: threading.Event) -> None:
        stopping.wait()
        self._server.should_exit = True
