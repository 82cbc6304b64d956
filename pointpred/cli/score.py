"""``pointpred score``: recordings in, errors beside those of no prediction out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import starmap
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from pointpred.cli.output_files import Force, Numbers, Report, check_targets, write_json
from pointpred.cli.reading_options import (
    Reasons,
    as_given,
    check_exists,
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
    Threads,
    complete_predictors,
    tell_others,
    with_coefficients,
)
from pointpred.console import remark, remarks
from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import require
from pointpred.recording import Recording
from pointpred.recordings.reading import Reading

if TYPE_CHECKING:
    from pointpred.recordings import StoredRecording
    from pointpred.scoring import Unread

WORST = 6
"""Trials with the largest errors that a report draws of each set."""
TABLE = re.compile(r"([^:=]+)=(.+)")
"""A table of predictions under a name, as r=predictions.csv."""
OUTSIDE = ("checkpoints", "cluster")
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
        str,
        typer.Option(
            help="Names separated by commas, or 'all'; 'hold' is always among them. Values are set behind a "
            "name, after colons: kinematic-adaptive:places=0; a table of predictions is NAME=FILE.",
            autocompletion=complete_predictors,
        ),
    ] = "all",
    json: Numbers = None,
    report: Report = None,
    trials: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Write a table with a row a trial and predictor: .csv or .parquet."
        ),
    ] = None,
    where: Annotated[
        str,
        typer.Option(
            metavar="RULE",
            help="Count only trials that fit, as 'phase != practice and width >= 20'. Predictors that learn "
            "a person see the others, too.",
        ),
    ] = "",
    by: Annotated[
        list[str] | None,
        typer.Option(
            metavar="COLUMN",
            help="Also a table for each level of this condition, or of user; repeatable, or with commas.",
        ),
    ] = None,
    contrast: Annotated[
        str,
        typer.Option(
            metavar="A,B", help="Compare these two predictors over people, or 'all': every pair, by Holm."
        ),
    ] = "",
    targets: Annotated[
        bool,
        typer.Option(
            "--targets",
            help="Score each predictor given the recordings' targets, too, and which target it chooses.",
        ),
    ] = False,
    threads: Threads = None,
    cluster: ClusterAddress = None,
    checkpoints: Annotated[
        Path | None,
        typer.Option(
            metavar="FOLDER",
            help="Keep the result of each chunk in this folder; the same command goes on from what is there.",
            rich_help_panel=PANEL,
        ),
    ] = None,
    coefficients: Coefficients = None,
    force: Force = False,
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

      pointpred score study_samples.parquet --report paper

      pointpred score my.csv --columns t=time,x=px,y=py,user=sid,trial=n --time-unit ms

      pointpred score study.csv --where 'phase != practice' --by width --trials scored.csv

      pointpred score --predictors kinematic,switched:delay_s=0.02 --contrast kinematic,hold

      pointpred score study.csv --predictors kinematic,mine=predictions.csv

      pointpred score session.csv --json - | jq '.sets[0].predictors'

      pointpred score --targets --predictors minimum-jerk

      pointpred score million_samples.parquet --predictors switched --checkpoints done --cluster local
    """
    names, tables = predictor_names(predictors)
    page = report / "report.html" if report is not None and report.is_dir() else report
    inputs = [*(files or ()), *tables.values()]
    check_targets({"--json": json, "--report": page, "--trials": trials}, inputs, force)
    parameters = with_coefficients(names, coefficients)
    reasons: Reasons = {}
    if report is not None:
        require("report", "a report")  # before minutes of scoring
    from pointpred.cli.progress import following
    from pointpred.scoring import Document
    from pointpred.scoring.chunks import score_in_chunks
    from pointpred.scoring.executors import open_executor
    from pointpred.scoring.predictions import predicted
    from pointpred.scoring.scorer import scoring_with, with_ablations
    from pointpred.scoring.summary.document import VERSION
    from pointpred.scoring.target_choice import TargetDocument, score_targets, summarise_targets
    from pointpred.scoring.trial_table import check_trials_file, trial_table, write_trials

    if trials is not None:
        check_trials_file(trials)
    scoring = scoring_with(
        [*with_ablations(names), *starmap(predicted, tables.items())],
        parameters=parameters, cpi=cpi, dpi=dpi, targets=targets,
        where=where, by=listed(by or []), contrast=listed([contrast]),
    )  # fmt: skip
    sets, drawn, choices = [], [], []
    with (
        open_executor(threads=threads, cluster=cluster) as executor,
        following(events=True) as progress,
    ):
        for source in _sources(files, reading, reasons, whole=targets or bool(tables)):
            try:
                scored = score_in_chunks(
                    source, scoring, executor, checkpoints=checkpoints, progress=progress
                )
                sets.append(scored.summary())
                if report is not None or trials is not None:
                    drawn.append(scored.joined(WORST if report is not None else 0))
                if targets and isinstance(source, Recording):
                    made = score_targets(
                        source, names, threads=threads, cpi=cpi, dpi=dpi, parameters=parameters,
                        where=scoring.where,
                    )  # fmt: skip
                    choices += [summarise_targets(kind) for kind in made]
            except Exception as error:  # whatever is wrong with one recording, the others are scored
                if isinstance(error, ParameterError) and error.field in OUTSIDE:
                    raise  # nothing is wrong with the recording
                leave_out(reasons, source.name, error)
    if report is not None and drawn:
        from pointpred.scoring.report import write_report

        write_report(drawn, report)
    if trials is not None and drawn:
        write_trials(trial_table(drawn), trials)
    scores = Document(VERSION, tuple(sets), tuple(_unread(reasons)))
    if json is not None:
        whole = TargetDocument(VERSION, scores.sets, scores.unread, targets=tuple(choices))
        write_json(whole if targets else scores, json)
    if json is None or str(json) != "-":
        from pointpred.cli.score_tables import print_sets, print_targets

        print_sets(scores.sets, drawn=report is not None)
        print_targets(choices)
    if report is not None and drawn:
        remark(f"report written: {report}")
    if trials is not None and drawn:
        remark(f"trials written: {trials}")
    if not any(one.trials for one in scores.sets):
        raise RecordingError("no trial could be scored; see the reasons above", code="nothing_scored")


def _sources(
    files: list[Path] | None, reading: Reading, reasons: Reasons, *, whole: bool
) -> Iterator[Recording | StoredRecording]:
    """The recordings, the sample where none is given; long files stay where they are unless ``whole``."""
    if not files:
        return _sample()
    return in_memory(files, reading, reasons) if whole else in_memory_or_stored(files, reading, reasons)


def _unread(reasons: Reasons) -> list[Unread]:
    from pointpred.recordings.read_files import readable
    from pointpred.scoring import Unread

    return [Unread(readable(file), readable(why)) for file, why in reasons.items()]


def listed(texts: list[str]) -> list[str]:
    """What is named in ``a,b``, one or more of them."""
    return list(dict.fromkeys(part.strip() for text in texts for part in text.split(",") if part.strip()))


def predictor_names(text: str) -> tuple[list[str], dict[str, Path]]:
    """The predictors named in ``a,b`` or ``all``, and tables of predictions as ``c=FILE``.

    Raises ParameterError for an unknown name, a file that is not there, and an empty list.
    """
    from pointpred.registry import REGISTRY, build, settings_in

    if text.strip() == "all":
        tell_others()
        return list(REGISTRY), {}
    every = listed([text])
    tables = {found[1].strip(): Path(found[2].strip()) for one in every if (found := TABLE.match(one))}
    names = [one for one in every if not TABLE.match(one)]
    check_exists(list(tables.values()))
    if not every:
        message = f"--predictors needs names separated by commas or 'all', received {text!r}"
        raise ParameterError(message, field="predictors", value=text)
    for name in names:
        known, settings = settings_in(name)
        build(known, **settings)
    return names, tables


def _sample() -> Iterator[Recording]:
    """The recording that is always there."""
    from pointpred.datasets import sample

    remarks().print("No recording given: scoring the embedded sample of simulated people.")
    yield sample()
