"""Memory of a process that serves for weeks: what is free goes back, and nothing grows in steps."""

from __future__ import annotations

import ctypes
import sys

TRIM_THRESHOLD, MMAP_THRESHOLD, MOST_ARENAS = -1, -3, -8
"""Parameters of glibc's mallopt(3)."""
FREE_BYTES = 2**20
"""Free memory at an end of the heap that is kept, and the size from which memory is mapped for itself."""
ARENAS = 2
HUGE_PAGES_OFF = 41
"""PR_SET_THP_DISABLE of Linux's prctl(2)."""


def bound_free_memory() -> None:
    """Keep at most 1 MiB of free memory at the end of a heap, two heaps for all threads, and no huge pages.

    By default glibc maps less memory for itself after each large block that is freed, up to 32 MiB, and keeps
    twice as much free: a service then grows by a step long after its start. Arrow asks Linux for huge pages
    of 2 MiB; it then has some 50 MB where it uses 5, and the kernel merges or splits them whenever it likes.

    Linux only, elsewhere this does nothing. To be called before threads start; child processes inherit the
    huge pages' setting, not the others.
    """
    library = ctypes.CDLL(None) if sys.platform == "linux" else None
    if library is None:
        return
    library.prctl(HUGE_PAGES_OFF, 1, 0, 0, 0)
    mallopt = getattr(library, "mallopt", None)
    if mallopt is None:  # not glibc
        return
    for parameter, value in (
        (TRIM_THRESHOLD, FREE_BYTES),
        (MMAP_THRESHOLD, FREE_BYTES),
        (MOST_ARENAS, ARENAS),
    ):
        mallopt(parameter, value)
