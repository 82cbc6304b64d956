"""``pointpred replay``: a recording to a service, or as the mouse of a real page."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.cli.coefficients import named_file, with_coefficients
from pointpred.cli.output_files import check_target, write_json
from pointpred.cli.playback import SPEED, TRIAL, one_recording, print_skipped, speed_of
from pointpred.cli.reading_options import Cpi, Dpi, as_given, to_read, with_reading
from pointpred.console import remarks
from pointpred.errors import ParameterError, RecordingError
from pointpred.registry import RECOMMENDED

if TYPE_CHECKING:
    from pointpred.cli.replay_tables import DriveDocument, ReplayDocument
    from pointpred.recording import Recording
    from pointpred.replaying import Replayed
    from pointpred.sources import Reading

PAGE = "As the mouse of a page"


@with_reading
def replay(
    file: Annotated[
        Path | None,
        typer.Argument(
            callback=to_read,
            parser=as_given,
            help="A recording in any format pointpred reads. Not given: the embedded sample.",
        ),
    ] = None,
    to: Annotated[
        str | None, typer.Option(metavar="URL", help="Address of a service, ws:// or http://.")
    ] = None,
    devtools: Annotated[
        str | None,
        typer.Option(
            metavar="URL", help="DevTools of a browser, such as http://127.0.0.1:9222.", rich_help_panel=PAGE
        ),
    ] = None,
    url: Annotated[
        str | None,
        typer.Option(metavar="PAGE", help="Page to open. Not given: the first tab.", rich_help_panel=PAGE),
    ] = None,
    offset: Annotated[
        str, typer.Option(metavar="X,Y", help="Added to every position, px.", rich_help_panel=PAGE)
    ] = "0,0",
    scale: Annotated[
        float, typer.Option(help="Multiplies every position before --offset is added.", rich_help_panel=PAGE)
    ] = 1.0,
    speed: Annotated[str, typer.Option(help=SPEED)] = "1",
    predictor: Annotated[str, typer.Option(help="A name from 'pointpred predictors'.")] = RECOMMENDED,
    trial: Annotated[list[str] | None, typer.Option(help=TRIAL)] = None,
    json: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write all numbers as JSON to this file; - for stdout."),
    ] = None,
    coefficients: Annotated[
        str | None,
        typer.Option(
            metavar="NAME=FILE",
            help="Coefficients that the service has under this name, and the same file here.",
        ),
    ] = None,
    token: Annotated[
        str | None, typer.Option(envvar="POINTPRED_TOKEN", help="The service's token, if it needs one.")
    ] = None,
    cpi: Cpi = None,
    dpi: Dpi = None,
    *,
    reading: Reading,
) -> None:
    """Play a recording to a service, or as the mouse of a page in a browser.

    A service's answers are compared bit for bit with a local run.

    Try:

      pointpred replay --to ws://127.0.0.1:8765 --trial 1

      pointpred replay study_samples.parquet --to ws://127.0.0.1:8765 --speed max --json -

      pointpred replay study_samples.parquet --devtools http://127.0.0.1:9222 --url http://127.0.0.1:8765/
    """
    if (to is None) == (devtools is None):
        raise ParameterError("give either --to URL of a service or --devtools URL of a browser")
    if coefficients is not None and to is None:
        raise ParameterError("--coefficients needs --to: a page's service chooses its own")
    pace, shift = speed_of(speed), _pair(offset)
    own = named_file(coefficients)
    if own is not None:
        with_coefficients([predictor], own[1])
    check_target(json)
    recording = one_recording(file, reading)
    names = trial or []
    if devtools is not None:
        driven = _drive(devtools, url, recording, names, speed=pace, offset=shift, scale=scale)
        _finish(driven, json, agree=True)
        return
    assert to is not None
    played = _send(
        to,
        recording,
        predictor=predictor,
        speed=pace,
        trials=names,
        cpi=cpi,
        dpi=dpi,
        coefficients=own,
        token=token,
    )
    from pointpred.cli.replay_tables import document, print_played

    if str(json) != "-":
        print_played(played)
    _finish(document(played), json, agree=played.agrees)


def _send(to: str, recording: Recording, **options: Any) -> Replayed:
    """Play to a service, with the options of ``replay_to``."""
    from pointpred.cli.progress import following
    from pointpred.replaying import replay_to

    with following() as progress:
        played = replay_to(to, recording, progress=progress, **options)
    print_skipped(played.skipped)
    return played


def _drive(
    devtools: str, url: str | None, recording: Recording, names: list[str], **options: Any
) -> DriveDocument:
    """Play as the mouse of a page, with the options of ``drive_mouse``, and print what was done."""
    from pointpred.cli.replay_tables import DriveDocument, DrivenTrialRow
    from pointpred.playable import playable_trials, trial_name
    from pointpred.replaying import drive_mouse, open_page

    places, skipped = playable_trials(recording, names)
    print_skipped(skipped)
    trials = []
    with open_page(devtools, url) as page:
        for k in places:
            driven = drive_mouse(page, recording.rows(k), **options)
            trials.append(
                DrivenTrialRow(
                    trial_name(recording, k), driven.moves, driven.presses, driven.releases, driven.seconds
                )
            )
            remarks().print(
                f"{trial_name(recording, k)}: {driven.moves} moves, {driven.presses} presses, "
                f"{driven.releases} releases in {driven.seconds:.2f} s",
                markup=False,
            )
    return DriveDocument(recording=recording.name, trials=trials, skipped=skipped)


def _finish(document: ReplayDocument | DriveDocument, json: Path | None, *, agree: bool) -> None:
    """Write the JSON; raise RecordingError where nothing was played, and exit with 1 where answers differ."""
    if json is not None:
        write_json(document, json)
    if not document.trials:
        raise RecordingError("no trial could be played; see the reasons above")
    if not agree:
        raise typer.Exit(1)


def _pair(text: str) -> tuple[float, float]:
    x, _, y = text.partition(",")
    try:
        pair = float(x), float(y)
    except ValueError:
        pair = math.nan, math.nan
    if not all(map(math.isfinite, pair)):
        raise ParameterError(f"offset must be X,Y in px, received {text!r}")
    return pair
