"""``pointpred devices``: which mice there are, how to be allowed to read them, and whether one speaks."""

from __future__ import annotations

import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import msgspec
import typer
from rich.live import Live
from rich.table import Table

from pointpred.cli.screen import plain, remarks, results, write_json
from pointpred.errors import SourceError

if TYPE_CHECKING:
    from pointpred.cli.devices_watching import Watched
    from pointpred.devices.source import DeviceSource, Found

app = typer.Typer(
    no_args_is_help=True,
    help="The mice of this machine: which can be read, how to get permission, and what they send.",
)

AGAIN_S = 0.1
"""Between two pictures of a watched device in a terminal; elsewhere a line a second is written."""


@app.command("list")
def list_devices(
    everything: Annotated[
        bool, typer.Option("--all", help="Also list HID devices that are not mice, with the reason.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON with everything known.")] = False,
) -> None:
    """List the mice: path, name, whether each can be opened, and what to do if not.

    A mouse is found twice: as hidraw (every report as the device sent it, stamped when it is read) and as
    evdev (decoded and stamped by the kernel). Either can be watched, followed live and recorded.

    Try:

      pointpred devices list

      pointpred devices list --json | jq '.devices[] | select(.openable) | .path'
    """
    found = _found(everything)
    if as_json:
        write_json({"version": 1, "devices": msgspec.to_builtins(found)}, Path("-"))
        return
    if not found:
        from pointpred.devices.hid_devices import BROWSER

        raise SourceError(
            "no mouse found; plug one in and list again. Virtual machines and containers have none of their "
            f"own: {BROWSER}"
        )
    table = Table(box=None, pad_edge=False)
    for column in ("device", "by", "name", "can be opened"):
        table.add_column(column, no_wrap=column == "device")
    for one in found:
        table.add_row(one.path, one.kind, one.name, "yes" if one.openable else f"no: {one.why}")
    results().print(table, markup=False)
    for one in found:
        if one.advice:
            remarks().print(f"{one.path} ({one.name}): {one.advice}", markup=False)


@app.command("udev")
def udev() -> None:
    """Print udev rules that let the user at the screen read the mice.

    They open mice but not keyboards: reading a keyboard means reading passwords. Mice on Bluetooth, and mice
    whose USB interface is not declared as a mouse, get a rule of their own if they are plugged in now.

    Try:

      pointpred devices udev | sudo tee /etc/udev/rules.d/70-pointpred.rules

      sudo udevadm control --reload && sudo udevadm trigger
    """
    from pointpred.devices.hid_devices import hid_devices, no_mouse, rule_of, says_mouse
    from pointpred.devices.udev import RELOAD, RULES_FILE, shipped_rules

    typer.echo(shipped_rules(), nl=False)
    try:
        mice = [device for device in hid_devices() if no_mouse(device) is None]
    except SourceError as error:
        remarks().print(f"no line for mice plugged in now: {error}", markup=False)
        mice = []
    for device in mice:
        if not says_mouse(device):
            name = plain(
                " ".join(device.name.split())
            )  # a device may be called anything, a line of rules too
            typer.echo(f"\n# {name} (opens every interface of this device)\n{rule_of(device)}")
    remarks().print(f"write this into {RULES_FILE}, then run: {RELOAD}", markup=False)


@app.command("watch")
def watch(
    device: Annotated[
        str | None,
        typer.Argument(
            metavar="[DEVICE]", help="As --device of 'pointpred live'. Not given: the first that moves."
        ),
    ] = None,
    seconds: Annotated[
        float | None, typer.Option("--for", min=0.0, metavar="SECONDS", help="Stop after this long.")
    ] = None,
) -> None:
    """Show what a mouse sends until Ctrl-C: counts, buttons, wheels, reports a second, and what was lost.

    If it is unplugged and plugged in again, reading goes on. The desktop keeps its mouse.

    Try:

      pointpred devices watch

      pointpred devices watch /dev/hidraw2 --for 10
    """
    from pointpred.cli.devices_watching import Watched as Watching
    from pointpred.cli.live_device import choose

    with choose(device) as source:
        watched = Watching(source)
        with suppress(KeyboardInterrupt):  # the way this ends
            _follow(source, watched, seconds)
        results().print(watched.summary(), markup=False)


def _follow(source: DeviceSource, watched: Watched, seconds: float | None) -> None:
    """Take reports and show them, as a picture in a terminal and as lines elsewhere."""
    until = None if seconds is None else time.monotonic() + seconds
    pictured = sys.stdout.isatty()
    remarks().print(f"{source.name} at {source.path}; {source.clock}. Ctrl-C ends.", markup=False)
    with Live(console=results(), auto_refresh=False, transient=True) as screen:
        shown = time.monotonic()
        while until is None or time.monotonic() < until:
            watched.add(source.take(AGAIN_S))
            now = time.monotonic()
            if pictured and now - shown >= AGAIN_S:
                screen.update(watched.table(), refresh=True)
                shown = now
            elif not pictured and now - shown >= 1:
                screen.console.print(watched.line(), markup=False)
                shown = now


def _found(everything: bool) -> list[Found]:
    """Mice by hidraw and by evdev, without hidapi the latter only; the cursor where mice cannot be read."""
    from pointpred.devices.cursor import found_cursor
    from pointpred.devices.evdev import list_evdev
    from pointpred.devices.hid_devices import list_hid

    if sys.platform != "linux":
        return [found_cursor()]
    try:
        found = list_hid(everything)
    except SourceError as error:
        remarks().print(str(error), markup=False)
        found = []
    return [*found, *list_evdev()]
