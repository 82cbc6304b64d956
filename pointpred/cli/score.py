"""``pointpred score``: recordings in, errors beside those of no prediction out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import msgspec
import typer

from pointpred.cli.coefficients import Coefficients, with_coefficients
from pointpred.cli.output_files import check_targets, write_json
from pointpred.cli.reading_options import Cpi, Dpi, recordings_in, shown, to_read, with_reading
from pointpred.console import remarks
from pointpred.errors import ParameterError, PointpredError, RecordingError
from pointpred.extras import require
from pointpred.registry import REGISTRY, build

if TYPE_CHECKING:
    from pointpred.recording import Recording
    from pointpred.scoring import Unread
    from pointpred.sources import Reading

Reasons = dict[str, str]
"""Files that could not be read and recordings that could not be scored, and why."""
WORST = 6
"""Trials with the largest errors that a report draws of each set."""


@with_reading
def score(
    files: Annotated[
        list[Path] | None,
        typer.Argument(
            callback=to_read,
            help="Recordings in any format pointpred reads, or any table of samples; patterns as '*.csv'; "
            "- for stdin; 'sample', or none: the embedded sample.",
        ),
    ] = None,
    predictors: Annotated[
        str, typer.Option(help="Names separated by commas, or 'all'; 'hold' is always among them.")
    ] = "all",
    json: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write all numbers as JSON to this file; - for stdout."),
    ] = None,
    report: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write a report as one HTML file.")
    ] = None,
    targets: Annotated[
        bool, typer.Option("--targets", help="Score the choice of a target instead of the endpoint.")
    ] = False,
    threads: Annotated[
        int | None,
        typer.Option(min=1, max=1024, help="Number of threads. Not given: one for each processor."),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Seed of the bootstrap intervals.")] = 0,
    coefficients: Coefficients = None,
    cpi: Cpi = None,
    dpi: Dpi = None,
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
    """
    names = predictor_names(predictors)
    check_targets({"--json": json, "--report": report}, files or ())
    parameters = with_coefficients(names, coefficients)
    reasons: Reasons = {}
    if targets:
        settings = {"threads": threads, "seed": seed, "cpi": cpi, "dpi": dpi, "parameters": parameters}
        _score_targets(files, reading, names, json, report, **settings)
        return
    if report is not None:
        require("report", "a report")  # before minutes of scoring
    from pointpred.cli.progress import following
    from pointpred.scoring import document
    from pointpred.scoring import score as run

    with following() as progress:
        recordings = _read(files, reading, reasons) if files else _sample()
        scored = run(
            recordings,
            names,
            threads=threads,
            progress=progress,
            cpi=cpi,
            dpi=dpi,
            seed=seed,
            parameters=parameters,
            failed=lambda recording, error: _left_out(reasons, recording.name, error),
            worst=0 if report is None else WORST,
        )
    if report is not None and scored:
        from pointpred.report import write_report

        write_report(scored, report)
    scores = document(scored, _unread(reasons))
    if json is not None:
        write_json(scores, json)
    if json is None or str(json) != "-":
        from pointpred.cli.tables import print_sets

        print_sets(scores.sets, drawn=report is not None)
    if report is not None and scored:
        remarks().print(f"report written: {report}", markup=False)
    if not any(one.trials for one in scores.sets):
        raise RecordingError("no trial could be scored; see the reasons above", code="nothing_scored")


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
    from pointpred.cli.targets import print_targets, target_summaries
    from pointpred.scoring.summary.document import VERSION
    from pointpred.scoring.target_choice import TargetDocument

    reasons: Reasons = {}
    recordings = _read(files, reading, reasons) if files else _sample()
    sets = target_summaries(
        recordings, names, lambda one, error: _left_out(reasons, one.name, error), **settings
    )
    if json is not None:
        write_json(TargetDocument(VERSION, tuple(sets), tuple(_unread(reasons))), json)
    if json is None or str(json) != "-":
        print_targets(sets)
    if not sets:
        raise RecordingError("no trial could be scored; see the reasons above", code="nothing_scored")


def _unread(reasons: Reasons) -> list[Unread]:
    from pointpred.scoring import Unread
    from pointpred.sources.files.names import readable

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


def _free_name(name: str, file: Path, names: Mapping[str, Path]) -> str:
    """A name that no other recording has: with its folder before it where it is taken, then with a number."""
    free, count = name, 1
    while free in names:
        folder = file.absolute() if file.is_dir() else file.absolute().parent
        free = f"{folder.name}/{name}" + f"_{count}" * (count > 1)
        count += 1
    return free


def _read(files: list[Path], reading: Reading, reasons: Reasons) -> Iterator[Recording]:
    """The recordings one by one, so that only one is in memory; complains where a file cannot be read."""
    names: dict[str, Path] = {}
    for file in files:
        try:
            for recording in recordings_in(file, reading):
                name = _free_name(recording.name, file, names)
                if name != recording.name:
                    first = shown(names[recording.name])
                    note = f"{shown(file)} is called {name!r} here: {recording.name!r} is {first}"
                    remarks().print(note, markup=False)
                names[name] = file
                yield msgspec.structs.replace(recording, name=name)
        except (PointpredError, OSError) as error:
            _left_out(reasons, shown(file), error)


def read_all(files: list[Path], reading: Reading) -> list[Recording]:
    """The recordings of files, each with a name of its own; complains where a file cannot be read."""
    return list(_read(files, reading, {}))


def _left_out(reasons: Reasons, name: str, error: Exception) -> None:
    """Complain about a file that cannot be read or a recording that cannot be scored, and remember it."""
    expected = isinstance(error, PointpredError | OSError)
    reason = str(error) if expected else f"{type(error).__name__}: {error}"
    reasons[name] = reason
    message = reason if name in reason else f"{name}: {reason}"
    remarks().print(f"left out: {message}", style="red", markup=False)
