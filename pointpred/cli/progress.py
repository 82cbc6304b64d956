"""A progress bar on stderr, only where somebody can see it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.progress import BarColumn, Progress, Task, TaskProgressColumn, TextColumn, TimeRemainingColumn
from rich.text import Text

from pointpred.console import plain, remarks

Advance = Callable[[str, int, int | None], None]


class EventsColumn(TextColumn):
    """Events done of all of them, and how many a second."""

    def __init__(self) -> None:
        super().__init__("")

    def render(self, task: Task) -> Text:
        """As ``1,200,000 of 4,000,000 events, 2.1 million/s``."""
        if task.total is None:
            return Text("")
        rate = f", {task.speed / 1e6:.2f} million/s" if task.speed else ""
        return Text(f"{int(task.completed):,} of {int(task.total):,} events{rate}")


@contextmanager
def following(*, events: bool = False) -> Iterator[Advance | None]:
    """Yield what a run reports to: (what, done, in all or ``None``); without a terminal yield ``None``.

    ``events``: what is counted are events. What was done before the first report of a thing, as by an
    earlier run, does not count for the time left.
    """
    screen = remarks()
    if not screen.is_terminal:
        yield None
        return
    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        TaskProgressColumn(),
        *([EventsColumn()] if events else []),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=screen, transient=True) as bar:
        task, last = bar.add_task("reading", total=None), ""

        def report(name: str, done: int, total: int | None) -> None:
            nonlocal task, last
            if events and name != last:
                bar.remove_task(task)
                task, last = bar.add_task(plain(name), total=total, completed=done), name
            bar.update(task, description=plain(name), completed=done, total=total)

        yield report
