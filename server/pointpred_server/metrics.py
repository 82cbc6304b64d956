"""What the service counts and times, for Prometheus: nothing about where anybody pointed."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from itertools import accumulate

from prometheus_client import CollectorRegistry, Counter, Gauge, start_http_server
from prometheus_client.core import HistogramMetricFamily
from prometheus_client.platform_collector import PlatformCollector
from prometheus_client.process_collector import ProcessCollector
from prometheus_client.registry import Collector

from pointpred_server.sessions.lifecycle import Session

BUCKETS = (5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.5, 1.0)


class Delays(Collector):
    """A histogram of the delay of predictions, for one thread: in a fifth of the library's own time."""

    def __init__(self) -> None:
        self._counts = [0] * (len(BUCKETS) + 1)
        self._total_s = 0.0

    def observe(self, delay_s: float) -> None:
        """Count a prediction."""
        self._counts[bisect_left(BUCKETS, delay_s)] += 1
        self._total_s += delay_s

    def collect(self) -> Iterator[HistogramMetricFamily]:
        """The counts up to each bound."""
        bounds = [*map(str, BUCKETS), "+Inf"]
        yield HistogramMetricFamily(
            "pointpred_event_to_prediction_seconds",
            "From the time that a frame was read to its prediction handed to the socket; the time that it "
            "waited to be read is not in it",
            list(zip(bounds, accumulate(self._counts), strict=True)),
            self._total_s,
        )


class Metrics:
    """Counters of one service, in a registry of their own; any thread may read them."""

    def __init__(self, max_sessions: int) -> None:
        self.registry = CollectorRegistry()
        ProcessCollector(registry=self.registry)
        PlatformCollector(registry=self.registry)
        self.delays = Delays()
        self.registry.register(self.delays)
        self.sessions = Gauge("pointpred_sessions", "Sessions now", registry=self.registry)
        limit = Gauge(
            "pointpred_sessions_limit", "Sessions that may be open at a time", registry=self.registry
        )
        limit.set(max_sessions)
        self.ended = Counter(
            "pointpred_sessions_ended",
            "Sessions that ended, by close code; 1006: the connection was lost",
            ["code"],
            registry=self.registry,
        )
        self.events = Counter("pointpred_events", "Events taken in", registry=self.registry)
        self.frames = Counter("pointpred_frames", "Frames received", registry=self.registry)
        self.predictions = Counter(
            "pointpred_predictions",
            "Predictions made for clients, dropped ones included",
            registry=self.registry,
        )
        self.refused = Counter(
            "pointpred_refused", "Frames and events refused, by error code", ["code"], registry=self.registry
        )
        self.connections_refused = Counter(
            "pointpred_connections_refused",
            "Connections and requests refused before anything was read, by error code: a foreign host or "
            "origin, no token, too many sessions, a path where there is no WebSocket",
            ["code"],
            registry=self.registry,
        )
        self.dropped = Counter(
            "pointpred_predictions_dropped",
            "Predictions that gave way to newer ones because a client did not read",
            registry=self.registry,
        )
        self.lost = Counter(
            "pointpred_recorder_events_lost",
            "Events and ends of trials that could not be written: the disk was full or too slow",
            registry=self.registry,
        )
        self.failed = Counter(
            "pointpred_recordings_failed",
            "Sessions whose recording ended with an error, which is in the log",
            registry=self.registry,
        )
        self.waiting = Gauge(
            "pointpred_recorder_events_waiting", "Events that wait to be written", registry=self.registry
        )
        self._recorded = (0, 0)

    def update_recorder(self, lost: int, failures: int, waiting: int) -> None:
        """Set what the recorder has lost, how many recordings failed, and what waits."""
        before_lost, before_failures = self._recorded
        self.lost.inc(lost - before_lost)
        self.failed.inc(failures - before_failures)
        self.waiting.set(waiting)
        self._recorded = lost, failures

    def update_session(self, session: Session, frames: int, counts: SessionCounts) -> None:
        """Count what a session has done since the last update; ``frames``: those of its whole life."""
        self.frames.inc(frames - counts.frames)
        self.predictions.inc(session.outbox.predictions - counts.predictions)
        counts.frames, counts.predictions = frames, session.outbox.predictions
        self.events.inc(session.events - counts.events)
        counts.events = session.events
        self.dropped.inc(session.outbox.dropped_total - counts.dropped)
        counts.dropped = session.outbox.dropped_total
        for code, count in session.refusals.items():
            self.refused.labels(code).inc(count - counts.refused.get(code, 0))
            counts.refused[code] = count

    def serve(self, port: int) -> int:
        """Answer Prometheus on a port of this machine's own, 0 for any free one; the port. Raises OSError."""
        server, _ = start_http_server(port, addr="127.0.0.1", registry=self.registry)
        return server.server_port


class SessionCounts:
    """How much of a session is already counts."""

    def __init__(self) -> None:
        self.frames = 0
        self.events = 0
        self.predictions = 0
        self.dropped = 0
        self.refused: dict[str, int] = {}
