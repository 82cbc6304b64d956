"""A process and those that it started, from /proc."""

from __future__ import annotations

from pathlib import Path


def family(pid: int) -> tuple[int, ...]:
    """A process and all that it started; raises FileNotFoundError where one of them has ended."""
    children = " ".join(file.read_text() for file in Path(f"/proc/{pid}/task").glob("*/children")).split()
    return (pid, *(one for child in children for one in family(int(child))))
