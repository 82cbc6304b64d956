"""Tables in memory that all workers share: how many sessions and connections each of them has, and of whom.

Each worker writes its own row, and reads the others': the bounds on sessions hold for the whole service
without a message.
"""

from __future__ import annotations

import mmap
import os
import tempfile

import numpy as np

SESSIONS, CONNECTIONS, TAKEN = range(3)
"""Columns: sessions now, connections now, connections that the worker was handed since it started."""
COLUMNS = 3


class WorkerCounts:
    """Rows of whole numbers, one a worker; ``descriptor`` is the file behind them, for another process.

    ``networks`` has a column for each of the most sessions at a time: what ``NetworkCounts`` writes.
    """

    def __init__(self, workers: int, max_sessions: int, descriptor: int | None = None) -> None:
        columns = COLUMNS + max_sessions
        size = workers * columns * np.dtype(np.int64).itemsize
        self.descriptor = _anonymous_file(size) if descriptor is None else descriptor
        self._memory = mmap.mmap(self.descriptor, size)
        table = np.frombuffer(self._memory, np.int64).reshape(workers, columns)
        self.rows, self.networks = table[:, :COLUMNS], table[:, COLUMNS:]

    def clear(self, worker: int) -> None:
        """A worker has ended, and its connections with it."""
        self.rows[worker] = 0
        self.networks[worker] = 0

    @property
    def sessions(self) -> int:
        """Sessions of all workers."""
        return int(self.rows[:, SESSIONS].sum())


def _anonymous_file(size: int) -> int:
    """A file without a name: in memory where the system has such, else in the temporary folder."""
    if hasattr(os, "memfd_create"):
        descriptor = os.memfd_create("pointpred-workers")
    else:
        with tempfile.TemporaryFile() as file:
            descriptor = os.dup(file.fileno())
    os.ftruncate(descriptor, size)
    return descriptor
