"""Which cores the servers and the load generator run on."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

CORES = sorted(os.sched_getaffinity(0))
FIRST, LAST, ALL = {CORES[0]}, {CORES[-1]}, set(CORES)
"""The core of a server, that of the load generator, which is another where there are two, and all of them."""


@contextmanager
def on_cores(cores: set[int]) -> Iterator[None]:
    """Processes that are started meanwhile run on these cores only."""
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, cores)
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)
