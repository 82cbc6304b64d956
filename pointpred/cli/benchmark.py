"""``pointpred benchmark``: public sets fetched, checked and scored by one protocol."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from msgspec.structs import replace

from pointpred.cli.output_files import Force, Numbers, Report, check_targets, write_json
from pointpred.cli.reading_options import Reasons, leave_out
from pointpred.cli.score import WORST, predictor_names
from pointpred.cli.shared_options import complete_predictors
from pointpred.console import remark, results, table
from pointpred.errors import ParameterError, PointpredError, RecordingError
from pointpred.extras import require

if TYPE_CHECKING:
    from pointpred.scoring import SetScore, SetSummary


def benchmark(
    folder: Annotated[
        Path,
        typer.Option(metavar="FOLDER", file_okay=False, help="Where the sets are kept; made if missing."),
    ] = Path("recordings"),
    predictors: Annotated[
        str,
        typer.Option(
            help="Names separated by commas, or 'all'; 'hold' is always among them.",
            autocompletion=complete_predictors,
        ),
    ] = "all",
    json: Numbers = None,
    report: Report = None,
    force: Force = False,
) -> None:
    """Score predictors on public recordings of people, which are fetched, by one protocol.

    Licences are printed before anything is fetched. Files that are in the folder are checked and kept, and
    need no network. What has learned from people is scored with coefficients that did not see the set.

    Try:

      pointpred benchmark

      pointpred benchmark --folder recordings --report benchmark

      pointpred benchmark --predictors minimum-jerk,kinematic --json scores.json
    """
    names, tables = predictor_names(predictors)
    if tables:
        message = "a table of predictions is of one set: pointpred score FILES --predictors NAME=TABLE"
        raise ParameterError(message, field="predictors", value=predictors)
    if report is not None:
        require("report", "a report")
        from pointpred.scoring.report.report import page_in

        check_targets({"--json": json, "--report": page_in(report) if report.is_dir() else report}, (), force)
    else:
        check_targets({"--json": json}, (), force)
    from pointpred.recordings.read_files import readable
    from pointpred.scoring import Document, Unread, summarise
    from pointpred.scoring.summary.document import VERSION

    reasons: Reasons = {}
    scores = _scored(folder, names, reasons, worst=WORST if report is not None else 0)
    sets = tuple(summarise(one) for one in scores)
    if report is not None and scores:
        from pointpred.benchmark import write_sets
        from pointpred.scoring.report import write_report

        write_report(scores, report)
        if (page := page_in(report)) != report:
            write_sets(sets, page.parent)
    if json is not None:
        unread = (Unread(name, readable(why)) for name, why in reasons.items())
        write_json(Document(VERSION, sets, tuple(unread)), json)
    if json is None or str(json) != "-":
        from pointpred.cli.score_tables import print_sets

        print_sets([_with_short_names(one) for one in sets], drawn=report is not None)
        _print_all(sets)
    if reasons:
        remark(f"Not scored, for the reasons above: {', '.join(reasons)}")
    if report is not None and scores:
        remark(f"report written: {report}")
    if not scores:
        raise RecordingError("no set could be scored; see the reasons above", code="nothing_scored")


def _scored(folder: Path, names: Sequence[str], reasons: Reasons, *, worst: int) -> list[SetScore]:
    """Each set that can be had, fetched, read and scored."""
    from pointpred.benchmark import benchmark_sets, judged_on
    from pointpred.cli.progress import following
    from pointpred.datasets import fetch, terms
    from pointpred.scoring import score
    from pointpred.scoring.scorer import with_ablations

    entries = benchmark_sets()
    said = [line for entry in entries for line in terms(entry)]
    for line in said:
        remark(line)
    scores = []
    for entry in entries:
        try:
            with following() as progress:
                fetch(
                    entry,
                    folder / entry.name,
                    progress=progress,
                    say=lambda line: None if line in said else remark(line),
                )
            recording = entry.read(folder / entry.name)
            with following(events=True) as progress:
                scores += score(
                    [recording], judged_on(recording, with_ablations(names)), worst=worst, progress=progress
                )
        except (PointpredError, OSError) as error:  # the other sets are scored
            leave_out(reasons, entry.name, error)
    return scores


def _with_short_names(one: SetSummary) -> SetSummary:
    """The set with a star in the place of the words that tables of several columns have no room for."""
    from pointpred.benchmark import SET_OUT

    starred = (replace(p, name=p.name.replace(SET_OUT, " *")) for p in one.predictors)
    return replace(one, predictors=tuple(starred))


def _print_all(sets: Sequence[SetSummary]) -> None:
    """One table of all sets: shares of hold's error with their intervals."""
    from pointpred.benchmark import SET_OUT

    if not sets:
        return
    rows: dict[str, list[str]] = {}
    for number, one in enumerate(sets):
        for predictor in one.predictors:
            share, interval = predictor.time_averaged.of_hold, predictor.time_averaged.interval
            words = "-" if share is None else f"{share:.2f}"
            if share is not None and interval is not None:
                words += f" [{interval[0]:.2f}, {interval[1]:.2f}]"
            rows.setdefault(predictor.name, [predictor.name, *("-" for _ in sets)])[number + 1] = words
    headings = ("predictor", *(one.name for one in sets))
    if any(SET_OUT in name for name in rows):
        results().print("*: set left out, fitted to other sets only", style="dim")
    results().print("All sets: time-averaged error, share of hold's [95 % interval]", style="bold")
    results().print(table(headings, rows.values(), whole=headings[1:], overflow="fold"))
