"""A progress bar on stderr, only where somebody can see it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

from pointpred.console import plain, remarks

Advance = Callable[[str, int, int | None], None]


@contextmanager
def following() -> Iterator[Advance | None]:
    """Yield what a run reports to: (what, done, in all or ``None``); without a terminal yield ``None``."""
    screen = remarks()
    if not screen.is_terminal:
        yield None
        return
    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TaskProgressColumn(),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=screen, transient=True) as bar:
        task = bar.add_task("reading", total=None)
        yield lambda name, done, total: bar.update(task, description=plain(name), completed=done, total=total)
