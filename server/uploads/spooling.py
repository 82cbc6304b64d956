"""A posted recording as a file that readers can open, where a file system that takes no files allows none."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from pointpred.server.uploads.unpacking import PARQUET

NAME = "recording"


@contextmanager
def spooled(body: bytes) -> Iterator[Path]:
    """A path at which the bytes can be read until the block ends.

    In memory on Linux: a service in a container has no place to write to. Elsewhere in a temporary folder.
    """
    if hasattr(os, "memfd_create"):
        with os.fdopen(os.memfd_create(NAME), "wb") as file:
            file.write(body)
            file.flush()
            yield Path(f"/proc/self/fd/{file.fileno()}")
        return
    with tempfile.TemporaryDirectory(prefix="pointpred-") as folder:
        path = Path(folder) / f"{NAME}_samples.{'parquet' if body.startswith(PARQUET) else 'csv'}"
        path.write_bytes(body)
        yield path
