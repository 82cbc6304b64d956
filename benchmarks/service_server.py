"""The server under measurement, in a process of its own: the service's endpoint, and an echo beside it.

The echo exists here only. It answers each frame of events with the frame itself, by the same endpoint, the
same connection code and the same outbox; what it leaves out is decoding, limits and prediction.
"""

from __future__ import annotations

from starlette.routing import WebSocketRoute

from pointpred.server.access import HostRule
from pointpred.server.compiling.compiler import compile_all
from pointpred.server.endpoints import StreamEndpoint
from pointpred.server.garbage import tune_collector
from pointpred.server.listening import listen, make_server
from pointpred.server.service import Service
from pointpred.server.sessions.pointing import PointingSession
from pointpred.server.settings import Settings


class Echo(PointingSession):
    """Says hello, then sends back what comes."""

    def receive(self, frame: str | bytes, now: float) -> None:
        """Answer with the frame itself."""
        if self.state != "greeted" or frame == '{"type":"reset"}':
            super().receive(frame, now)
        else:
            self.outbox.predict([frame], 1)


class EchoService(Service):
    """Opens echoes."""

    def open(self, now: float) -> PointingSession:
        """An echo in the place of a session."""
        session = super().open(now)
        session.__class__ = Echo
        return session


def main() -> None:
    """Listen on a free port, print it once everything is compiled, and serve until killed."""
    settings = Settings(max_events_per_s=10**8, max_sessions=1000)
    service, echoes = Service(settings), EchoService(settings)
    opened = listen("127.0.0.1", 0)
    compile_all()

    def announce() -> None:
        print(opened.getsockname()[1], flush=True)

    server = make_server(HostRule(), service, announce)
    server.config.app.router.routes.append(WebSocketRoute("/v1/echo", StreamEndpoint(echoes)))
    tune_collector()  # as ``pointpred serve`` does
    server.run([opened])


if __name__ == "__main__":
    main()
