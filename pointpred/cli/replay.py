"""``pointpred replay``: a recording to a service, or as the mouse of a real page."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from msgspec import structs

from pointpred.cli.output_files import Force, Numbers, check_targets, write_json
from pointpred.cli.reading_options import (
    SPEED,
    TRIAL,
    as_given,
    one_recording,
    print_skipped,
    speed_of,
    to_read,
    with_reading,
)
from pointpred.cli.shared_options import PredictorName, named_file, with_coefficients
from pointpred.console import remark, results
from pointpred.errors import ParameterError, RecordingError
from pointpred.recordings.reading import Reading
from pointpred.registry import RECOMMENDED

if TYPE_CHECKING:
    from pointpred.live.socket import Replayed
    from pointpred.recording import Recording


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
        str | None,
        typer.Option(
            metavar="URL", help="Address of a service, ws:// or http://; with --devtools, of a page to open."
        ),
    ] = None,
    devtools: Annotated[
        str | None,
        typer.Option(
            metavar="URL",
            help="Play as the mouse of the browser with these DevTools, such as http://127.0.0.1:9222; "
            "without --to in its first tab.",
        ),
    ] = None,
    speed: Annotated[str, typer.Option(help=SPEED)] = "1",
    predictor: PredictorName = RECOMMENDED,
    trial: Annotated[list[str] | None, typer.Option(help=TRIAL)] = None,
    json: Numbers = None,
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
    force: Force = False,
    cpi: float | None = None,
    dpi: float | None = None,
    *,
    reading: Reading,
) -> None:
    """Play a recording to a service, or as the mouse of a page in a browser.

    A service's answers are compared bit for bit with a local run.

    Try:

      pointpred replay --to ws://127.0.0.1:8765 --trial 1

      pointpred replay study_samples.parquet --to ws://127.0.0.1:8765 --speed max --json -

      pointpred replay study_samples.parquet --devtools http://127.0.0.1:9222 --to http://127.0.0.1:8765/
    """
    if to is None and devtools is None:
        raise ParameterError("give --to URL of a service, or --devtools URL of a browser")
    if coefficients is not None and devtools is not None:
        raise ParameterError("--coefficients is for a service; a page's chooses its own")
    pace = speed_of(speed)
    own = named_file(coefficients)
    if own is not None:
        with_coefficients([predictor], own[1])
    check_targets({"--json": json}, [] if file is None else [file], force)
    recording = one_recording(file, reading)
    names = trial or []
    if devtools is not None:
        driven = _drive(devtools, to, recording, names, speed=pace)
        _finish(driven, json, played=bool(driven["trials"]))
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
    if str(json) != "-":
        _print(played)
    _finish(played, json, played=bool(played.trials))
    if not played.agree:
        raise typer.Exit(1)


def _send(to: str, recording: Recording, **options: Any) -> Replayed:
    """Play to a service, with the options of ``replay_to``."""
    from pointpred.cli.progress import following
    from pointpred.live.socket import replay_to

    with following() as progress:
        played = replay_to(to, recording, progress=progress, **options)
    print_skipped(played.skipped)
    return played


def _drive(
    devtools: str, url: str | None, recording: Recording, names: list[str], *, speed: float
) -> dict[str, Any]:
    """Play as the mouse of a page; prints and returns what was done."""
    from pointpred.live.devtools import drive_mouse, open_page
    from pointpred.live.playback import playable_trials

    played, skipped = playable_trials(recording, names)
    print_skipped(skipped)
    trials = []
    with open_page(devtools, url) as page:
        for one in played:
            driven = drive_mouse(page, one.events, speed=speed)
            trials.append({"trial": one.name, **structs.asdict(driven)})
            remark(
                f"{one.name}: {driven.moves} moves, {driven.presses} presses, "
                f"{driven.releases} releases in {driven.seconds:.2f} s"
            )
    return {"version": 1, "recording": recording.name, "trials": trials, "skipped": skipped}


def _finish(document: object, json: Path | None, *, played: bool) -> None:
    """Write the JSON; raise RecordingError where nothing was played."""
    if json is not None:
        write_json(document, json)
    if not played:
        raise RecordingError("no trial could be played; see the reasons above")


def _print(played: Replayed) -> None:
    """One line a trial, and how many are as the batch."""
    from rich.table import Table

    table = Table("trial", "events", "error, px", "batch, px", "no prediction, px", "s", "as the batch")
    for one in played.trials:
        errors = one.score.time_averaged_px, one.batch.time_averaged_px, one.score.hold_px
        verdict = "bit for bit" if one.agree else f"{one.unlike} of {one.predictions} differ"
        if one.unlike == 0 and not one.agree:
            verdict = "the scores differ"
        if one.gave_way:
            verdict += f", {one.gave_way} gave way"
        table.add_row(
            f"{one.user}-{one.trial}",
            str(one.events),
            *("-" if error is None else f"{error:.1f}" for error in errors),
            f"{one.seconds:.2f}",
            verdict,
        )
    results().print(table)
    same = sum(one.agree for one in played.trials)
    results().print(
        f"{same} of {len(played.trials)} trials as the local batch, bit for bit ({played.predictor})"
    )
