"""What a service holds: memory, threads, descriptors, processor time; from /proc."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import msgspec

from benchmarks.processes import family, processor_s


class Usage(msgspec.Struct):
    """What a service holds at a moment; ``at_s`` since the soak began."""

    at_s: float
    memory_mb: float
    """Of the process that serves."""
    uploads_mb: float
    """Of the processes that it started: the one that opens recordings."""
    threads: int
    """Of them all, as what follows."""
    descriptors: int
    processor_s: float


def usage_of(pid: int, at_s: float) -> Usage:
    """Look now; raises OSError where the process has ended."""
    serving = _process(pid)
    started = []
    with suppress(OSError):  # one of them ends while it is looked at
        started = [_process(one) for one in family(pid)[1:]]
    sums = [sum(numbers) for numbers in zip(serving, *started, strict=True)]
    return Usage(at_s, serving[0], sums[0] - serving[0], int(sums[1]), int(sums[2]), sums[3])


def _process(pid: int) -> tuple[float, int, int, float]:
    """Memory in MB, threads, descriptors and processor time in s of one process."""
    folder = Path("/proc") / str(pid)
    lines = (folder / "status").read_text().splitlines()
    status = dict(line.split(":", 1) for line in lines if ":" in line)
    return (
        int(status["RssAnon"].split()[0]) / 1024,
        int(status["Threads"]),
        sum(1 for _ in (folder / "fd").iterdir()),
        processor_s(pid),
    )
