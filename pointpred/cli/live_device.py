"""Which device ``pointpred live`` reads, how fine it counts, and where its cursor is."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal

import typer

from pointpred.cli.screen import remarks
from pointpred.errors import ParameterError, SourceError
from pointpred.events import CPI

if TYPE_CHECKING:
    from pointpred.devices.paths import CursorPath
    from pointpred.devices.source import DeviceSource, Found
    from pointpred.transfer import TransferFunction

Where = Literal["auto", "screen", "transfer", "motor"]
QUESTION = "Counts per inch of the mouse (on its box; m: measure it; -: unknown)"
RULER = "Put the mouse against a ruler, move it 10 cm in a straight line, then hold it still for a second."


def choose(path: str | None) -> DeviceSource:
    """The device at a path, or the first that can be read; raises SourceError that says what to do next."""
    from pointpred.devices.evdev import EvdevSource
    from pointpred.devices.hid import HidSource

    if path is not None:
        return EvdevSource(path) if "/input/" in path else HidSource(path)
    found = _listed()
    fit = [one for one in found if one.openable]
    if not fit:
        raise SourceError(_none(found))
    if len(fit) > 1:
        others = ", ".join(f"{one.path} ({one.name})" for one in fit[1:])
        said = f"reading {fit[0].path} ({fit[0].name}); --device takes another: {others}"
        remarks().print(said, markup=False)
    return EvdevSource(fit[0].path) if fit[0].kind == "evdev" else HidSource(fit[0].path)


def _listed() -> list[Found]:
    """Mice by evdev, which the kernel stamps, then by hidraw; without hidapi only the former."""
    from pointpred.devices.evdev import list_evdev
    from pointpred.devices.hid import list_hid

    try:
        mice = list_hid()
    except SourceError as error:
        if sys.platform != "linux":
            raise
        remarks().print(str(error), markup=False)
        mice = []
    return [*list_evdev(), *mice]


def _none(found: list[Found]) -> str:
    """Why no device can be read, and what to do next."""
    from pointpred.devices.hid_devices import BROWSER

    if not found:
        return f"no mouse was found; plug one in and see 'pointpred devices list'. Otherwise {BROWSER}"
    said = [f"{one.path} ({one.name}): {one.why}; {one.advice or BROWSER}" for one in found]
    return "\n  ".join(["no mouse can be read:", *said])


def resolution(source: DeviceSource, cpi: float | None, measured: bool, distance_cm: float) -> float | None:
    """Counts per inch: given, measured with the open source, or asked for where somebody can answer."""
    if cpi is not None and measured:
        raise ParameterError("give either --cpi or --measure-cpi")
    if cpi is None and not measured and sys.stdin.isatty() and sys.stdout.isatty():
        said = typer.prompt(QUESTION, value_proc=_cpi)
        measured, cpi = said == "m", said if isinstance(said, float) else None
    if measured:
        return _measured(source, distance_cm)
    if cpi is None:
        remarks().print("no --cpi: one count counts as one px, and speeds of the hand are guesses")
    return cpi


def _cpi(words: str) -> float | str:
    """An answer to the question for counts per inch."""
    said = words.strip()
    if said in ("m", "-"):
        return said
    try:
        value = float(said)
    except ValueError:
        raise typer.BadParameter(f"expected a number, m or -, received {said!r}") from None
    if not CPI[0] <= value <= CPI[1]:
        raise typer.BadParameter(f"must lie in [{CPI[0]:g}, {CPI[1]:g}], received {value:g}")
    return value


def _measured(source: DeviceSource, distance_cm: float) -> float:
    from pointpred.devices.resolution import measure

    remarks().print(RULER.replace("10 cm", f"{distance_cm:g} cm"))
    found = measure(source, distance_cm)
    remarks().print(f"{found.counts:.0f} counts over {distance_cm:g} cm: {found.cpi:.0f} CPI, to some 3 %")
    if not found.straight:
        remarks().print(
            f"the way was {found.bent:.2f} times as long as a straight line: better measure again"
        )
    return found.cpi


def path_of(
    where: Where, function: TransferFunction | None, cpi: float | None, dpi: float, display: str | None
) -> tuple[CursorPath, Callable[[], None]]:
    """Where the cursor is, and what closes it; raises SourceError where the way asked for does not exist."""
    from pointpred.devices.paths import MotorPath, TransferPath

    if where in ("auto", "screen"):
        try:
            return _screen(display)
        except SourceError as error:
            if where == "screen":
                raise
            remarks().print(str(error), markup=False)
    if where == "transfer" or (where == "auto" and function is not None):
        if function is None or cpi is None:
            raise ParameterError("a cursor moved by a transfer function needs --transfer and --cpi")
        return TransferPath(function, cpi=cpi, dpi=dpi), _nothing
    return MotorPath(cpi, dpi), _nothing


def _screen(display: str | None) -> tuple[CursorPath, Callable[[], None]]:
    from pointpred.devices.cursor_x11 import ScreenCursor
    from pointpred.devices.pairing import Pairing

    cursor = ScreenCursor(display)
    return Pairing(cursor), cursor.close


def _nothing() -> None:
    """There is nothing to close."""
