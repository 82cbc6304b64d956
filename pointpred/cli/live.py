"""``pointpred live``: predictions of the mouse attached to this machine, as it moves."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from pointpred.cli.output_files import check_target
from pointpred.cli.reading_options import (
    SPEED,
    TRIAL,
    as_given,
    one_recording,
    print_skipped,
    speed_of,
    to_read,
)
from pointpred.cli.shared_options import Coefficients, PredictorName, with_coefficients
from pointpred.errors import ParameterError
from pointpred.recordings.reading import AS_IS
from pointpred.records import CPI, DPI
from pointpred.registry import RECOMMENDED

if TYPE_CHECKING:
    from pointpred.live.run import OutputOptions
    from pointpred.protocol.client_messages import Rectangle

REPLAY = "Without a device"
DPI_USUAL = 96.0


def live(
    device: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="Device to read: /dev/input/event5, event5, hidraw2, a link, a part of its name, cursor "
            "(the screen's), or lsl:STREAM (of Lab Streaming Layer, with channels x and y). Not given: the "
            "first that moves; the cursor on Windows and macOS.",
        ),
    ] = None,
    predictor: PredictorName = RECOMMENDED,
    cpi: Annotated[
        float | None,
        typer.Option(
            min=CPI[0],
            max=CPI[1],
            help="Counts per inch of the mouse, as on its box. Not given: asked for in a terminal, where "
            "they can be measured, too.",
        ),
    ] = None,
    dpi: Annotated[
        float | None, typer.Option(min=DPI[0], max=DPI[1], help="Pixels per inch of the screen (96).")
    ] = None,
    cursor: Annotated[
        Literal["auto", "screen", "transfer", "motor"],
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
    record: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Record to this file; 'pointpred score' reads it.")
    ] = None,
    person: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Continue with the person of this file, and save it there at the end."
        ),
    ] = None,
    targets: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="What can be pointed at: rectangles in JSON or CSV (id, x, y, width, height in px).",
        ),
    ] = None,
    coefficients: Coefficients = None,
    serve: Annotated[
        bool, typer.Option("--serve", help="Serve the live page with this device on it.")
    ] = False,
    host: Annotated[str | None, typer.Option(help="With --serve: address to listen on.")] = None,
    port: Annotated[int | None, typer.Option(min=0, max=65535, help="With --serve: port.")] = None,
    seconds: Annotated[float | None, typer.Option(min=0.0, help="Stop after this many seconds.")] = None,
    lsl_out: Annotated[
        bool,
        typer.Option(
            "--lsl-out",
            help="Send the predictions as the stream 'pointpred' of Lab Streaming Layer. Other machines on "
            "the network can read it.",
        ),
    ] = False,
    replay: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            callback=to_read,
            parser=as_given,
            help="Play this recording instead of reading a mouse; 'sample': the embedded one. Formats that "
            "need options: 'pointpred convert' first.",
            rich_help_panel=REPLAY,
        ),
    ] = None,
    trial: Annotated[list[str] | None, typer.Option(help=TRIAL, rich_help_panel=REPLAY)] = None,
    speed: Annotated[str | None, typer.Option(help=f"{SPEED} Not given: 1.", rich_help_panel=REPLAY)] = None,
) -> None:
    """Predict where the mouse attached to this machine is heading, while it moves.

    A terminal shows a table that is updated in place; elsewhere one line is written each second. Ctrl-C
    stops. 'pointpred devices list' shows the devices. Without one, --replay plays a recording in its place.

    Try:

      pointpred live --cpi 800

      pointpred live --cpi 800 --record session.csv --seconds 60; pointpred score session.csv

      pointpred live --cpi 800 --serve

      pointpred live --targets buttons.json

      pointpred live --replay sample --serve
    """
    if record is not None:
        _check_new("--record", record)
        stem = record.stem.removesuffix("_samples") or record.stem
        _check_new("--record", record.with_name(f"{stem}_predictions.csv"))
    if save_transfer is not None:
        _check_new("--save-transfer", save_transfer)
    if not serve and (host is not None or port is not None):
        raise ParameterError("--host and --port need --serve", field="serve")
    check_target(person)
    aimed: tuple[Rectangle, ...] = ()
    if targets is not None:
        from pointpred.live.targets import read_targets

        aimed = read_targets(targets)
    parameters = with_coefficients([predictor], coefficients).get(predictor, {})
    page = None
    if serve:
        from pointpred.live.run import page_opener

        page = page_opener(host, port)

    def outputs(cpi: float | None, dpi: float | None) -> OutputOptions:
        from pointpred.live.run import OutputOptions

        dpi = DPI_USUAL if dpi is None else dpi
        return OutputOptions(
            predictor,
            cpi,
            dpi,
            record,
            save_transfer,
            page,
            seconds,
            lsl=lsl_out,
            parameters=parameters,
            targets=aimed,
        )

    if replay is None:
        if trial is not None or speed is not None:
            field = "speed" if trial is None else "trial"
            raise ParameterError(f"--{field} needs --replay", field=field)
        from pointpred.cli.counts_per_inch import counts_per_inch
        from pointpred.live.follow import DeviceOptions, follow_device

        follow_device(
            DeviceOptions(device, cursor, transfer, person),
            outputs(cpi, dpi),
            counts_per_inch,
        )
        return
    for name, value in (
        ("device", device),
        ("transfer", transfer),
        ("person", person),
        ("cursor", None if cursor == "auto" else cursor),
    ):
        if value is not None:
            raise ParameterError(
                f"--{name} is for a mouse, and --replay plays a recording; drop one", field=name
            )
    from pointpred.live.playback import playable_trials
    from pointpred.live.replay import follow_replay

    pace = speed_of(speed or "1")
    recording = one_recording(replay, AS_IS)
    trials, skipped = playable_trials(recording, trial or ())
    print_skipped(skipped)
    about = recording.provenance
    resolutions = outputs(about.cpi if cpi is None else cpi, about.dpi if dpi is None else dpi)
    follow_replay(replay, recording, trials, pace, resolutions)


def _check_new(option: str, file: Path) -> None:
    """Raise ParameterError where a file cannot be made, or is there already."""
    check_target(file)
    if file.exists() or str(file) == "-":
        raise ParameterError(
            f"{option} makes a new file, and {file} is there already; name another", code="file_exists"
        )
