"""``pointpred devices``: list the mice, print the rules that make them readable, watch one."""

from __future__ import annotations

import sys
import time
from contextlib import suppress
from typing import Annotated

import typer
from rich.live import Live

from pointpred.cli.output_files import AsJson, print_json
from pointpred.clock import now
from pointpred.console import counted, plain, remark, results, table
from pointpred.devices.screen_cursor import CursorSource
from pointpred.devices.source import BUTTON_NAMES, DeviceInfo, DeviceSource, PlaceReport, Report
from pointpred.errors import SourceError
from pointpred.live.session import ReportRate

app = typer.Typer(no_args_is_help=True)

AGAIN_S = 0.1
"""Between two drawings of a watched device in a terminal; elsewhere a line is written each second."""


@app.command("list")
def list_devices(
    everything: Annotated[
        bool, typer.Option("--all", help="Also list HID devices that are not mice, with the reason.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """List the mice: path, name, whether each can be opened, and what to do if not.

    A mouse is found twice: as hidraw (every report as the device sent it, stamped when it is read) and as
    evdev (decoded and stamped by the kernel). Either can be watched, followed live and recorded.

    Try:

      pointpred devices list

      pointpred devices list --json | jq '.devices[] | select(.openable) | .path'
    """
    listed = _devices(everything)
    if as_json:
        print_json("devices", listed)
        return
    if not listed:
        from pointpred.devices.source import BROWSER

        raise SourceError(
            "no mouse found; plug one in and list again. Virtual machines and containers have none of their "
            f"own: {BROWSER}"
        )
    rows = [(one.path, one.kind, one.name, "yes" if one.openable else f"no: {one.why}") for one in listed]
    headings = ("device", "by", "name", "can be opened")
    results().print(table(headings, rows, whole=("device",)))
    for one in listed:
        if one.advice:
            remark(f"{one.path} ({one.name}): {one.advice}")


@app.command("udev")
def udev() -> None:
    """Print udev rules that let the user at the screen read the mice.

    They open mice but not keyboards: reading a keyboard means reading passwords. Mice on Bluetooth, and mice
    whose USB interface is not declared as a mouse, get a rule of their own if they are plugged in now.

    Try:

      pointpred devices udev | sudo tee /etc/udev/rules.d/70-pointpred.rules

      sudo udevadm control --reload && sudo udevadm trigger
    """
    from pointpred.devices.hidraw import hid_devices, is_mouse_interface, not_a_mouse, udev_rule
    from pointpred.devices.udev import RELOAD, RULES_FILE, shipped_rules

    typer.echo(shipped_rules(), nl=False)
    try:
        mice = [device for device in hid_devices() if not_a_mouse(device) is None]
    except SourceError as error:
        remark(f"no line for mice plugged in now: {error}")
        mice = []
    for device in mice:
        if not is_mouse_interface(device):
            name = plain(
                " ".join(device.name.split())
            )  # a device may be called anything, a line of rules too
            typer.echo(f"\n# {name} (opens every interface of this device)\n{udev_rule(device)}")
    remark(f"write this into {RULES_FILE}, then run: {RELOAD}")


@app.command("watch")
def watch(
    device: Annotated[
        str | None,
        typer.Argument(
            metavar="[DEVICE]", help="As --device of 'pointpred live'. Not given: the first that moves."
        ),
    ] = None,
    seconds: Annotated[float | None, typer.Option(min=0.0, help="Stop after this many seconds.")] = None,
) -> None:
    """Show what a mouse sends until Ctrl-C: counts, buttons, wheels, reports a second, and what was lost.

    If it is unplugged and plugged in again, reading goes on. The desktop keeps its mouse.

    Try:

      pointpred devices watch

      pointpred devices watch /dev/hidraw2 --seconds 10
    """
    from pointpred.devices.selection import choose

    with choose(device, warn=remark) as source:
        watched = DeviceWatch(source)
        with suppress(KeyboardInterrupt):  # the way this ends
            _follow(source, watched, seconds)
        results().print(watched.summary())


def _follow(source: DeviceSource, watched: DeviceWatch, seconds: float | None) -> None:
    """Take reports and show them: a table in a terminal, lines elsewhere."""
    until = None if seconds is None else time.monotonic() + seconds
    pictured = sys.stdout.isatty()
    remark(f"{source.name} at {source.path}; {source.clock}. Ctrl-C ends.")
    with Live(console=results(), auto_refresh=False, transient=True) as screen:
        shown = time.monotonic()
        while until is None or time.monotonic() < until:
            watched.add(source.take(AGAIN_S))
            now = time.monotonic()
            if pictured and now - shown >= AGAIN_S:
                screen.update(table((), watched.rows()), refresh=True)
                shown = now
            elif not pictured and now - shown >= 1:
                screen.console.print(watched.line())
                shown = now


def _devices(everything: bool) -> list[DeviceInfo]:
    """Mice by hidraw, then by evdev; the cursor on systems that let no program read mice."""
    from pointpred.devices.screen_cursor import cursor_info
    from pointpred.devices.selection import list_mice

    if sys.platform != "linux":
        return [cursor_info()]
    mice = list_mice(everything, remark)
    return sorted(mice, key=lambda one: one.kind != "hid")


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
        self._pace.add(now(), len(reports))
        for report in reports:
            if isinstance(report, PlaceReport):
                self._unit = "units"
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
            ("a second", f"{self._pace.rate(now()):.0f}"),
            ("x, y", f"{self.x:+.0f}, {self.y:+.0f} {self._unit}"),
            ("wheel, pan", f"{self.wheel:+.0f}, {self.pan:+.0f} steps"),
            ("pressed", ", ".join(pressed) or "none"),
            ("lost", f"{source.lost} in the queue, {source.resynchronised} times in the kernel"),
            ("unreadable", f"{source.unreadable}"),
        ]

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
