"""One process of a machine compiles a part, and the others wait for it: workers start at the same time."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pointpred_server.compiling.parts import Part

if sys.platform != "win32":
    import fcntl


@contextmanager
def compiling_alone(part: Part) -> Iterator[None]:
    """Hold the lock of a part: that of the folder in which its first law is kept.

    The system releases it when the process ends, however it ends. Where there is no such folder, or where
    the system or the file system has no locks, several may compile at once, which costs time only.
    """
    descriptor = _lock(part)
    try:
        yield
    finally:
        if descriptor is not None:
            os.close(descriptor)


def _lock(part: Part) -> int | None:
    """A descriptor that holds the lock until it is closed; waits for it."""
    folder = next((law.stats.cache_path for law in part.laws if law.stats.cache_path), None)
    if folder is None or sys.platform == "win32":
        return None
    try:
        descriptor = os.open(Path(folder), os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return None
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX)
    except OSError:
        os.close(descriptor)
        return None
    return descriptor
