"""Everything that one running service holds: its settings, its sessions, its counters."""

from __future__ import annotations

import asyncio
import logging
import secrets
from concurrent.futures import ThreadPoolExecutor

from pointpred.protocol.client_messages import Hello
from pointpred.registry import RECOMMENDED
from pointpred.server.compiling.compiling import Compiling
from pointpred.server.connections.talk import Talk
from pointpred.server.live.feed import LiveFeed
from pointpred.server.live.viewer import Viewer
from pointpred.server.metrics import Counted, Metrics
from pointpred.server.origins import RefusedOrigins
from pointpred.server.recorder.recorder import Recorder
from pointpred.server.sessions.conversation import Conversation
from pointpred.server.sessions.session import Session
from pointpred.server.sessions.watch import Watch
from pointpred.server.settings import Settings

log = logging.getLogger("pointpred.service")

LOST = 1006
"""How the counters name the end of a session whose connection was lost: a tab was closed, a process ended."""


class Service:
    """Opens sessions, knows those that are open, and stops them."""

    def __init__(self, settings: Settings | None = None) -> None:
        self.settings = (settings or Settings()).guarded()
        self.metrics = Metrics()
        self.recorder = Recorder(self.settings.record) if self.settings.record else None
        self.origins = RefusedOrigins()
        self.stopping = False
        self.compiling = Compiling()
        """What is compiled while the service answers."""
        self.scoring = asyncio.Semaphore(1)
        """Recordings are scored one at a time."""
        self.uploads = 0
        """Recordings that are received, wait to be scored or are scored."""
        self.scorer = ThreadPoolExecutor(1, "trials")
        """Scores the trials of sessions, one at a time."""
        self.live: LiveFeed | None = None
        """What the attached device says, where one is."""
        self._open: dict[Conversation, tuple[Talk | None, Counted]] = {}

    @property
    def ready(self) -> bool:
        """Whether the recommended predictor answers at once."""
        return self.compiling.ready(RECOMMENDED) and not self.stopping

    @property
    def full(self) -> bool:
        """Whether no further session is admitted."""
        return len(self._open) >= self.settings.max_sessions

    def open(self, now: float) -> Session:
        """A session without a name that means anything."""
        settings = self.settings
        session = Session(secrets.token_hex(8), settings.limits, now, self._watch, settings.coefficients)
        self._opened(session)
        return session

    def view(self, now: float) -> Viewer:
        """Somebody who looks at the attached device; counts as a session."""
        viewer = Viewer(secrets.token_hex(8), self.settings.limits, now)
        self._opened(viewer)
        return viewer

    def _opened(self, session: Conversation) -> None:
        self._open[session] = (None, Counted())
        self.metrics.sessions.set(len(self._open))
        log.info("session opened", extra={"session": session.name})

    def attach(self, session: Conversation, talk: Talk) -> None:
        """Name the connection that is woken when the service stops."""
        self._open[session] = (talk, self._open[session][1])

    def closed(self, session: Conversation) -> None:
        """A session has ended."""
        talk, counted = self._open.pop(session)
        self.metrics.settle(session, _frames(talk), counted)
        self.metrics.sessions.set(len(self._open))
        code = session.close.code if session.close else LOST
        self.metrics.ended.labels(str(code)).inc()
        about = {"session": session.name, "events": counted.events}
        if code == LOST:
            log.info("session closed: the client went away", extra=about)
        else:
            log.info("session closed", extra={**about, "code": code})

    def refuse_origin(self, origin: str | None) -> None:
        """A page of another site was turned away: counted, and logged once an origin."""
        self.metrics.turned_away.labels("unauthorized").inc()
        self.origins.note(origin)

    def settle(self) -> None:
        """Bring the counters up to date with the open sessions and the recorder."""
        if (recorder := self.recorder) is not None:
            self.metrics.settle_recorder(recorder.lost, recorder.failures, recorder.waiting)
        for session, (talk, counted) in self._open.items():
            self.metrics.settle(session, _frames(talk), counted)

    def begin(self) -> None:
        """Compile beside answering; the first start ever takes a while."""
        if self.live is not None:
            self.live.begin(asyncio.get_running_loop())
        self.compiling.begin()

    def stop(self, reason: str = "the server stops") -> None:
        """Say bye to every session; new ones are refused."""
        self.stopping = True
        self.compiling.stop()
        for session, (talk, _) in list(self._open.items()):
            session.stop(reason)
            if talk is not None:
                talk.wake()

    def end(self) -> None:
        """Write what is recorded; the service is over."""
        self.scorer.shutdown(wait=False, cancel_futures=True)
        if self.recorder is not None:
            self.recorder.close()

    def _watch(self, name: str, hello: Hello) -> Watch | None:
        return self.recorder.open(name, hello) if self.recorder else None


def _frames(talk: Talk | None) -> int:
    """Frames that a connection has brought."""
    return talk.frames if talk else 0
