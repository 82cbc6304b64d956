"""The C library's allocator in a process that serves for weeks: it gives back what is free."""

from __future__ import annotations

import ctypes
import sys

TRIM_THRESHOLD, MMAP_THRESHOLD, MOST_ARENAS = -1, -3, -8
"""Parameters of glibc's mallopt(3)."""
FREE_BYTES = 2**20
"""Free memory at an end of the heap that is kept, and the size from which memory is mapped for itself."""
ARENAS = 2


def bound_free_memory() -> None:
    """Keep at most 1 MiB of free memory at the end of a heap, and two heaps for all threads, with glibc.

    By default glibc maps less memory for itself after each large block that is freed, up to 32 MiB, and keeps
    twice as much free: a service then grows by a step long after its start. Elsewhere this does nothing.
    To be called before threads start.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None) if sys.platform == "linux" else None
    if mallopt is None:
        return
    for parameter, value in (
        (TRIM_THRESHOLD, FREE_BYTES),
        (MMAP_THRESHOLD, FREE_BYTES),
        (MOST_ARENAS, ARENAS),
    ):
        mallopt(parameter, value)
