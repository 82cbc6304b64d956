"""Totals of what a watched device has sent: as a table, as a line, and as a sentence at the end."""

from __future__ import annotations

import time

from rich.table import Table

from pointpred.console import counted
from pointpred.devices.cursor import CursorSource
from pointpred.devices.source import BUTTON_NAMES, DeviceSource, Report
from pointpred.live.session import ReportRate


class DeviceWatch:
    """Totals over the reports of a source, and its counters. Memory is bounded."""

    def __init__(self, source: DeviceSource) -> None:
        self.reports = 0
        self.x = self.y = self.wheel = self.pan = 0.0
        self._source = source
        self._unit = "px" if isinstance(source, CursorSource) else "counts"
        self._buttons = 0
        self._pace = ReportRate()

    def add(self, reports: list[Report]) -> None:
        """Count some reports."""
        self.reports += len(reports)
        self._pace.add(time.monotonic(), len(reports))
        for report in reports:
            self.x += report.dx
            self.y += report.dy
            self.wheel += report.wheel
            self.pan += report.pan
            self._buttons = report.buttons

    def rows(self) -> list[tuple[str, str]]:
        """Name and value of everything known now."""
        source = self._source
        pressed = [name for bit, name in BUTTON_NAMES.items() if self._buttons & bit]
        return [
            ("device", f"{source.path} ({source.name})" + ("" if source.plugged else ": unplugged, waiting")),
            ("reports", f"{self.reports}"),
            ("a second", f"{self._pace.rate(time.monotonic()):.0f}"),
            ("x, y", f"{self.x:+.0f}, {self.y:+.0f} {self._unit}"),
            ("wheel, pan", f"{self.wheel:+.0f}, {self.pan:+.0f} steps"),
            ("pressed", ", ".join(pressed) or "none"),
            ("lost", f"{source.lost} in the queue, {source.resynchronised} times in the kernel"),
            ("unreadable", f"{source.unreadable}"),
        ]

    def table(self) -> Table:
        """Everything, for a terminal."""
        table = Table(box=None, pad_edge=False, show_header=False)
        for name, value in self.rows():
            table.add_row(name, value)
        return table

    def line(self) -> str:
        """Everything, in one line for a pipe or a file."""
        return "; ".join(f"{name} {value}" for name, value in self.rows()[1:])

    def summary(self) -> str:
        """The totals in a sentence."""
        source = self._source
        if not self.reports:
            return (
                f"{source.path} sent nothing: move the mouse, or look at another of 'pointpred devices list'"
            )
        return (
            f"{source.path}: {counted(self.reports, 'report')}, {source.lost} lost, "
            f"{source.unreadable} unreadable, {self.x:+.0f} and {self.y:+.0f} {self._unit}"
        )
