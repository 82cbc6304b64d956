"""Everything that one running service holds: its settings, its sessions, its counters."""

from __future__ import annotations

import asyncio
import logging
import math
import secrets
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

import numpy as np

from pointpred.protocol.client_messages import Hello
from pointpred.protocol.server_messages import Code
from pointpred.recorder.writer import Recorder
from pointpred_server.access import RefusedOrigins, network_of
from pointpred_server.arrivals import Arrivals
from pointpred_server.connection import Connection
from pointpred_server.live_feed import LiveFeed
from pointpred_server.metrics import Metrics, SessionCounts
from pointpred_server.network_counts import NetworkCounts
from pointpred_server.sessions.lifecycle import Session
from pointpred_server.sessions.observer import SessionObserver
from pointpred_server.sessions.pointing import PointingSession
from pointpred_server.sessions.viewing import ViewingSession
from pointpred_server.settings import Settings, is_loopback
from pointpred_server.work_threads import WorkThreads

log = logging.getLogger("pointpred.service")

SWITCH_S = 5e-4
"""The event loop waits no longer for a thread that computes: Python's own 5 ms would delay every answer."""
LOST = 1006
"""The close code under which a lost connection is counted: a tab was closed, a process ended."""

STOP_TOTAL_S = 8.0
"""Seconds in which everything has ended after the stop, recordings included; the process ends within ten."""
WRITE_S = 5.0
"""Seconds of them that recordings may take to be written."""
STOPS = "the server stops"
"""What sessions are told."""


class Peers(Protocol):
    """The workers of a service that has several, this one included."""

    ready: bool
    """Whether every worker has started."""

    @property
    def sessions(self) -> int:
        """Sessions of all workers."""

    def count_sessions(self, own: int) -> None:
        """How many sessions this worker has."""

    async def metrics(self) -> bytes:
        """The metrics of all workers, in the exposition format; raises TimeoutError."""


class Service:
    """Opens sessions, counts what they do, and stops them."""

    def __init__(self, settings: Settings | None = None) -> None:
        self.settings = (settings or Settings()).guarded()
        self.metrics = Metrics()
        self.recorder = Recorder(self.settings.record) if self.settings.record else None
        self.origins = RefusedOrigins()
        self.stopping = False
        self.arrivals = Arrivals()
        """How busy the event loop is, which all connections share."""
        self.work_threads = WorkThreads()
        """Do what takes sessions long, beside the event loop."""
        self.live: LiveFeed | None = None
        """The attached device, where there is one."""
        self.peers: Peers | None = None
        """The other workers, where there are several."""
        self.networks = NetworkCounts(np.zeros((1, self.settings.max_sessions), np.int64))
        """Sessions of other machines, those of the other workers included."""
        self._stop_by = math.inf  # when everything has to have ended
        self._shut_down = False
        self._open: dict[Session, tuple[Connection | None, SessionCounts]] = {}

    @property
    def ready(self) -> bool:
        """Whether sessions are served: every worker has started, and the service does not stop."""
        return (self.peers is None or self.peers.ready) and not self.stopping

    @property
    def full(self) -> bool:
        """Whether no further session is admitted: the bound is one for all workers."""
        sessions = len(self._open) if self.peers is None else self.peers.sessions
        return sessions >= self.settings.max_sessions

    @contextmanager
    def place_of_address(self, address: str | None) -> Iterator[bool]:
        """Whether an address may have one more session; it is counted until the block ends.

        To be asked where the service is not full, for a session that is opened at once.
        Sessions of this machine are not counted: one person may have many tabs, and a proxy that does not
        pass addresses on has one for everybody.
        """
        network = None if address is None else network_of(address)
        if network is None or is_loopback(network):
            yield True
            return
        with self.networks.place(network) as sessions:
            yield sessions <= self.settings.share

    def open_session(self, now: float) -> PointingSession:
        """A pointing session with a random name."""
        name, settings = secrets.token_hex(8), self.settings
        session = PointingSession(name, settings.limits, now, self._observe, settings.coefficients)
        self._add(session)
        return session

    def open_viewer(self, now: float) -> ViewingSession:
        """A session that shows the attached device."""
        viewer = ViewingSession(secrets.token_hex(8), self.settings.limits, now)
        self._add(viewer)
        return viewer

    def _add(self, session: Session) -> None:
        self._open[session] = (None, SessionCounts())
        self._count_sessions()
        log.info("session opened", extra={"session": session.name})

    def _count_sessions(self) -> None:
        self.metrics.sessions.set(len(self._open))
        if self.peers is not None:
            self.peers.count_sessions(len(self._open))

    def attach(self, session: Session, connection: Connection) -> None:
        """Remember the connection of a session: it is woken when the service stops."""
        self._open[session] = (connection, self._open[session][1])
        if self.stopping:
            session.stop(STOPS)
            connection.flush()

    def close_session(self, session: Session) -> None:
        """The connection of a session has ended."""
        session.connection_lost()
        connection, counts = self._open.pop(session)
        self.metrics.update_session(session, _frames(connection), counts)
        self._count_sessions()
        code = session.close.code if session.close else LOST
        self.metrics.ended.labels(str(code)).inc()
        about = {"session": session.name, "events": counts.events}
        if code == LOST:
            log.info("session closed: the client went away", extra=about)
        else:
            log.info("session closed", extra={**about, "code": code})

    def refuse_request(self, code: Code) -> None:
        """A request was refused before anything of it was heard."""
        self.metrics.connections_refused.labels(code).inc()

    def refuse_origin(self, origin: str | None) -> None:
        """A page of another site was refused: counted, and logged once an origin."""
        self.refuse_request("unauthorized")
        self.origins.add(origin)

    async def metrics_text(self) -> bytes:
        """The metrics in the exposition format, those of all workers where there are several.

        Raises TimeoutError where these do not come.
        """
        if self.peers is not None:
            return await self.peers.metrics()
        self.update_metrics()
        return self.metrics.text()

    def update_metrics(self) -> None:
        """Count what the open sessions and the recorder have done since the last update."""
        if self.peers is None:  # else the limit is one for all workers: the supervisor shows it
            self.metrics.sessions_limit.set(self.settings.max_sessions)
        if (recorder := self.recorder) is not None:
            self.metrics.update_recorder(recorder.lost, recorder.failures, recorder.waiting)
        for session, (connection, counts) in self._open.items():
            self.metrics.update_session(session, _frames(connection), counts)

    def start(self) -> None:
        """Begin to serve, and to read the attached device."""
        sys.setswitchinterval(SWITCH_S)
        if self.live is not None:
            self.live.start(asyncio.get_running_loop())

    def stop(self, reason: str = STOPS) -> None:
        """Send bye to every session; new ones are refused."""
        if not self.stopping:
            self._stop_by = time.monotonic() + STOP_TOTAL_S
        self.stopping = True
        for session, (connection, _) in list(self._open.items()):
            session.stop(reason)
            if connection is not None:
                connection.flush()

    def left_s(self, most: float) -> float:
        """Seconds that a step of stopping may take: at most so many, and no more than are left."""
        return max(0.0, min(most, self._stop_by - time.monotonic()))

    def shut_down(self) -> None:
        """Write what is recorded, and end the threads; once."""
        if self._shut_down:
            return
        self.work_threads.shut_down()
        if self.recorder is not None:
            self.recorder.close(self.left_s(WRITE_S))
        self._shut_down = True

    def _observe(self, name: str, hello: Hello) -> SessionObserver | None:
        return self.recorder.open(name, hello) if self.recorder else None


def _frames(connection: Connection | None) -> int:
    """Frames that a connection has received."""
    return connection.frames if connection else 0
