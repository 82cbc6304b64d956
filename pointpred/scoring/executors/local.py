"""Threads and processes of this machine."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from multiprocessing.connection import wait as wait_for
from threading import Thread

from pointpred.errors import ParameterError
from pointpred.scoring.executors.executor import AHEAD, Answer, Item


class Caller:
    """No pool at all: the thread that asks does the work. A pool of one costs more than a short trial."""

    workers = 1
    inner_threads = 1

    def each(self, function: Callable[[Item], Answer], items: Iterable[Item]) -> Iterator[tuple[int, Answer]]:
        """As every executor."""
        return enumerate(map(function, items))


class Pool:
    """The threads or processes of a pool of the standard library."""

    def __init__(self, pool: ThreadPoolExecutor | ProcessPoolExecutor, workers: int) -> None:
        self._pool = pool
        self.workers = workers
        self.inner_threads = workers

    def each(self, function: Callable[[Item], Answer], items: Iterable[Item]) -> Iterator[tuple[int, Answer]]:
        """As every executor."""
        waiting: dict[Future[Answer], int] = {}
        numbered = enumerate(items)

        def add(most: int) -> None:
            for place, item in islice(numbered, most):
                waiting[self._pool.submit(function, item)] = place

        try:
            add(AHEAD * self.workers)
            while waiting:
                for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                    place = waiting.pop(future)
                    add(1)
                    yield place, future.result()
        except BrokenProcessPool as error:
            message = "one of the processes was killed, perhaps because memory ran out: use fewer, or threads"
            raise ParameterError(message, field="processes", value=self.workers) from error
        finally:
            for future in waiting:
                future.cancel()


def threads(workers: int) -> ThreadPoolExecutor:
    """A pool of threads: compiled laws run in them without Python's lock."""
    return ThreadPoolExecutor(workers)


def processes(workers: int) -> ProcessPoolExecutor:
    """A pool of processes, each a new Python."""
    context = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, mp_context=context, initializer=_stay_with_parent)


def _stay_with_parent() -> None:
    """Leave an interrupt to the parent, and end with it even where it is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        Thread(target=_end_after, args=(parent.sentinel,), daemon=True).start()


def _end_after(sentinel: int) -> None:
    wait_for([sentinel])
    os._exit(1)
