"""A process and those that it started, and the processor time that one has used, from /proc."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

TICKS_PER_S = os.sysconf("SC_CLK_TCK")


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
