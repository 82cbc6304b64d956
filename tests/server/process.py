"""The service as a process of its own, with its own limits."""

from __future__ import annotations

import re
import resource
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial


@dataclass
class Served:
    """A service that runs: its process, its port, and what it has written to stderr."""

    process: subprocess.Popen[str]
    port: int
    log: list[str]

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.port}"


@contextmanager
def served(*arguments: str, files: int | None = None) -> Iterator[Served]:
    """Serve until the block ends; ``files``: how many descriptors the process may have."""
    command = [sys.executable, "-m", "pointpred", "serve", "--port", "0", *arguments]
    limit = None if files is None else partial(resource.setrlimit, resource.RLIMIT_NOFILE, (files, files))
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, preexec_fn=limit
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        found = re.search(r":(\d+)/", process.stdout.readline())
        log: list[str] = []
        reader = threading.Thread(target=log.extend, args=(process.stderr,))
        reader.start()
        try:
            assert found is not None, "the service printed no address"
            yield Served(process, int(found[1]), log)
        finally:
            process.terminate()
            reader.join()
