"""``pointpred replay``: a recording to a service, or as the mouse of a real page."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.cli.coefficients import named_file, with_coefficients
from pointpred.cli.playing import SPEED, TRIAL, complain, one_recording, speed_of
from pointpred.cli.reading import Cpi, Dpi, to_read, with_reading
from pointpred.cli.replay_tables import described, plain, print_played
from pointpred.cli.screen import check_target, write_json
from pointpred.console import remarks
from pointpred.errors import ParameterError, RecordingError
from pointpred.registry import RECOMMENDED

if TYPE_CHECKING:
    from pointpred.recording import Recording
    from pointpred.sources import Reading

PAGE = "As the mouse of a page"


@with_reading
def replay(
    file: Annotated[
        Path | None,
        typer.Argument(
            callback=to_read,
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
        answer = _drive(devtools, url, recording, names, speed=pace, offset=shift, scale=scale)
    else:
        assert to is not None
        asked = {"predictor": predictor, "coefficients": own, "cpi": cpi, "dpi": dpi, "token": token}
        answer = _send(to, recording, quiet=str(json) == "-", trials=names, speed=pace, **asked)
    if json is not None:
        write_json(answer, json)
    if not answer["trials"]:
        raise RecordingError("no trial could be played; see the reasons above")
    if answer.get("agree") is False:
        raise typer.Exit(1)


def _send(to: str, recording: Recording, *, quiet: bool, **asked: Any) -> dict[str, Any]:
    """Play to a service, as ``replay_to`` is asked, and print what came back."""
    from pointpred.cli.progress import following
    from pointpred.replaying import replay_to

    with following() as progress:
        played = replay_to(to, recording, progress=progress, **asked)
    complain(played.skipped)
    if not quiet:
        print_played(played)
    return described(played)


def _drive(
    devtools: str, url: str | None, recording: Recording, names: list[str], **how: Any
) -> dict[str, Any]:
    """Play as the mouse of a page and say what was done."""
    from pointpred.replaying import drive_mouse, open_page
    from pointpred.replaying.choosing import chosen, named, unplayable

    places = chosen(recording, names)
    skips = {k: skip for k in places if (skip := unplayable(recording, k)) is not None}
    skipped = (*(() if names else recording.skipped), *skips.values())
    complain(skipped)
    done = []
    with open_page(devtools, url) as page:
        for k in places:
            if k in skips:
                continue
            driven = drive_mouse(page, recording.rows(k), **how)
            done.append({"trial": named(recording, k), **plain(driven)})
            remarks().print(
                f"{named(recording, k)}: {driven.moves} moves, {driven.presses} presses, "
                f"{driven.releases} releases in {driven.seconds:.2f} s",
                markup=False,
            )
    return {
        "version": 1,
        "recording": recording.name,
        "trials": done,
        "skipped": [plain(s) for s in skipped],
    }


def _pair(text: str) -> tuple[float, float]:
    x, _, y = text.partition(",")
    try:
        pair = float(x), float(y)
    except ValueError:
        pair = math.nan, math.nan
    if not all(map(math.isfinite, pair)):
        raise ParameterError(f"offset must be X,Y in px, received {text!r}")
    return pair
