"""``pointpred score``: recordings in, errors beside those of no prediction out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from pointpred.cli.screen import remarks, write_json
from pointpred.errors import ParameterError, RecordingError
from pointpred.registry import REGISTRY, build

if TYPE_CHECKING:
    from pointpred.recording import Recording
    from pointpred.scoring.results import SetScore

FLOOR = "hold"


def score(
    files: Annotated[
        list[Path] | None,
        typer.Argument(exists=True, help="Recordings in any known format; none: the embedded sample."),
    ] = None,
    predictors: Annotated[
        str, typer.Option(help="Names separated by commas, or 'all'; 'hold' is always among them.")
    ] = "all",
    json: Annotated[
        Path | None, typer.Option("--json", metavar="FILE", help="Write the scores as JSON; - for stdout.")
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write one self-contained HTML page.")
    ] = None,
    threads: Annotated[
        int | None, typer.Option(min=1, max=1024, help="Threads; not given: one for each processor.")
    ] = None,
) -> None:
    """Score predictors on recordings: how far off they are, beside no prediction at all.

    Examples:

      pointpred score

      pointpred score study_samples.parquet --predictors switched,kep-quartic

      pointpred score *.sd3 --report out.html

      pointpred score session.csv --json - | jq '.sets[0].predictors'
    """
    names = chosen(predictors)
    screen = remarks()
    scored: list[SetScore] = []
    for recording in _recordings(files or []):
        scored.append(_score(recording, names, threads))
    if json is not None:
        _write(scored, json)
    if report is not None:
        from pointpred.scoring.report import write_report

        write_report(scored, report)
        screen.print(f"report: {report}")
    if json is None or str(json) != "-":
        from pointpred.cli.tables import print_scores

        print_scores(scored)
    if not any(one.trials for one in scored):
        raise RecordingError("no trial could be scored; the reasons stand above")
