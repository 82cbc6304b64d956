"""``pointpred live``: predictions of the mouse attached to this machine, as it moves."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import Annotated, Any

import typer
from msgspec.structs import replace

from pointpred.cli import live_device
from pointpred.cli.coefficients import Coefficients, with_coefficients
from pointpred.cli.live_device import Where
from pointpred.cli.live_notes import notes_of
from pointpred.cli.live_outlets import Outlets, Wanted
from pointpred.cli.live_person import read_person, save_person
from pointpred.cli.live_replay import Asked, end_with, replay_of
from pointpred.cli.playing import SPEED, TRIAL
from pointpred.cli.reading import (
    Columns,
    Cut,
    PauseS,
    PxPerUnit,
    Records,
    Screen,
    TimeUnit,
    Unit,
    YUp,
    reading,
    to_read,
)
from pointpred.cli.screen import check_target, results
from pointpred.errors import ParameterError
from pointpred.events import CPI, DPI, PointerEvent
from pointpred.pipeline import Pipeline
from pointpred.registry import RECOMMENDED, build
from pointpred.transfer import ConstantGain, PixelTransfer, TransferLearner, named_transfer

REPLAY = "Without a device"
LSL = "Lab Streaming Layer (extra lsl)"
DPI_USUAL = 96.0
ONLY_DEVICE = {"device", "measure_cpi", "transfer", "display", "person", "lsl"}
"""Options that mean nothing where a recording is played."""
ONLY_REPLAY = {
    "trial",
    "speed",
    "cut",
    "pause_s",
    "unit",
    "screen",
    "columns",
    "time_unit",
    "y_up",
    "px_per_unit",
    "records",
}
"""Options that mean nothing without one."""


def live(
    device: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="Device to read: /dev/input/event5, event5, hidraw2, a link, a part of its name, "
            "or cursor (the screen's). Not given: the first that moves; the cursor on Windows and macOS.",
        ),
    ] = None,
    predictor: Annotated[str, typer.Option(help="A name from 'pointpred predictors'.")] = RECOMMENDED,
    cpi: Annotated[
        float | None,
        typer.Option(min=CPI[0], max=CPI[1], help="Counts per inch of the mouse, as on its box."),
    ] = None,
    measure_cpi: Annotated[
        bool, typer.Option("--measure-cpi", help="Measure the counts per inch first, with a ruler.")
    ] = False,
    distance_cm: Annotated[
        float, typer.Option(min=1.0, max=100.0, help="With --measure-cpi: length of the move, cm.")
    ] = 10.0,
    dpi: Annotated[
        float | None, typer.Option(min=DPI[0], max=DPI[1], help="Pixels per inch of the screen (96).")
    ] = None,
    cursor: Annotated[
        Where,
        typer.Option(
            metavar="SOURCE",
            help="Source of cursor positions: auto, screen, transfer, or motor, which predicts the hand.",
        ),
    ] = "auto",
    transfer: Annotated[
        str | None,
        typer.Option(
            metavar="FUNCTION", help="Function that moves the cursor: constant:4, sigmoid, or a saved file."
        ),
    ] = None,
    save_transfer: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Save the transfer function learned from the screen's cursor."),
    ] = None,
    display: Annotated[str | None, typer.Option(help="X11 display. Not given: the one in DISPLAY.")] = None,
    record: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Record to this file; 'pointpred score' reads it.")
    ] = None,
    person: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Go on with the person of this file, and save it there in the end."
        ),
    ] = None,
    coefficients: Coefficients = None,
    serve: Annotated[
        bool, typer.Option("--serve", help="Serve the live page with this device on it.")
    ] = False,
    host: Annotated[str | None, typer.Option(help="With --serve: address to listen on.")] = None,
    port: Annotated[int | None, typer.Option(min=0, max=65535, help="With --serve: port.")] = None,
    seconds: Annotated[float | None, typer.Option(min=0.0, help="Stop after this many seconds.")] = None,
    lsl: Annotated[
        str | None,
        typer.Option(
            metavar="STREAM",
            help="Follow the positions of this stream instead of a mouse; its channels are labelled x and y.",
            rich_help_panel=LSL,
        ),
    ] = None,
    lsl_out: Annotated[
        bool,
        typer.Option(
            "--lsl-out",
            help="Send the predictions as the stream 'pointpred'. Other machines on the network can read it.",
            rich_help_panel=LSL,
        ),
    ] = False,
    replay: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            callback=to_read,
            help="Play this recording instead of reading a mouse; 'sample': the embedded one.",
            rich_help_panel=REPLAY,
        ),
    ] = None,
    trial: Annotated[list[str] | None, typer.Option(help=TRIAL, rich_help_panel=REPLAY)] = None,
    speed: Annotated[str | None, typer.Option(help=f"{SPEED} Not given: 1.", rich_help_panel=REPLAY)] = None,
    cut: Cut = None,
    pause_s: PauseS = None,
    unit: Unit = None,
    screen: Screen = None,
    columns: Columns = None,
    time_unit: TimeUnit = None,
    y_up: YUp = False,
    px_per_unit: PxPerUnit = None,
    records: Records = None,
) -> None:
    """Predict where the mouse attached to this machine is heading, while it moves.

    A terminal shows a table that is updated in place; elsewhere one line is written each second. Ctrl-C
    stops. 'pointpred devices list' shows the devices. Without one, --replay plays a recording in its place.

    Try:

      pointpred live --cpi 800

      pointpred live --cpi 800 --record session.csv --seconds 60; pointpred score session.csv

      pointpred live --cpi 800 --serve

      pointpred live --replay sample --serve
    """
    given = {name for name, value in locals().items() if value not in (None, False)}
    if record is not None:
        _check_new("--record", record)
        _check_new("--record", _predictions_beside(record))
    if save_transfer is not None:
        _check_new("--save-transfer", save_transfer)
    if not serve and (host is not None or port is not None):
        raise ParameterError("--host and --port need --serve")
    wanted = Wanted(predictor, cpi, DPI_USUAL, record, save_transfer, serve, host, port, seconds, lsl=lsl_out)
    own = with_coefficients([predictor], coefficients).get(predictor, {})
    if replay is not None:
        _check_replay(given, cursor)
        told = reading(cut, pause_s, unit, screen, cpi, dpi, columns, time_unit, y_up, px_per_unit, records)
        asked = Asked(replay, tuple(trial or ()), speed, told, cpi, dpi)
        _play(asked, wanted, own)
        return
    if alone := sorted(given & ONLY_REPLAY):
        raise ParameterError(f"{_flag(alone[0])} needs --replay")
    dpi = DPI_USUAL if dpi is None else dpi
    moving = named_transfer(transfer) if transfer else None
    if moving is not None and cpi is None and not measure_cpi:
        cpi = moving.cpi
    known_person = read_person(person, predictor)
    _warm(predictor)
    from pointpred.devices.cursor import CursorSource
    from pointpred.devices.lsl_inlet import LslInlet
    from pointpred.devices.sessions import LiveSession
    from pointpred.server.garbage import spare

    with ExitStack() as until_done:
        source = until_done.enter_context(live_device.choose(device, display, lsl))
        if isinstance(source, LslInlet):
            known = cpi
            path, close = live_device.stream_path(
                source, cursor=cursor, measure_cpi=measure_cpi, transfer=transfer, display=display
            )
        elif isinstance(source, CursorSource):
            known = None
            path, close = live_device.cursor_path(
                source, cpi, cursor=cursor, measure_cpi=measure_cpi, transfer=transfer
            )
        else:
            known = live_device.resolution(source, cpi, measure_cpi, distance_cm)
            function = moving.function if moving else None
            path, close = live_device.path_of(cursor, function, known, dpi, display)
        until_done.callback(close)
        pipeline = build(predictor, cpi=known, dpi=dpi, person=known_person, **own)
        session = LiveSession(source, path, pipeline)
        session.note = notes_of(session)
        outlets = Outlets(session, replace(wanted, cpi=known, dpi=dpi))
        spare()
        if person is not None:
            until_done.callback(_save_person, person, pipeline)
        outlets.follow()


def _save_person(file: Path, pipeline: Pipeline) -> None:
    """Save whom the session knew, however it ended."""
    results().print(f"person: {save_person(file, pipeline)}", markup=False, soft_wrap=True)


def _check_replay(given: set[str], cursor: Where) -> None:
    """Raise ParameterError where an option of a device is given with --replay."""
    device = sorted(given & ONLY_DEVICE) + (["cursor"] if cursor != "auto" else [])
    if device:
        raise ParameterError(f"{_flag(device[0])} is for a mouse, and --replay plays a recording; drop one")


def _flag(name: str) -> str:
    return f"--{name.replace('_', '-')}"


def _play(asked: Asked, wanted: Wanted, own: dict[str, Any]) -> None:
    """Play a recording as the session of a device."""
    replay = replay_of(asked)
    _warm(wanted.predictor)
    from pointpred.devices.played import PlayedPipeline
    from pointpred.devices.sessions import LiveSession
    from pointpred.server.garbage import spare

    wanted = replace(wanted, cpi=replay.cpi, dpi=replay.dpi, simulated=replay.simulated)
    pipeline = PlayedPipeline(build(wanted.predictor, cpi=wanted.cpi, dpi=wanted.dpi, **own))
    with replay.source as source:
        outlets = Outlets(LiveSession(source, replay.path, pipeline), wanted)
        end_with(outlets, source)
        spare()
        outlets.follow()


def _check_new(option: str, file: Path) -> None:
    check_target(file)
    if file.exists() or str(file) == "-":
        raise ParameterError(f"{option} makes a new file, and {file} is there already; name another")


def _predictions_beside(samples: Path) -> Path:
    """Where a recording's predictions go."""
    return samples.with_name(f"{samples.stem.removesuffix('_samples') or samples.stem}_predictions.csv")


def _warm(predictor: str) -> None:
    """Compile what is not compiled yet, before reports wait for it; raises ParameterError."""
    pipeline, learner = build(predictor, cpi=1000.0), TransferLearner(cpi=1000.0)
    transfer = PixelTransfer(ConstantGain(), cpi=1000.0)
    for i in range(4):
        event = PointerEvent(0.01 * i, 5.0 * i, 2.0 * i, 4.0, 2.0)
        pipeline.update(event)
        learner.update(event)
        transfer.update((event.t, 4.0, 2.0))
