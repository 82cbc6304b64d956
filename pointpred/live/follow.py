"""``pointpred live`` with a device: open it, find where its cursor is, and run a session over it."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Literal

import msgspec
from msgspec.structs import replace

from pointpred.console import remark, remarks, results
from pointpred.devices.cursor_paths import (
    CursorPath,
    MotorPath,
    Pairing,
    PositionPath,
    SurfacePath,
    TransferPath,
)
from pointpred.devices.evdev import EvdevSource
from pointpred.devices.first_moving import SILENCE_S, FirstMoving
from pointpred.devices.hidraw import HidSource
from pointpred.devices.lsl import LslInlet
from pointpred.devices.screen_cursor import CursorSource, ScreenCursor
from pointpred.devices.selection import choose
from pointpred.devices.source import DeviceInfo, DeviceSource
from pointpred.errors import ParameterError, SourceError
from pointpred.files import beside
from pointpred.garbage import tune_collector
from pointpred.live.run import LiveRun, OutputOptions
from pointpred.live.session import LiveSession
from pointpred.person import LARGEST, portable
from pointpred.pipeline import Pipeline
from pointpred.registry import REGISTRY, build
from pointpred.transfer import TransferFunction, named_transfer

CursorChoice = Literal["auto", "screen", "transfer", "motor"]
CountsPerInch = Callable[[DeviceSource, float | None], float | None]
"""The resolution of an open mouse, from the one that was given: asks or measures where there is none."""

TRY = (
    "Move the mouse that is to be followed. If it is not named here, 'pointpred devices list' says why, such "
    "as a missing permission; --device NAME reads one device"
)


class DeviceOptions(msgspec.Struct, frozen=True):
    """Which device is read, and how its cursor is known; see ``pointpred live --help``."""

    device: str | None = None
    cursor: CursorChoice = "auto"
    transfer: str | None = None
    person: Path | None = None


class OpenPath(msgspec.Struct, frozen=True):
    """A path of the cursor, and its resource to close."""

    path: CursorPath
    close: Callable[[], None] = lambda: None


def follow_device(device: DeviceOptions, outputs: OutputOptions, counts_per_inch: CountsPerInch) -> None:
    """Predict a device's motion until the session ends; raises SourceError and ParameterError."""
    saved = named_transfer(device.transfer) if device.transfer else None
    cpi = outputs.cpi
    if saved is not None and cpi is None:
        cpi = saved.cpi
    person = read_person(device.person, outputs.predictor)
    build(outputs.predictor)  # a wrong name is an error before a device is asked for
    with ExitStack() as stack:
        source = stack.enter_context(choose(device.device, remark))
        if isinstance(source, LslInlet):
            opened = stream_path(source, device)
        elif isinstance(source, CursorSource):
            opened, cpi = cursor_path(source, device, cpi), None
        elif not has_counts(source):
            opened, cpi = surface_path(device, outputs.dpi, cpi), None
        else:
            cpi = counts_per_inch(source, cpi)
            function = saved.function if saved else None
            opened = mouse_path(device.cursor, function, cpi, outputs.dpi)
            if isinstance(source, FirstMoving) or tells_places(source):
                opened = with_surfaces(opened, device.cursor, outputs.dpi)
        stack.callback(opened.close)
        outputs = replace(outputs, cpi=cpi)
        pipeline = outputs.pipeline(person)
        session = LiveSession(source, opened.path, pipeline)
        session.note = device_note(session)
        run = LiveRun(session, outputs)
        tune_collector()
        if (file := device.person) is not None:
            stack.callback(lambda: results().print(f"person: {save_person(file, pipeline)}", soft_wrap=True))
        run.run()


def stream_path(source: LslInlet, options: DeviceOptions) -> OpenPath:
    """The path of a stream of positions; raises ParameterError for options that need a mouse."""
    for name in _mouse_options(options, ("auto",)):
        raise ParameterError(f"--{name} is for a mouse, and {source.path} is a stream; drop one", field=name)
    return OpenPath(PositionPath(source.words, counts=source.counts))


def cursor_path(source: CursorSource, options: DeviceOptions, cpi: float | None = None) -> OpenPath:
    """The path of a cursor that is followed itself; raises ParameterError for options that need counts."""
    for name in _mouse_options(options, ("auto", "screen")):
        raise ParameterError(f"--{name} needs a mouse's counts, and the cursor has none; drop it", field=name)
    if cpi is not None:
        remarks().print("--cpi is not used: the cursor is followed, and it has no counts")
    return OpenPath(PositionPath(source.words))


def tells_places(source: DeviceSource) -> bool:
    """Whether an open device tells positions."""
    return isinstance(source, EvdevSource | HidSource) and source.places


def has_counts(source: DeviceSource) -> bool:
    """Whether an open device, or any that may be followed, has counts."""
    devices = source.devices if isinstance(source, FirstMoving) else (source,)
    return any(not isinstance(one, EvdevSource | HidSource) or one.counts for one in devices)


def surface_path(options: DeviceOptions, dpi: float, cpi: float | None = None) -> OpenPath:
    """The path of a device that tells its positions; raises ParameterError for options that need counts."""
    for name in _mouse_options(options, ("auto", "screen", "motor")):
        raise ParameterError(
            f"--{name} needs a mouse's counts, and this device tells its positions; drop it", field=name
        )
    if cpi is not None:
        remarks().print("--cpi is not used: the device tells its positions, and it has no counts")
    if options.cursor == "motor":
        return OpenPath(SurfacePath(dpi=dpi))
    try:
        with ScreenCursor() as cursor:
            size = cursor.size
    except SourceError:
        if options.cursor == "screen":
            raise
        return OpenPath(SurfacePath(dpi=dpi))
    return OpenPath(SurfacePath(dpi=dpi, screen=size, whole=options.cursor == "screen"))


def with_surfaces(opened: OpenPath, choice: CursorChoice, dpi: float) -> OpenPath:
    """A mouse's path that also takes the positions of absolute devices, which may be followed as well."""
    size = getattr(getattr(opened.path, "cursor", None), "size", None)
    return replace(opened, path=SurfacePath(opened.path, dpi=dpi, screen=size, whole=choice == "screen"))


def mouse_path(
    choice: CursorChoice,
    function: TransferFunction | None,
    cpi: float | None,
    dpi: float,
) -> OpenPath:
    """Where the cursor of a mouse is; raises SourceError where the choice is not possible here."""
    if choice in ("auto", "screen"):
        try:
            cursor = ScreenCursor()
            return OpenPath(Pairing(cursor), cursor.close)
        except SourceError as error:
            if choice == "screen":
                raise
            remark(str(error))
    if choice == "transfer" or (choice == "auto" and function is not None):
        if function is None or cpi is None:
            raise ParameterError(
                "a cursor moved by a transfer function needs --transfer and --cpi", field="transfer"
            )
        return OpenPath(TransferPath(function, cpi=cpi, dpi=dpi))
    return OpenPath(MotorPath(cpi, dpi))


def _mouse_options(options: DeviceOptions, cursors: tuple[str, ...]) -> list[str]:
    """The options, by their flags, that only a mouse can have; ``cursors`` are choices that others may."""
    return [
        name
        for name, wrong in (
            ("cursor", options.cursor not in cursors),
            ("transfer", options.transfer is not None),
        )
        if wrong
    ]


def device_note(session: LiveSession) -> Callable[[], str | None]:
    """The function for ``LiveSession.note`` of a session over a device."""
    source = session.source

    def note() -> str | None:
        if not session.moved and session.silent_s >= SILENCE_S and source.plugged:
            return silence(source)
        return source.note or None if isinstance(source, FirstMoving) else None

    return note


def silence(source: DeviceSource) -> str:
    """Which devices are read while nothing moves, which cannot be, and what to try."""
    if isinstance(source, LslInlet):
        return f"nothing moves in the stream {source.name!r}. Is the program that sends it still running?"
    devices: tuple[DeviceSource, ...] = (source,)
    closed: tuple[DeviceInfo, ...] = ()
    if isinstance(source, FirstMoving):
        devices, closed = source.devices, source.closed
    reading = ", ".join(f"{one.path} ({one.name})" for one in devices)
    not_opened = ", ".join(f"{one.path} ({one.name}): {one.why}" for one in closed)
    also = f"Not opened: {not_opened}. " if not_opened else ""
    return f"nothing moves. Listening to {reading}. {also}{TRY}"


def read_person(file: Path | None, predictor: str) -> str:
    """The person in a file; "" if there is no file yet, or none was named.

    Raises ParameterError for a predictor without one, and for a file that holds none of this predictor.
    """
    if file is None:
        return ""
    if str(file) == "-" or not portable(build(predictor).predictor):
        able = ", ".join(name for name in REGISTRY if portable(build(name).predictor))
        raise ParameterError(f"--person needs a file and one of {able}, received {file} and {predictor}")
    if not file.exists():
        return ""
    with file.open("rb") as opened:
        person = opened.read(LARGEST + 2).decode("ascii", errors="replace").strip()
    try:
        build(predictor, person=person)
    except ParameterError as error:
        raise ParameterError(f"--person {file}: {error}") from None
    return person


def save_person(file: Path, pipeline: Pipeline) -> str:
    """Finish the movement and write the person, readable by the owner only; returns a message."""
    pipeline.reset()
    if not pipeline.person:
        return "nothing was learned, nothing saved"
    part = beside(file, "part")
    try:
        with os.fdopen(os.open(part, os.O_CREAT | os.O_WRONLY | os.O_TRUNC, 0o600), "wb") as opened:
            opened.write(f"{pipeline.person}\n".encode())
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)
    return f"saved in {file}"
