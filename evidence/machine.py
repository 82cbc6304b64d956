"""The machine that measures as a page names it: its cores, its processes, and the time that these use."""

from __future__ import annotations

import os
import platform
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path

TICKS_PER_S = os.sysconf("SC_CLK_TCK")
CORES = sorted(os.sched_getaffinity(0))
FIRST, LAST, ALL = {CORES[0]}, {CORES[-1]}, set(CORES)
"""The core of a server, that of the load generator, which is another where there are two, and all of them."""


def machine(*, load: bool = False) -> str:
    """The computer, how busy it is where ``load``, and the date."""
    busy = f", load average before the run {os.getloadavg()[0]:.1f}" if load else ""
    return f"{computer()}{busy}; {datetime.now(UTC):%Y-%m-%d}"


def computer(cpuinfo: Path = Path("/proc/cpuinfo")) -> str:
    """The processor as far as the system names it, its cores, and Python."""
    lines = cpuinfo.read_text(encoding="utf-8").splitlines() if cpuinfo.exists() else []
    named = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    model = named or platform.processor() or platform.machine()
    cores = os.cpu_count() or 1
    return f"{model}, {cores} core{'s' if cores > 1 else ''}, Python {platform.python_version()}"


def family(pid: int) -> tuple[int, ...]:
    """A process and all that it started; raises FileNotFoundError where one of them has ended."""
    children = " ".join(file.read_text() for file in Path(f"/proc/{pid}/task").glob("*/children")).split()
    return (pid, *(one for child in children for one in family(int(child))))


def processor_s(pid: int) -> float:
    """Processor time of a process so far, in ticks of usually 10 ms; 0 once it has ended.

    That of threads that have ended counts, that of processes that it started does not.
    """
    with suppress(FileNotFoundError, ProcessLookupError):
        fields = Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / TICKS_PER_S
    return 0.0


@contextmanager
def on_cores(cores: set[int]) -> Iterator[None]:
    """Processes that are started meanwhile run on these cores only."""
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, cores)
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)
