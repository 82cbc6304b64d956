"""Which device ``pointpred live`` reads, how fine it counts, and where its cursor is."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import typer

from pointpred.cli.screen import remarks
from pointpred.errors import ParameterError, SourceError
from pointpred.events import CPI

if TYPE_CHECKING:
    from pointpred.devices.cursor import CursorSource
    from pointpred.devices.first_moving import Candidate
    from pointpred.devices.lsl_inlet import LslInlet
    from pointpred.devices.paths import CursorPath
    from pointpred.devices.source import DeviceSource, Found
    from pointpred.transfer import TransferFunction

Where = Literal["auto", "screen", "transfer", "motor"]
QUESTION = "Counts per inch of the mouse (on its box; m: measure it; -: unknown)"
RULER = "Put the mouse against a ruler, move it 10 cm in a straight line, then hold it still for a second."


def choose(name: str | None, display: str | None = None, stream: str | None = None) -> DeviceSource:
    """The device that a name means, or the first that moves of those that can be read.

    ``cursor`` is the screen's cursor, and all that there is where a system keeps mice to itself; ``stream``
    is one of Lab Streaming Layer. Raises SourceError that says what to do next, and ParameterError.
    """
    from pointpred.devices.cursor import NAME, CursorSource, system_cursor
    from pointpred.devices.first_moving import FirstMoving
    from pointpred.devices.lsl_inlet import LslInlet
    from pointpred.devices.naming import path_of

    if stream is not None and name is not None:
        raise ParameterError("--device reads a mouse and --lsl a stream; give one of them")
    if stream is not None:
        return LslInlet(stream)
    if name == NAME or (name is None and sys.platform != "linux"):
        return CursorSource(partial(system_cursor, display))
    if name is not None:
        return _source(path_of(name, [] if _is_path(name) else listed()))
    found = listed()
    if not any(one.openable for one in found):
        raise SourceError(_none(found))
    fresh = [found]  # what was listed just now need not be listed at once again

    def candidates() -> list[Candidate]:
        return [_candidate(one) for one in each_once(fresh.pop() if fresh else listed(remark=False))]

    source = FirstMoving(candidates)
    source.closed = tuple(one for one in found if not one.openable)
    return source


def _is_path(name: str) -> bool:
    """Whether a name can be read without a list of devices, which may not be had everywhere."""
    return name.startswith("/") or name.rstrip("0123456789") in ("event", "hidraw")


def _candidate(one: Found) -> Candidate:
    from pointpred.devices.first_moving import Candidate

    return Candidate(one.path, lambda: _source(one.path))


def _source(path: str) -> DeviceSource:
    from pointpred.devices.evdev import EvdevSource
    from pointpred.devices.hid import HidSource

    return EvdevSource(path) if "/input/" in path else HidSource(path)


def each_once(found: list[Found]) -> list[Found]:
    """The devices that can be opened; of a mouse that is there by evdev and by hidraw, the former."""
    fit = [one for one in found if one.openable]
    nodes = [_sysfs("input", one) for one in fit if one.kind == "evdev"]
    return [
        one
        for one in fit
        if one.kind == "evdev" or not any(_sysfs("hidraw", one) in node.parents for node in nodes)
    ]


def _sysfs(kind: str, one: Found) -> Path:
    """Where the kernel describes the HID device of a hidraw node, or an input node, which lies below it."""
    node = Path("/sys/class", kind, Path(one.path).name)
    return (node / "device" if kind == "hidraw" else node).resolve()


def listed(*, remark: bool = True) -> list[Found]:
    """Mice by evdev, which the kernel stamps, then by hidraw; without hidapi only the former, with a remark.

    Raises SourceError where no program can read mice.
    """
    from pointpred.devices.evdev import list_evdev
    from pointpred.devices.hid import list_hid

    try:
        mice = list_hid()
    except SourceError as error:
        if sys.platform != "linux":
            raise
        if remark:
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


def cursor_path(
    source: CursorSource, cpi: float | None, **given: str | bool | None
) -> tuple[CursorPath, Callable[[], None]]:
    """The path of a cursor that is followed itself; raises ParameterError for options that need counts."""
    from pointpred.devices.paths import PositionPath

    for name, value in given.items():
        if value not in (None, False, "auto", "screen"):
            raise ParameterError(
                f"--{name.replace('_', '-')} needs a mouse's counts, and the cursor has none; drop it"
            )
    if cpi is not None:
        remarks().print("--cpi is not used: the cursor is followed, and it has no counts")
    return PositionPath(source.words), _nothing


def stream_path(source: LslInlet, **given: str | bool | None) -> tuple[CursorPath, Callable[[], None]]:
    """The path of a stream of positions; raises ParameterError for options that need a mouse."""
    from pointpred.devices.paths import PositionPath

    for name, value in given.items():
        if value not in (None, False, "auto"):
            raise ParameterError(
                f"--{name.replace('_', '-')} is for a mouse, and --lsl reads a stream; drop one"
            )
    return PositionPath(source.words, counts=source.counts), _nothing


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
