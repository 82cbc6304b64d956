"""What ``pointpred live`` prints: a table drawn in place in a terminal, elsewhere a line a second."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable
from math import hypot
from threading import Event

from rich.console import Console
from rich.live import Live
from rich.panel import Panel
from rich.table import Table
from rich.text import Text

from pointpred.console import counted, plain, remark
from pointpred.live.playback import PlayedSource
from pointpred.live.session import LiveSession, LiveState
from pointpred.logs import OWN, PlainLines
from pointpred.records import PointerEvent, Prediction

REFRESH_S = 0.2
LINE_S = 1.0
REST_S = 0.3
"""A pause that ends a movement."""
DASH = "-"
MOST_PROBLEMS = 20
"""Warnings and errors of the log that are printed at the end."""

Rows = list[tuple[str, str]]
"""Names and values."""


def show(
    session: LiveSession, heading: Rows, stopping: Event, console: Console, extra: Callable[[], Rows]
) -> None:
    """Show the session until ``stopping`` is set."""
    if not console.is_terminal:
        shown = None
        while not stopping.wait(LINE_S):
            state = session.state()
            if state.note != shown and state.note is not None:
                remark(f"note: {state.note}")
            shown = state.note
            console.print(line(state, session.newest, timed=timed(session)), soft_wrap=True)
        return
    with Live(console=console, auto_refresh=False, transient=False) as view:
        while True:
            view.update(picture(session, heading, extra()), refresh=True)
            if stopping.wait(REFRESH_S):
                return


def picture(session: LiveSession, heading: Rows, extra: Rows) -> Panel:
    """The whole view; always as many rows, so that nothing jumps, but for a note at its end."""
    state, newest = session.state(), session.newest
    rows = [
        *heading,
        *prediction_rows(newest, state.idle_s, state.target),
        *state_rows(state, timed=timed(session)),
        *extra,
        *([("note", state.note)] if state.note is not None else []),
    ]
    table = Table.grid(padding=(0, 2))
    table.add_column(style="dim", no_wrap=True)
    table.add_column(overflow="fold")
    for name, words in rows:
        table.add_row(name, Text(plain(words)))
    title = "pointpred live" if state.plugged else "pointpred live: unplugged, waiting for the device"
    return Panel(table, title=title, title_align="left", subtitle="Ctrl-C stops", subtitle_align="right")


def prediction_rows(
    newest: tuple[PointerEvent, Prediction | None] | None, idle_s: float, target: str | None = None
) -> Rows:
    """Cursor, endpoint, phase, time left, and the target where there are targets.

    No prediction is shown for a device at rest.
    """
    cursor = "nothing has moved yet" if newest is None else f"{newest[0].x:.0f}, {newest[0].y:.0f} px"
    event, one = newest or (None, None)
    if event is None or one is None or idle_s > REST_S:
        phase = "at rest" if event is not None and idle_s > REST_S else DASH
        aimed = [] if target is None else [("target", DASH)]
        return [("cursor", cursor), ("endpoint", DASH), ("phase", phase), ("time left", DASH), *aimed]
    away = hypot(one.x - event.x, one.y - event.y)
    left = DASH if one.remaining_s is None else f"{one.remaining_s:.2f} s"
    return [
        ("cursor", cursor),
        ("endpoint", f"{one.x:.0f}, {one.y:.0f} px, {away:.0f} px away"),
        ("phase", one.phase),
        ("time left", left),
        *([] if target is None else [("target", target)]),
    ]


def timed(session: LiveSession) -> bool:
    """Whether delays are meaningful: the times of a replayed recording are not the present ones."""
    return not isinstance(session.source, PlayedSource)


def state_rows(state: LiveState, *, timed: bool = True) -> Rows:
    """Rate, losses and, where they are ``timed``, delays."""
    return [
        ("reports", f"{state.reports}, now {state.rate_hz:.0f}/s"),
        ("losses", losses(state)),
        *([("delay", delays(state))] if timed else []),
    ]


def losses(state: LiveState) -> str:
    """Counts of reports without a prediction, by kind."""
    words = (
        f"{state.lost} lost, {state.unreadable} unreadable, {state.refused} refused, "
        f"{counted(state.resynchronised, 'gap')} in the kernel"
    )
    return f"{words} ({state.why})" if state.why else words


def delays(state: LiveState) -> str:
    """From a report's stamp to its prediction, lately."""
    if state.delay_p50_s is None or state.delay_p99_s is None:
        return "not known: the stamps are of another clock" if state.reports else DASH
    return f"median {1000 * state.delay_p50_s:.2f} ms, 99 % under {1000 * state.delay_p99_s:.2f} ms"


def all_delays(session: LiveSession) -> str:
    """The same over the whole session, with the longest."""
    p50, p99 = session.delays.percentile(0.5), session.delays.percentile(0.99)
    if p50 is None or p99 is None:
        return delays(session.state())
    longest = f"longest {1000 * session.delays.longest:.2f} ms"
    return f"median {1000 * p50:.2f} ms, 99 % under {1000 * p99:.2f} ms, {longest}"


def summary(session: LiveSession) -> str:
    """Reports, losses and delays of a whole session in a sentence."""
    state = session.state()
    words = counted(state.reports, "report")
    if state.unreadable and not state.reports:
        words += f": nothing that {session.source.path} sent could be read"
    return f"{words}; {losses(state)}" + (f"; delay {all_delays(session)}" if timed(session) else "")


def line(
    state: LiveState, newest: tuple[PointerEvent, Prediction | None] | None, *, timed: bool = True
) -> str:
    """One line for a log."""
    row = dict(prediction_rows(newest, state.idle_s, state.target))
    aimed = f"target {row['target']}; " if "target" in row else ""
    there = "" if state.plugged else "unplugged; "
    return (
        f"{there}{state.rate_hz:.0f} reports/s; cursor {row['cursor']}; endpoint {row['endpoint']}; "
        f"{row['phase']}; {row['time left']} left; {aimed}{losses(state)}"
        + (f"; delay {delays(state)}" if timed else "")
    )


class TerminalLog(logging.Handler):
    """Log entries while a view is drawn: the newest for the view, warnings and errors for the end."""

    def __init__(self) -> None:
        super().__init__()
        self.setFormatter(PlainLines())
        self.newest = ""
        self.problems: deque[str] = deque(maxlen=MOST_PROBLEMS)

    def emit(self, record: logging.LogRecord) -> None:
        """Keep one entry."""
        self.newest = self.format(record)
        if record.levelno >= logging.WARNING:
            self.problems.append(self.newest)

    def install(self) -> None:
        """Take every entry of this process in place of stderr."""
        logging.basicConfig(handlers=[self], level=logging.WARNING, force=True)
        logging.getLogger(OWN).setLevel(logging.INFO)
