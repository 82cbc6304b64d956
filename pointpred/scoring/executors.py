"""One function over many items: on threads, on processes, or on a Dask cluster."""

from __future__ import annotations

import logging
import multiprocessing
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    CancelledError,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from itertools import islice
from multiprocessing.connection import wait as wait_for
from threading import Thread
from typing import Any, Protocol, TypeVar

from pointpred.errors import ParameterError
from pointpred.extras import require

Item = TypeVar("Item")
Answer = TypeVar("Answer")

AHEAD = 2
"""Items that wait at each worker: enough that none is idle, few enough for bounded memory."""
LOCAL = "local"
"""In the place of a scheduler's address: a cluster of processes on this machine."""
PATIENCE_S = 15.0
"""How long a scheduler may take to answer."""
WITHOUT_WORKERS_S = 60.0
"""How long a cluster may have no workers while it has work: others may start in their place."""
CHECK_S = 5.0
"""How often it is asked for its workers while no answer comes."""
CLOSE_S = 20.0
"""How long a cluster made here may take to close."""
SETTINGS = {
    "distributed.nanny.pre-spawn-environ.MALLOC_TRIM_THRESHOLD_": 2**28,
    "distributed.nanny.pre-spawn-environ.MALLOC_MMAP_THRESHOLD_": 2**25,
    "distributed.worker.profile.enabled": False,
}
"""Of a cluster made here. By default Dask has workers return memory after every chunk, only to ask for it
again, and look at their stack a hundred times a second: together a quarter to two fifths of their time."""


class Executor(Protocol):
    """Calls one function for many items at once."""

    workers: int
    """How many items are worked on at once."""
    inner_threads: int
    """How many threads the function may use where there is one item only."""

    def each(self, function: Callable[[Item], Answer], items: Iterable[Item]) -> Iterator[tuple[int, Answer]]:
        """The place of each item, from 0, and its answer, as they are done: in no particular order.

        Items are taken as workers become free. The first error that the function raises is raised here; items
        that were not begun are given up then, as when the caller stops. On processes and clusters, function,
        items and answers are pickled, and ParameterError is raised where a process of a pool was killed.
        """
        ...


@contextmanager
def open_executor(
    *, threads: int | None = None, processes: int | None = None, cluster: str | None = None
) -> Iterator[Executor]:
    """Threads, processes, or a Dask cluster by the address of its scheduler; it ends with the block.

    ``threads``, ``processes``: how many, at least 1. ``cluster``: ``"local"`` starts one with a worker a
    processor on this machine. None of them: a thread a processor. Raises ParameterError where more than
    one is given, and where no scheduler answers or one without workers, MissingExtraError where Dask is not
    installed.

    >>> with open_executor(threads=2) as executor:
    ...     sorted(executor.each(abs, [-3, 4]))
    [(0, 3), (1, 4)]
    """
    choices = {"threads": threads, "processes": processes, "cluster": cluster}
    names = [name for name, value in choices.items() if value is not None]
    if len(names) > 1:
        message = f"one of threads, processes and cluster at most, received {' and '.join(names)}"
        raise ParameterError(message, field=names[1], value=choices[names[1]])
    for name, value in (("threads", threads), ("processes", processes)):
        if value is not None and value < 1:
            raise ParameterError(f"{name} must be at least 1, received {value}", field=name, value=value)
    processors = os.cpu_count() or 1
    if cluster is not None:
        with _client(cluster, processors) as client:
            yield Cluster(client)
    elif processes is not None:
        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(processes, mp_context=context, initializer=_stay_with_parent) as workers:
            yield Pool(workers, processes)
    elif (threads or processors) == 1:
        yield Caller()
    else:  # compiled laws run in threads without Python's lock
        with ThreadPoolExecutor(threads or processors) as pool:
            yield Pool(pool, threads or processors)


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


class Cluster:
    """The workers of a Dask cluster.

    Not by ``client.get_executor()``, which prints a traceback for a future that is given up while its answer
    is on its way.
    """

    inner_threads = 1

    def __init__(self, client: Any) -> None:
        self._client = client
        self.workers = sum(client.nthreads().values())

    def each(self, function: Callable[[Item], Answer], items: Iterable[Item]) -> Iterator[tuple[int, Answer]]:
        """As every executor."""
        import distributed

        as_completed: Any = distributed.as_completed
        numbered = enumerate(items)
        places: dict[Any, int] = {}
        answers = as_completed([], raise_errors=False, with_results=True)

        def add(most: int) -> None:
            for place, item in islice(numbered, most):
                future = self._client.submit(function, item, pure=False)
                places[future] = place
                answers.add(future)

        try:
            add(AHEAD * self.workers)
            while places:
                self._wait(answers)
                future, answer = next(answers)
                place = places.pop(future)
                add(1)
                if future.status in ("error", "cancelled"):
                    future.result()  # raises
                yield place, answer
                del future  # the cluster forgets the answer
        except (distributed.KilledWorker, CancelledError) as error:
            message = f"the Dask cluster lost workers, perhaps for lack of memory, or its scheduler: {error}"
            raise ParameterError(message, field="cluster") from error
        finally:
            if places:
                self._client.cancel(list(places))

    def _wait(self, answers: Any) -> None:
        """Wait for an answer; raises ParameterError where the cluster has had no workers for long."""
        arrived, without_s = answers.thread_condition, 0.0
        while True:
            with arrived:
                if arrived.wait_for(answers.has_ready, timeout=CHECK_S):
                    return
            without_s = 0.0 if self._client.nthreads() else without_s + CHECK_S
            if without_s >= WITHOUT_WORKERS_S:
                message = (
                    f"the Dask cluster lost workers, and no other came within {WITHOUT_WORKERS_S:g} s: "
                    "start some with `dask worker`, then score again"
                )
                raise ParameterError(message, field="cluster")


def _stay_with_parent() -> None:
    """Of a process of a pool: leave an interrupt to the parent, and end with it even where it is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        Thread(target=_end_after, args=(parent.sentinel,), daemon=True).start()


def _end_after(sentinel: int) -> None:
    wait_for([sentinel])
    os._exit(1)


@contextmanager
def _client(address: str, workers: int) -> Iterator[Any]:
    """A client of the scheduler at this address; ``local``: of ``workers`` processes made here."""
    require("cluster", "a Dask cluster")
    import dask
    import distributed

    client_of: Any = distributed.Client
    if address == LOCAL:
        with dask.config.set(SETTINGS), _local(workers) as local, client_of(local) as client:
            yield client
        return
    try:
        client = client_of(address, timeout=PATIENCE_S)
    except (OSError, ValueError, TypeError) as error:
        message = (
            f"no Dask scheduler answers at {address!r} within {PATIENCE_S:g} s: {error}; "
            f"expected an address such as tcp://host:8786, or {LOCAL!r}"
        )
        raise ParameterError(message, field="cluster", value=address) from error
    with client:
        if not client.nthreads():
            message = f"the Dask scheduler at {address!r} has no workers: start some with `dask worker`"
            raise ParameterError(message, field="cluster", value=address)
        yield client


@contextmanager
def _local(workers: int) -> Iterator[Any]:
    """A cluster of processes on this machine, closed at the end."""
    import distributed

    local_cluster: Any = distributed.LocalCluster
    local = local_cluster(
        n_workers=workers,
        threads_per_worker=1,
        dashboard_address="127.0.0.1:0",
        memory_limit=0,
        silence_logs=logging.ERROR,
    )
    try:
        yield local
    finally:
        # A worker that is being started again while the cluster closes fails an assertion of Dask's, which
        # would hide why the work ended, or is waited for without end; the rest closes the second time.
        for _ in range(2):
            with suppress(AssertionError, TimeoutError):
                local.close(timeout=CLOSE_S)
