"""``pointpred score``: recordings in, errors beside those of no prediction out."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from pointpred.cli.output_files import Numbers, check_targets, write_json
from pointpred.cli.reading_options import (
    Reasons,
    as_given,
    in_memory,
    in_memory_or_stored,
    leave_out,
    to_read,
    with_reading,
)
from pointpred.cli.shared_options import (
    PANEL,
    ClusterAddress,
    Coefficients,
    Processes,
    Threads,
    with_coefficients,
)
from pointpred.console import remark, remarks
from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import require
from pointpred.registry import REGISTRY, build

if TYPE_CHECKING:
    from pointpred.recording import Recording
    from pointpred.recordings import Reading
    from pointpred.scoring import Unread

WORST = 6
"""Trials with the largest errors that a report draws of each set."""
OUTSIDE = ("checkpoints", "cluster", "processes")
"""Fields of errors that no recording is to blame for."""


@with_reading
def score(
    files: Annotated[
        list[Path] | None,
        typer.Argument(
            callback=to_read,
            parser=as_given,
            help="Recordings in any format pointpred reads, or any table of samples; patterns as '*.csv'; "
            "- for stdin; 'sample', or none: the embedded sample.",
        ),
    ] = None,
    predictors: Annotated[
        str, typer.Option(help="Names separated by commas, or 'all'; 'hold' is always among them.")
    ] = "all",
    json: Numbers = None,
    report: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write a report as one HTML file.")
    ] = None,
    targets: Annotated[
        bool, typer.Option("--targets", help="Score the choice of a target instead of the endpoint.")
    ] = False,
    threads: Threads = None,
    processes: Processes = None,
    cluster: ClusterAddress = None,
    checkpoints: Annotated[
        Path | None,
        typer.Option(
            metavar="FOLDER",
            help="Keep the result of each chunk in this folder; the same command goes on from what is there.",
            rich_help_panel=PANEL,
        ),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Seed of the bootstrap intervals.")] = 0,
    differentiator: Annotated[
        str | None,
        typer.Option(
            metavar="NAME",
            help="The differentiator before every predictor.",
        ),
    ] = None,
    coefficients: Coefficients = None,
    cpi: float | None = None,
    dpi: float | None = None,
    *,
    reading: Reading,
) -> None:
    """Score predictors on recordings, compared with making no prediction.

    Try:

      pointpred score

      pointpred score study_samples.parquet --predictors switched,kep-quartic

      pointpred score *.sd3 --report out.html

      pointpred score my.csv --columns t=time,x=px,y=py,user=sid,trial=n --time-unit ms

      pointpred score session.csv --json - | jq '.sets[0].predictors'

      pointpred score --targets --predictors minimum-jerk

      pointpred score million_samples.parquet --predictors switched --checkpoints done --cluster local
    """
    names = predictor_names(predictors)
    check_targets({"--json": json, "--report": report}, files or ())
    parameters = with_coefficients(names, coefficients)
    if differentiator is not None:
        chosen = {"differentiator": differentiator}
        parameters = {name: {**parameters.get(name, {}), **chosen} for name in names}
    reasons: Reasons = {}
    if targets:
        _check_alone({"--processes": processes, "--cluster": cluster, "--checkpoints": checkpoints})
        settings = {"threads": threads, "seed": seed, "cpi": cpi, "dpi": dpi, "parameters": parameters}
        _score_targets(files, reading, names, json, report, **settings)
        return
    if report is not None:
        require("report", "a report")  # before minutes of scoring
    from pointpred.cli.progress import following
    from pointpred.scoring import Document
    from pointpred.scoring.chunks import score_in_chunks
    from pointpred.scoring.executors import open_executor
    from pointpred.scoring.scorer import scoring_with
    from pointpred.scoring.summary.document import VERSION

    scoring = scoring_with(names, parameters=parameters, cpi=cpi, dpi=dpi, seed=seed)
    sets, drawn = [], []
    with (
        open_executor(threads=threads, processes=processes, cluster=cluster) as executor,
        following(events=True) as progress,
    ):
        sources = in_memory_or_stored(files, reading, reasons) if files else _sample()
        for source in sources:
            try:
                scored = score_in_chunks(
                    source, scoring, executor, checkpoints=checkpoints, progress=progress
                )
                sets.append(scored.summary())
                if report is not None:
                    drawn.append(scored.joined(WORST))
            except Exception as error:  # whatever is wrong with one recording, the others are scored
                if isinstance(error, ParameterError) and error.field in OUTSIDE:
                    raise  # nothing is wrong with the recording
                leave_out(reasons, source.name, error)
    if report is not None and drawn:
        from pointpred.scoring.report import write_report

        write_report(drawn, report)
    scores = Document(VERSION, tuple(sets), tuple(_unread(reasons)))
    if json is not None:
        write_json(scores, json)
    if json is None or str(json) != "-":
        from pointpred.cli.score_tables import print_sets

        print_sets(scores.sets, drawn=report is not None)
    if report is not None and drawn:
        remark(f"report written: {report}")
    if not any(one.trials for one in scores.sets):
        raise RecordingError("no trial could be scored; see the reasons above", code="nothing_scored")


def _check_alone(given: dict[str, object]) -> None:
    """Raise ParameterError for what scoring the choice of a target does not do."""
    for option, value in given.items():
        if value is not None:
            message = f"{option} does not go with --targets, which scores on threads: leave one out"
            raise ParameterError(message, field=option, value=value)


def _score_targets(
    files: list[Path] | None,
    reading: Reading,
    names: list[str],
    json: Path | None,
    report: Path | None,
    **settings: Any,
) -> None:
    """The output of ``--targets``: tables, and every number as JSON under ``targets``."""
    if report is not None:
        message = "--report draws errors, not choices: leave it out with --targets"
        raise ParameterError(message, field="report", value=str(report))
    from pointpred.cli.score_tables import print_targets
    from pointpred.scoring.summary.document import VERSION
    from pointpred.scoring.target_choice import TargetDocument, score_targets, summarise_targets

    reasons: Reasons = {}
    sets = []
    for recording in in_memory(files, reading, reasons) if files else _sample():
        try:
            scored = score_targets(recording, tuple(names), **settings)
        except Exception as error:  # as in ``score``: the other recordings are scored all the same
            leave_out(reasons, recording.name, error)
            continue
        sets += [summarise_targets(one) for one in scored]
    if json is not None:
        write_json(TargetDocument(VERSION, tuple(sets), tuple(_unread(reasons))), json)
    if json is None or str(json) != "-":
        print_targets(sets)
    if not sets:
        raise RecordingError("no trial could be scored; see the reasons above", code="nothing_scored")


def _unread(reasons: Reasons) -> list[Unread]:
    from pointpred.recordings.read_files import readable
    from pointpred.scoring import Unread

    return [Unread(readable(file), readable(why)) for file, why in reasons.items()]


def predictor_names(text: str) -> list[str]:
    """The predictors named in ``a,b`` or ``all``; raises ParameterError for an unknown or an empty list."""
    if text.strip() == "all":
        return list(REGISTRY)
    names = list(dict.fromkeys(part.strip() for part in text.split(",") if part.strip()))
    if not names:
        message = f"--predictors needs names separated by commas or 'all', received {text!r}"
        raise ParameterError(message, field="predictors", value=text)
    for name in names:
        build(name)
    return names


def _sample() -> Iterator[Recording]:
    """The recording that is always there."""
    from pointpred.datasets import sample

    remarks().print("No recording given: scoring the embedded sample of simulated people.")
    yield sample()
