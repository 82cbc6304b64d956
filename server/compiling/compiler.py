"""Compiling in the background: threads that have other processes compile, and load the result.

Nothing of this runs on the event loop. Where everything is in the cache, it is only loaded.
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
from pointpred_server.compiling.alone import compiling_alone
from pointpred_server.compiling.order import PartQueue
from pointpred_server.compiling.parts import FIRST, Part, parts
from pointpred_server.compiling.process import LOW_PRIORITY, CompilerProcess
from pointpred_server.logs import place_of

log = logging.getLogger("pointpred.service")

PROCESSES = 2
REPLACEMENTS = 2
"""Processes that may replace one that has ended; after them this process compiles by itself."""


class Progress(Struct, frozen=True):
    """How many predictors are compiled, of how many, what is compiled now, and which are ready."""

    done: int
    of: int
    next: str | None
    ready: list[str]
    recommended: str = RECOMMENDED


class Compiler:
    """What is compiled, what is next, and who waits for it."""

    def __init__(
        self,
        all: Sequence[Part] | None = None,
        start_process: Callable[[], CompilerProcess] = CompilerProcess,
    ) -> None:
        self._queue = PartQueue(parts() if all is None else all, FIRST)
        self._start_process = start_process
        self._changed = threading.Condition()
        self._loading = threading.Lock()
        self._waiting: set[tuple[asyncio.AbstractEventLoop, asyncio.Event]] = set()
        self._threads: list[threading.Thread] = []
        self._processes: list[CompilerProcess] = []
        self._replacements = REPLACEMENTS
        self._alone = False  # whether parts are compiled by this process itself
        self._progress_lock = threading.Lock()
        self._logged: set[str] = set()
        self._began = 0.0
        self.stopped = False
        self.failed: set[str] = set()
        """Parts that raised when they were run; clients are served all the same."""
        self.compiled_any = False
        """Whether something had to be compiled, rather than loaded."""
        self.on_progress: Callable[[Progress], None] = lambda progress: None
        """Called by other threads when a part begins or is done; never where everything is only loaded."""
        self.on_ready: Callable[[], None] = lambda: None
        """Called by another thread when the recommended predictor is compiled."""

    def start(self) -> None:
        """Compile in threads, from now on."""
        self._began = time.monotonic()
        for number in range(min(PROCESSES, _processors())):
            thread = threading.Thread(target=self._run, name=f"compiling {number}", daemon=True)
            self._threads.append(thread)
            thread.start()

    def stop(self) -> None:
        """Kill the processes and begin nothing further; nobody waits any more."""
        with self._changed:
            self.stopped = True
            for process in self._processes:
                process.kill()
            self._notify()

    def join(self) -> None:
        """Wait until all is done."""
        for thread in self._threads:
            thread.join()

    @property
    def over(self) -> bool:
        """Whether nobody has to wait: compiling has not begun, has ended, or the service stops."""
        return not self._threads or self.stopped or self._queue.finished

    def ready(self, name: str) -> bool:
        """Whether a part is compiled."""
        return name in self._queue.done and name not in self.failed

    def missing(self, names: Iterable[str]) -> list[str]:
        """Those of the parts that are not compiled yet."""
        with self._changed:
            return [] if self.over else self._queue.missing(names)

    async def until(self, names: Sequence[str]) -> None:
        """Wait until these parts are compiled, or have failed; they are compiled next."""
        if not (names := self.missing(names)):
            return
        event = asyncio.Event()
        waiting = (asyncio.get_running_loop(), event)
        with self._changed:
            self._queue.prefer(names)
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
            queue = self._queue
            ready = [name for name in REGISTRY if self.ready(name)]
            first = [RECOMMENDED] if any(name in FIRST for name in queue.missing(FIRST)) else []
            under_way = next(iter([*first, *queue.under_way]), None)
            return Progress(len(ready), len(REGISTRY), None if self.over else under_way, ready)

    def _run(self) -> None:
        """One thread: part after part, with a process where something is to be compiled."""
        process: CompilerProcess | None = None
        while (part := self._next()) is not None:
            try:
                if part.awaits:
                    with compiling_alone(part):
                        process = self._compile_missing(process, part)
                if not self.stopped:
                    with self._loading:
                        part.run()
            except Exception as error:  # logged; the other parts are compiled all the same
                self.failed.add(part.name)
                log.error("%s could not be compiled", part.name, extra={"error": place_of(error)})
            self._finish(part)
        if process is not None:
            process.end()

    def _compile_missing(self, process: CompilerProcess | None, part: Part) -> CompilerProcess | None:
        """Compile a part, unless another process has done so meanwhile; returns as ``_compile`` does."""
        if self.stopped or not part.awaits:
            return process
        self.compiled_any = True
        self._report()
        return self._compile(process, part.name)

    def _compile(self, process: CompilerProcess | None, name: str) -> CompilerProcess | None:
        """Have a process compile a part; returns the process, ``None`` where this thread has to compile."""
        while process := process or self._new_process():
            if name not in FIRST:
                process.compile(LOW_PRIORITY)
            if process.compile(name) or self.stopped:
                return process
            process.end()
            process = None
            self._log_lost_process("a compiling process has ended")
        return None

    def _new_process(self) -> CompilerProcess | None:
        """A process, which ends when all is done or the service stops; ``None`` where none can be started."""
        if self._alone:
            return None
        try:
            process = self._start_process()
        except OSError as error:
            self._log_lost_process("no compiling process can be started", place_of(error), most=0)
            return None
        with self._changed:
            self._processes.append(process)
            if self.stopped:
                process.kill()
        return process

    def _log_lost_process(self, what: str, error: str | None = None, most: int = REPLACEMENTS) -> None:
        """Log that a process was lost, and whether another one replaces it."""
        with self._changed:
            if self._alone:
                return
            self._replacements = min(self._replacements, most) - 1
            self._alone = self._replacements < 0
        about = {"error": error} if error else {}
        instead = "this process compiles the rest itself" if self._alone else "another one replaces it"
        log.warning("%s; %s", what, instead, extra=about)

    def _next(self) -> Part | None:
        with self._changed:
            while not self.stopped and self._queue.waiting:
                if (part := self._queue.take()) is not None:
                    return part
                self._changed.wait()
            return None

    def _finish(self, part: Part) -> None:
        with self._changed:
            self._queue.finish(part.name)
            last = self._queue.finished and not self.stopped
            self._notify()
        if part.name == RECOMMENDED and self.ready(RECOMMENDED) and not self.stopped:
            self.on_ready()
        self._report()
        if self.compiled_any and last:
            log.info("Compiled, in %.1f s", time.monotonic() - self._began)

    def _report(self) -> None:
        """Report the progress; each step is logged once, and in order, whichever thread makes it."""
        with self._progress_lock:
            progress = self.progress()
            if self.compiled_any and progress.next is not None and progress.next not in self._logged:
                self._logged.add(progress.next)
                log.info("Compiling once: %d of %d, %s", progress.done, progress.of, progress.next)
            if self.compiled_any:
                self.on_progress(progress)

    def _notify(self) -> None:
        """Wake the threads and the event loops that wait."""
        self._changed.notify_all()
        for loop, event in self._waiting:
            with suppress(RuntimeError):  # its loop has closed: nobody waits there
                loop.call_soon_threadsafe(event.set)


def _processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def compile_all() -> None:
    """Compile everything that the service may run, and wait for it."""
    compiler = Compiler()
    compiler.start()
    compiler.join()
