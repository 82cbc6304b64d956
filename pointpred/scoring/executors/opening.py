"""The executor that settings ask for."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from pointpred.errors import ParameterError
from pointpred.scoring.executors.executor import Executor
from pointpred.scoring.executors.local import Caller, Pool
from pointpred.scoring.executors.local import processes as pool_of_processes
from pointpred.scoring.executors.local import threads as pool_of_threads


@contextmanager
def open_executor(
    *, threads: int | None = None, processes: int | None = None, cluster: str | None = None
) -> Iterator[Executor]:
    """Threads, processes, or a Dask cluster by the address of its scheduler; it ends with the block.

    ``threads``, ``processes``: how many, at least 1. ``cluster``: ``"local"`` starts one with a worker a
    processor on this machine. None of them: a thread a processor. Raises ParameterError where more than
    one is given, and what ``cluster`` raises.

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
        from pointpred.scoring.executors.dask import cluster as open_cluster

        with open_cluster(cluster, processors) as one:
            yield one
    elif processes is not None:
        with pool_of_processes(processes) as workers:
            yield Pool(workers, processes)
    elif (threads or processors) == 1:
        yield Caller()
    else:
        with pool_of_threads(threads or processors) as pool:
            yield Pool(pool, threads or processors)
