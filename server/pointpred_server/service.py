"""Everything that one running service holds: its settings, its sessions, its counters."""

from __future__ import annotations

import asyncio
import logging
import secrets
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple, Protocol

from pointpred.clock import Instant, now
from pointpred.protocol.client_messages import Hello
from pointpred.protocol.server_messages import Code
from pointpred.recorder.writer import Recorder
from pointpred.studies.folder import Study
from pointpred_server.access import TOKEN_NEEDED, HostRule, RefusedOrigins, Scope, has_token, network_of
from pointpred_server.live_feed import LiveFeed
from pointpred_server.metrics import Metrics, SessionCounts
from pointpred_server.sessions.lifecycle import LOST, Session
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.sessions.prediction_stream import SessionObserver
from pointpred_server.sessions.quota import Address, Addresses
from pointpred_server.sessions.viewing import ViewingSession
from pointpred_server.settings import Settings, is_loopback

log = logging.getLogger("pointpred.service")

SWITCH_S = 5e-4
"""The event loop waits no longer for a thread that computes: Python's own 5 ms would delay every answer."""
TICK_S = 1.0
"""How often sessions are told that time passes, and counters are brought up to date."""
WRITE_S = 5.0
"""Seconds that recordings may take to be written at the end."""


class Refusal(NamedTuple):
    """Why a client has no session: it is told, and the connection closes."""

    code: Code
    message: str
    close: int


class Connection(Protocol):
    """The socket of a session; all on the event loop."""

    messages: int
    """Messages received."""

    def flush(self) -> None:
        """Send what the session has to say."""

    def tick(self, at: Instant, late_s: float) -> None:
        """Time passes; ``late_s``: so much later than it was due."""


class Service:
    """Opens sessions, and counts what they do."""

    def __init__(self, settings: Settings | None = None) -> None:
        self.settings = (settings or Settings()).guarded()
        self.hosts = HostRule(self.settings.host, self.settings.allow_host)
        self.metrics = Metrics(self.settings.max_sessions)
        self.recorder = Recorder(self.settings.record) if self.settings.record else None
        self.origins = RefusedOrigins()
        self.stopping = False
        self.live: LiveFeed | None = None
        """The attached device, where there is one."""
        self.study: Study | None = None
        """The study whose participants are served, where there is one."""
        self.aside = ThreadPoolExecutor(1, "trials")
        """Does what takes sessions long: one thing at a time, while the event loop goes on."""
        self._addresses = Addresses(self.settings.limits)
        self._open: dict[Session, tuple[Connection, Address, SessionCounts]] = {}
        self._ticking: asyncio.Task[None] | None = None

    def has_token(self, scope: Scope) -> bool:
        """Whether a request shows the token, where one is needed."""
        return has_token(scope, self.settings.token)

    def open_session(self, scope: Scope, connection: Connection) -> Session | Refusal:
        """A session for a request that was accepted, or why there is none.

        Sessions of this machine are not counted by address: one person may have many tabs, and a proxy that
        does not pass addresses on has one for everybody.
        """
        refusal = self._refuse_session(scope)
        network = network_of(scope["client"][0]) if scope["client"] else ""
        at, limits = now(), self.settings.limits
        address = self._addresses.of(network, at)
        if refusal is None and not is_loopback(network) and address.sessions >= self.settings.share:
            sentence = f"{self.settings.share} sessions of this address are open, which is the most"
            refusal = Refusal("too_many", sentence, 1013)
        if refusal is not None:
            self.count_refusal(refusal.code)
            return refusal
        name = secrets.token_hex(8)  # by which its log entries and its recording are found
        session: Session
        if scope["path"] == "/v1/live" and self.live is not None:
            session = ViewingSession(name, limits, at, self.live, address)
            self.live.join(session, connection.flush)
        else:
            coefficients = self.settings.coefficients
            session = PointingSession(name, limits, at, address, self._observe, coefficients)
        address.sessions += 1
        self._open[session] = connection, address, SessionCounts()
        self.metrics.sessions.set(len(self._open))
        log.info("session opened", extra={"session": name})
        return session

    def _refuse_session(self, scope: Scope) -> Refusal | None:
        if not self.has_token(scope):
            return Refusal("unauthorized", TOKEN_NEEDED, 1008)
        if self.stopping:
            return Refusal("stopping", "the service stops", 1001)
        most = self.settings.max_sessions
        if len(self._open) >= most:
            return Refusal("too_many", f"{most} sessions are open, which is the most", 1013)
        return None

    def close_session(self, session: Session) -> None:
        """The connection of a session has ended."""
        session.connection_lost()
        connection, address, counts = self._open.pop(session)
        address.sessions -= 1
        if self.live is not None:
            self.live.leave(session)
        self.metrics.update_session(session, connection.messages, counts)
        self.metrics.sessions.set(len(self._open))
        code = session.close.code if session.close else LOST
        self.metrics.ended.labels(str(code)).inc()
        about = {"session": session.name, "events": counts.events}
        if code == LOST:
            log.info("session closed: the client went away", extra=about)
        else:
            log.info("session closed", extra={**about, "code": code})

    def count_refusal(self, code: Code) -> None:
        """A request was refused before anything of it was heard."""
        self.metrics.connections_refused.labels(code).inc()

    def update_metrics(self) -> None:
        """Count what the open sessions and the recorder have done since the last update."""
        if (recorder := self.recorder) is not None:
            self.metrics.update_recorder(recorder.lost, recorder.failures, recorder.waiting)
        for session, (connection, _, counts) in self._open.items():
            self.metrics.update_session(session, connection.messages, counts)

    def start(self) -> None:
        """Begin to serve, and to read the attached device; on the event loop."""
        sys.setswitchinterval(SWITCH_S)
        loop = asyncio.get_running_loop()
        self._ticking = loop.create_task(self._tick())
        if self.live is not None:
            self.live.start(loop)

    async def _tick(self) -> None:
        before = now()
        while True:
            await asyncio.sleep(TICK_S)
            at = now()
            for connection, _, _ in list(self._open.values()):
                connection.tick(at, at.since(before) - TICK_S)
            self.update_metrics()
            before = at

    def shut_down(self) -> None:
        """Write what is recorded, and end the thread; more than once does nothing more."""
        if self._ticking is not None:
            self._ticking.cancel()
        self.aside.shutdown(wait=False, cancel_futures=True)
        if self.recorder is not None:
            self.recorder.close(WRITE_S)
        if self.study is not None:
            self.study.close()

    def _observe(self, name: str, hello: Hello) -> SessionObserver | None:
        return self.recorder.open(name, hello) if self.recorder else None
