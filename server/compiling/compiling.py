"""Compiling beside answering: threads that let worker processes compile, and load what these have compiled.

Nothing of it runs on the event loop. Where everything is in the cache, it is only loaded.
"""

from __future__ import annotations

import asyncio
import logging
import os
import threading
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress

from msgspec import Struct

from pointpred.registry import RECOMMENDED, REGISTRY
from pointpred.server.compiling.order import Order
from pointpred.server.compiling.parts import FIRST, Part, parts
from pointpred.server.compiling.worker import ASIDE, Worker
from pointpred.server.logs import place_of

log = logging.getLogger("pointpred.service")

WORKERS = 2
REPLACEMENTS = 2
"""Workers that may take the place of one that has ended; after them parts are compiled by this process."""


class Progress(Struct, frozen=True):
    """How far compiling is: predictors that are compiled, of how many, what is under way, which are ready."""

    done: int
    of: int
    next: str | None
    ready: list[str]
    recommended: str = RECOMMENDED


class Compiling:
    """What is compiled, what comes next, and who waits for it."""

    def __init__(self, all: Sequence[Part] | None = None, worker: Callable[[], Worker] = Worker) -> None:
        self._order = Order(parts() if all is None else all, FIRST)
        self._worker = worker
        self._changed = threading.Condition()
        self._loading = threading.Lock()
        self._waiting: set[tuple[asyncio.AbstractEventLoop, asyncio.Event]] = set()
        self._lanes: list[threading.Thread] = []
        self._workers: list[Worker] = []
        self._replacements = REPLACEMENTS
        self._alone = False  # whether parts are compiled by this process, without workers
        self._telling = threading.Lock()
        self._logged: set[str] = set()
        self._began = 0.0
        self.stopped = False
        self.failed: set[str] = set()
        """Parts that raised when they were run; clients are served all the same."""
        self.once = False
        """Whether something had to be compiled, rather than loaded."""
        self.tell: Callable[[Progress], None] = lambda progress: None
        """Called by other threads when something is under way or done."""
        self.on_ready: Callable[[], None] = lambda: None
        """Called by another thread when the recommended predictor is compiled."""

    def begin(self) -> None:
        """Compile in threads of their own, from now on."""
        self._began = time.monotonic()
        for number in range(min(WORKERS, _processors())):
            lane = threading.Thread(target=self._run, name=f"compiling {number}", daemon=True)
            self._lanes.append(lane)
            lane.start()

    def stop(self) -> None:
        """Give up what is under way and begin nothing further; nobody waits any more."""
        with self._changed:
            self.stopped = True
            for worker in self._workers:
                worker.kill()
            self._notify()

    def join(self) -> None:
        """Wait until all is done."""
        for lane in self._lanes:
            lane.join()

    @property
    def over(self) -> bool:
        """Whether nobody has to wait: nothing has begun, all is done, or the service stops."""
        return not self._lanes or self.stopped or self._order.finished

    def ready(self, name: str) -> bool:
        """Whether a part is compiled."""
        return name in self._order.done and name not in self.failed

    def missing(self, names: Iterable[str]) -> list[str]:
        """Parts that somebody who needs these has to wait for."""
        with self._changed:
            return [] if self.over else self._order.missing(names)

    async def until(self, names: Sequence[str]) -> None:
        """Wait until these are compiled, or cannot be; they are next."""
        if not (names := self.missing(names)):
            return
        event = asyncio.Event()
        waiting = (asyncio.get_running_loop(), event)
        with self._changed:
            self._order.wish(names)
            self._waiting.add(waiting)
        try:
            while self.missing(names):
                await event.wait()
                event.clear()
        finally:
            with self._changed:
                self._waiting.discard(waiting)

    def progress(self) -> Progress:
        """How far it is."""
        with self._changed:
            order = self._order
            ready = [name for name in REGISTRY if self.ready(name)]
            first = [RECOMMENDED] if any(name in FIRST for name in order.missing(FIRST)) else []
            under_way = next(iter([*first, *order.under_way]), None)
            return Progress(len(ready), len(REGISTRY), None if self.over else under_way, ready)

    def _run(self) -> None:
        """One lane: part after part, with a worker where something is to be compiled."""
        worker: Worker | None = None
        while (part := self._next()) is not None:
            try:
                if part.awaits:
                    self.once = True
                    self._say()
                    worker = self._compiled_by(worker, part.name)
                if not self.stopped:
                    with self._loading:
                        part.run()
            except Exception as error:
                self.failed.add(part.name)
                log.error("%s could not be compiled", part.name, extra={"error": place_of(error)})
            self._finish(part)
        if worker is not None:
            worker.end()

    def _compiled_by(self, worker: Worker | None, name: str) -> Worker | None:
        """The worker that has compiled a part; ``None`` where there is none, and this thread has to."""
        while worker := worker or self._helped():
            if name not in FIRST:
                worker.compile(ASIDE)
            if worker.compile(name) or self.stopped:
                return worker
            worker.end()
            worker = None
            self._lament("a process that compiles has ended")
        return None

    def _helped(self) -> Worker | None:
        """A worker, which is ended when all is done or the service stops; ``None`` where none can be had."""
        if self._alone:
            return None
        try:
            worker = self._worker()
        except OSError as error:
            self._lament("no process that compiles can be started", place_of(error), most=0)
            return None
        with self._changed:
            self._workers.append(worker)
            if self.stopped:
                worker.kill()
        return worker

    def _lament(self, what: str, error: str | None = None, most: int = REPLACEMENTS) -> None:
        """Log a lost worker, and whether another one takes its place."""
        with self._changed:
            if self._alone:
                return
            self._replacements = min(self._replacements, most) - 1
            self._alone = self._replacements < 0
        about = {"error": error} if error else {}
        instead = "this process compiles the rest itself" if self._alone else "another one takes its place"
        log.warning("%s; %s", what, instead, extra=about)

    def _next(self) -> Part | None:
        with self._changed:
            while not self.stopped and self._order.waiting:
                if (part := self._order.take()) is not None:
                    return part
                self._changed.wait()
            return None

    def _finish(self, part: Part) -> None:
        with self._changed:
            self._order.finish(part.name)
            last = self._order.finished and not self.stopped
            self._notify()
        if part.name == RECOMMENDED and self.ready(RECOMMENDED) and not self.stopped:
            self.on_ready()
        self._say()
        if self.once and last:
            log.info("Compiled, in %.1f s", time.monotonic() - self._began)

    def _say(self) -> None:
        """Tell how far it is: each step once in the log, and in order, whichever lane it is."""
        with self._telling:
            progress = self.progress()
            if self.once and progress.next is not None and progress.next not in self._logged:
                self._logged.add(progress.next)
                log.info("Compiling once: %d of %d, %s", progress.done, progress.of, progress.next)
            self.tell(progress)

    def _notify(self) -> None:
        """Wake who waits, in this thread's lanes and on event loops."""
        self._changed.notify_all()
        for loop, event in self._waiting:
            with suppress(RuntimeError):  # its loop has closed: nobody waits there
                loop.call_soon_threadsafe(event.set)


def _processors() -> int:
    """How many this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def compile_all() -> None:
    """Compile everything that the service may run, and wait for it."""
    compiling = Compiling()
    compiling.begin()
    compiling.join()
