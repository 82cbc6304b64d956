"""The session on the page: a service whose ``/v1/live`` is fed by it."""

from __future__ import annotations

import socket
import threading
from collections.abc import Sequence

import typer
from msgspec.structs import replace

from pointpred.live.run import OpenPage
from pointpred.live.session import LiveSession, LiveState
from pointpred.protocol.server_messages import Attached, Curve, Status
from pointpred.records import Pair
from pointpred_server.cli.serve import open_port, settings_of
from pointpred_server.listening import address, make_server
from pointpred_server.live_feed import LiveFeed
from pointpred_server.logs import set_up
from pointpred_server.service import Service
from pointpred_server.settings import Settings


def page_opener(host: str | None, port: int | None) -> OpenPage:
    """What opens the page of a session; raises ParameterError for settings that are wrong."""
    settings = settings_of(host=host, port=port)

    def open_page(session: LiveSession, predictor: str, cpi: float | None, dpi: float) -> PageService:
        set_up(None)  # a view in the terminal takes the log from here
        return PageService(live_feed(session, predictor, cpi, dpi), settings, open_port(settings))

    return open_page


def live_feed(session: LiveSession, predictor: str, cpi: float | None, dpi: float) -> LiveFeed:
    """The feed of a session for viewers of the page."""
    source = session.source
    attached = Attached(source.name, source.clock, session.space, session.words, predictor, cpi, dpi)
    feed = LiveFeed(attached, lambda: status_of(session.state()))

    def update_device(pairs: Sequence[Pair]) -> None:
        """Another device may be followed by now, which may tell its positions."""
        was, name, clock = feed.attached, source.name, source.clock
        space, words = session.space, session.words
        if (was.name, was.clock, was.space, was.words) != (name, clock, space, words):
            feed.attached = replace(was, name=name, clock=clock, space=space, words=words)

    session.watchers += [update_device, feed.take]
    return feed


def status_of(state: LiveState) -> Status:
    """The state of a session as the message to its viewers."""
    return Status(**{name: getattr(state, name) for name in Status.__struct_fields__})


class PageService:
    """A ``LivePage``: a service on a listening socket, as ``pointpred serve`` starts it, with the feed."""

    def __init__(self, feed: LiveFeed, settings: Settings, listening: socket.socket) -> None:
        self._feed = feed
        self._listening = listening
        service = Service(settings)
        service.live = feed
        self.address = address(settings.host, listening) + service.settings.address_query
        self._announced = True
        self._server = make_server(service, self._announce)

    @property
    def watched(self) -> bool:
        """Whether there are viewers."""
        return self._feed.watched

    def show_curve(self, curve: Curve) -> None:
        """Show the newest transfer function; from any thread."""
        self._feed.curve = curve

    def fail(self, reason: str) -> None:
        """The device has failed: tell the viewers why; from any thread."""
        self._feed.fail(reason)

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
