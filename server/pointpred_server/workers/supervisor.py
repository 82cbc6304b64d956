"""Starts the workers of a service, hands them connections, restarts those that end, and stops all.

Workers share the settings and the folder of recordings; a crash of one ends its own sessions only.
"""

from __future__ import annotations

import asyncio
import logging
import signal
import socket
import time
from collections.abc import Callable, Sequence
from contextlib import suppress

from prometheus_client import CollectorRegistry, Counter, Gauge
from prometheus_client.process_collector import ProcessCollector

from pointpred.errors import SourceError
from pointpred_server.settings import Settings
from pointpred_server.workers.counts import CONNECTIONS, SESSIONS, WorkerCounts
from pointpred_server.workers.dispatcher import Dispatcher
from pointpred_server.workers.families import ServiceFamilies, families_of, text_of
from pointpred_server.workers.messages import (
    AskText,
    Collected,
    FromWorker,
    ServiceReady,
    Started,
    Stop,
    Text,
)
from pointpred_server.workers.process import WorkerProcess
from pointpred_server.workers.restarts import Restarts

WATCH_S = 1.0
"""How often each worker is asked for its metrics."""
SILENT_S = 3.0
"""A worker that has not answered for so long is given no connection while others answer."""
HUNG_S = 60.0
"""A worker that has not answered for so long is killed and started again."""
START_S = 120.0
"""The same for a worker that has not answered yet: it imports the package first."""
WATCH_LATE_S = 1.0
"""Where this process is late by more than this, it stood still itself, and heard no answer."""
COLLECT_S = 1.0
"""So long the metrics wait for a worker; then those that it sent last are shown."""
WORKERS_END_S = 10.0
"""Seconds that workers have to end, which end by themselves in less."""
SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))

ORDERED = (0, -signal.SIGTERM)
"""Exit codes of a worker that somebody asked to end: one that serves ends its sessions first."""

log = logging.getLogger("pointpred.service")


class Supervisor:
    """The workers of one service.

    ``on_start`` is called once, when every worker answers.
    """

    def __init__(
        self,
        listening: socket.socket,
        settings: Settings,
        on_start: Callable[[], None],
    ) -> None:
        self.settings = settings.guarded()
        self.workers: dict[int, WorkerProcess] = {}
        """The running workers by number."""
        self._on_start = on_start
        self._ready = False
        self._counts = WorkerCounts(settings.workers, settings.max_sessions)
        self._families = ServiceFamilies()
        self._registry = SupervisorMetrics()
        self._registry.sessions_limit.set(self.settings.max_sessions)
        self._dispatcher = Dispatcher(listening, self._takers)
        self._restarts = [Restarts() for _ in range(settings.workers)]
        self._texts: set[asyncio.Task[None]] = set()
        self._signal: signal.Signals | None = None

    async def run(self) -> signal.Signals | None:
        """Serve until a signal comes, which is returned; raises SourceError where no worker runs for long."""
        loop = asyncio.get_running_loop()
        self._stopping = asyncio.Event()
        for number in SIGNALS:
            loop.add_signal_handler(number, self._stop, number)
        keepers = [loop.create_task(self._keep(number)) for number in range(self.settings.workers)]
        watch = loop.create_task(self._watch())
        self._dispatcher.start()
        try:
            stopped = loop.create_task(self._stopping.wait())
            await asyncio.wait([stopped, watch, *keepers], return_when=asyncio.FIRST_COMPLETED)
        finally:
            self._dispatcher.stop()
            await self._end(keepers)
            watch.cancel()
            for number in SIGNALS:
                loop.remove_signal_handler(number)
        for task in (watch, *keepers):
            if task.done() and not task.cancelled() and (error := task.exception()) is not None:
                raise error
        return self._signal

    def _stop(self, number: signal.Signals) -> None:
        """Stop; a second Ctrl-C ends the workers at once."""
        if self._stopping.is_set() and number is signal.SIGINT:
            for worker in self.workers.values():
                worker.kill()
        self._signal = self._signal or signal.Signals(number)
        self._stopping.set()

    async def _end(self, keepers: Sequence[asyncio.Task[None]]) -> None:
        """Stop every worker, and kill those that do not end."""
        self._stopping.set()
        for worker in self.workers.values():
            worker.send(Stop())
        _, late = await asyncio.wait(keepers, timeout=WORKERS_END_S)
        if late:
            log.error(
                "%d workers had not ended %g s after the stop, and were killed", len(late), WORKERS_END_S
            )
            for worker in self.workers.values():
                worker.kill()
            await asyncio.wait(keepers)

    async def _keep(self, number: int) -> None:
        """Run one worker, and another one in its place when it has ended, until the service stops."""
        restarts = self._restarts[number]
        while not self._stopping.is_set():
            worker = WorkerProcess(number, self._counts, self._observe)
            try:
                running = await worker.start(self.settings.model_dump(mode="json"), self.settings.workers)
            except OSError as error:
                pause_s = restarts.pause_s(0.0)
                log.error("worker %d cannot be started: %s", number, error.strerror)
            else:
                self.workers[number] = worker
                if self._stopping.is_set():  # meanwhile: the others have been asked already
                    worker.send(Stop())
                code = await running
                del self.workers[number]
                self._families.end(str(number))
                self._counts.clear(number)
                if self._stopping.is_set():
                    return
                ordered = code in ORDERED
                pause_s = restarts.pause_s(time.monotonic() - worker.begun_at, ordered=ordered)
                self._report_end(worker, code, pause_s, ordered=ordered)
            if not self.workers and all(each.hopeless for each in self._restarts):
                raise SourceError(
                    "every worker ends soon after its start: see the errors above; "
                    "--workers 1 serves from one process"
                )
            with suppress(TimeoutError):
                async with asyncio.timeout(pause_s):
                    await self._stopping.wait()

    def _report_end(self, worker: WorkerProcess, code: int, pause_s: float, *, ordered: bool) -> None:
        about = (worker.number, worker.pid)
        if ordered:
            self._registry.restarts.labels("stop").inc()
            log.info("worker %d (process %d) was stopped; another one starts in %g s", *about, pause_s)
            return
        self._registry.restarts.labels("crash").inc()
        how = f"by {signal.Signals(-code).name}" if code < 0 else f"with code {code}"
        sentence = "worker %d (process %d) ended %s; its sessions are lost, another one starts in %g s"
        log.error(sentence, *about, how, pause_s)

    def _takers(self) -> list[WorkerProcess]:
        """Who may be given a connection: workers that answer; else any that has started."""
        started = [worker for worker in self.workers.values() if worker.started]
        return [worker for worker in started if worker.silent_s < SILENT_S] or started

    async def _watch(self) -> None:
        """Ask each worker for its metrics again and again; kill one that hangs."""
        while True:
            before = time.monotonic()
            await asyncio.sleep(WATCH_S)
            await self._collect()
            late_s = time.monotonic() - before - WATCH_S - COLLECT_S
            for worker in self.workers.values():
                if late_s > WATCH_LATE_S:
                    worker.excuse(late_s)
                most_s = HUNG_S if worker.started else START_S
                if worker.silent_s > most_s:
                    log.error("worker %d has not answered for %g s and is killed", worker.number, most_s)
                    worker.kill()

    async def _collect(self) -> None:
        started = [worker for worker in self.workers.values() if worker.started]
        await asyncio.gather(*(worker.collect(COLLECT_S) for worker in started))

    def _observe(self, worker: WorkerProcess, message: FromWorker) -> None:
        """What a worker has sent."""
        if isinstance(message, Collected):
            self._families.update(str(worker.number), message.families)
        elif isinstance(message, AskText):
            task = asyncio.get_running_loop().create_task(self._answer(worker))
            self._texts.add(task)
            task.add_done_callback(self._texts.discard)
        elif isinstance(message, Started):
            self._advance(worker)

    def _advance(self, worker: WorkerProcess) -> None:
        """Say once that all answer."""
        if self._ready:
            worker.send(ServiceReady())
        workers = self.workers.values()
        complete = len(workers) == self.settings.workers
        if not self._ready and complete and all(each.started for each in workers):
            self._ready = True
            for each in workers:
                each.send(ServiceReady())
            self._on_start()

    async def _answer(self, worker: WorkerProcess) -> None:
        """Send the metrics of all workers to one of them, which was asked for them."""
        await self._collect()
        own = families_of(self._registry.update(self._counts, len(self.workers)))
        self._families.update("supervisor", own)
        worker.send(Text(text_of(self._families.merged())))


class SupervisorMetrics:
    """What the supervisor counts itself."""

    def __init__(self) -> None:
        self.registry = CollectorRegistry()
        ProcessCollector(registry=self.registry)
        self.sessions_limit = Gauge(
            "pointpred_sessions_limit", "Sessions that may be open at a time", registry=self.registry
        )
        self.workers = Gauge("pointpred_workers", "Workers that run now", registry=self.registry)
        self.restarts = Counter(
            "pointpred_worker_restarts",
            "Workers that ended and were started again, by how they ended: crash or stop",
            ["reason"],
            registry=self.registry,
        )
        for reason in ("crash", "stop"):
            self.restarts.labels(reason)
        self.sessions = Gauge(
            "pointpred_worker_sessions", "Sessions now, by worker", ["worker"], registry=self.registry
        )
        self.connections = Gauge(
            "pointpred_worker_connections", "Connections now, by worker", ["worker"], registry=self.registry
        )

    def update(self, counts: WorkerCounts, workers: int) -> CollectorRegistry:
        """The registry, with the state of the workers."""
        self.workers.set(workers)
        for number, row in enumerate(counts.rows):
            self.sessions.labels(str(number)).set(row[SESSIONS])
            self.connections.labels(str(number)).set(row[CONNECTIONS])
        return self.registry


def supervise(supervisor: Supervisor) -> None:
    """Run the workers until a signal comes, and end by that signal as a service without workers does."""
    number = asyncio.run(supervisor.run())
    if number is not None:
        signal.raise_signal(number)
