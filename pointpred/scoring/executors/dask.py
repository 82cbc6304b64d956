"""A Dask cluster: one on this machine, or one that runs elsewhere."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from itertools import islice
from typing import Any

from pointpred.errors import ParameterError
from pointpred.extras import require
from pointpred.scoring.executors.executor import AHEAD, Answer, Item

LOCAL = "local"
"""In the place of a scheduler's address: a cluster of processes on this machine."""
PATIENCE_S = 15.0
"""How long a scheduler may take to answer."""
WITHOUT_WORKERS_S = 60.0
"""How long a cluster may have no workers while it has work: others may start in their place."""
SETTINGS = {
    "distributed.nanny.pre-spawn-environ.MALLOC_TRIM_THRESHOLD_": 2**28,
    "distributed.nanny.pre-spawn-environ.MALLOC_MMAP_THRESHOLD_": 2**25,
    "distributed.worker.profile.enabled": False,
}
"""Of a cluster made here. By default Dask has workers return memory after every chunk, only to ask for it
again, and look at their stack a hundred times a second: together a quarter to two fifths of their time."""
CHECK_S = 5.0
"""How often it is asked for its workers while no answer comes."""


class Cluster:
    """The workers of a Dask cluster."""

    def __init__(self, client: Any) -> None:
        self._client = client
        self.workers = sum(client.nthreads().values())
        self.inner_threads = 1

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


@contextmanager
def cluster(address: str, workers: int) -> Iterator[Cluster]:
    """The cluster whose scheduler has this address, or ``local``: one of ``workers`` processes, made here.

    Raises MissingExtraError where Dask is not installed, ParameterError where no scheduler answers, or one
    without workers.
    """
    require("cluster", "a Dask cluster")
    import dask
    import distributed

    client_of: Any = distributed.Client
    if address == LOCAL:
        with dask.config.set(SETTINGS), _local(workers) as local, client_of(local) as client:
            yield Cluster(client)
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
        one = Cluster(client)
        if not one.workers:
            message = f"the Dask scheduler at {address!r} has no workers: start some with `dask worker`"
            raise ParameterError(message, field="cluster", value=address)
        yield one


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
        # would hide why the work ended; the rest of the cluster closes the second time.
        for _ in range(2):
            with suppress(AssertionError):
                local.close()
