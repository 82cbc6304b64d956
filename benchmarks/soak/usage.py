"""What a process holds: memory, threads, descriptors, processor time; from /proc."""

from __future__ import annotations

import os
from pathlib import Path

import msgspec


class Usage(msgspec.Struct):
    """What a process holds at a moment; ``at_s`` since the soak began."""

    at_s: float
    memory_mb: float
    threads: int
    descriptors: int
    processor_s: float


def usage_of(pid: int, at_s: float) -> Usage:
    """Look now; raises OSError where the process has ended."""
    folder = Path("/proc") / str(pid)
    lines = (folder / "status").read_text().splitlines()
    status = dict(line.split(":", 1) for line in lines if ":" in line)
    times = (folder / "stat").read_text().rpartition(")")[2].split()
    return Usage(
        at_s,
        int(status["RssAnon"].split()[0]) / 1024,
        int(status["Threads"]),
        sum(1 for _ in (folder / "fd").iterdir()),
        (int(times[11]) + int(times[12])) / os.sysconf("SC_CLK_TCK"),
    )
