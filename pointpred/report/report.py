"""A scoring run as one HTML file that needs nothing else: no request, no script."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from pointpred.errors import ParameterError
from pointpred.extras import require
from pointpred.report.boxes import boxes
from pointpred.report.choice import compared, highlighted, pair
from pointpred.report.claims import inside_curves, time_left_bars
from pointpred.report.conclusion import conclusion, ranked
from pointpred.report.figures import clean_against_all, cost, curves, group_curves, skill_bars
from pointpred.report.page import page
from pointpred.report.statistics import mae_table, statistics_html
from pointpred.report.style import HOLD, Picture
from pointpred.report.tables import (
    groups_table,
    section,
    series_table,
    skipped_table,
    summary_table,
    table,
    text,
)
from pointpred.report.worst import draw_worst
from pointpred.scoring.results import SetScore, WorstTrial
from pointpred.scoring.statistics import axis_anova, axis_profile
from pointpred.scoring.summary import SetSummary, summarise
from pointpred.scoring.table import footnotes

MOST_BOXES = 4
LONGEST_SENTENCE = 1000
GROUPS = (
    "with_submovements", "without_submovements", "experienced_people", "novice_people", "clean_trials"
)  # fmt: skip


def write_report(
    scores: Sequence[SetScore],
    path: str | Path,
) -> None:
    """Write what was scored, every table and figure, the statistics and the protocol to ``path``.

    The same scores give the same bytes. The worst trials are drawn where ``score`` was asked to keep them.
    Names in recordings are not trusted: they are escaped. Raises ParameterError for an empty list or a set
    scored without ``hold``, MissingExtraError where the extra ``report`` is not installed, and OSError when
    the file cannot be written.
    """
    require("report", "a report")
    if not scores:
        raise ParameterError("a report needs at least one scored set, received none")
    described = [ranked(summarise(score)) for score in scores]
    body = [
        _set_html(place, score, one) for place, (score, one) in enumerate(zip(scores, described, strict=True))
    ]
    title = "Endpoint prediction: scores" + (" (simulated)" if all(s.simulated for s in scores) else "")
    contents = [(one.name, conclusion(one)) for one in described] if len(described) > 1 else []
    Path(path).write_text(page(title, contents, "\n".join(body)), encoding="utf-8")


def _set_html(place: int, score: SetScore, described: SetSummary) -> str:
    """One set: what it shows in a sentence, a chart and a table; all the rest in parts that are closed."""
    anchor = f"set-{place}"
    tag = ' <span class="tag">simulated people</span>' if score.simulated else ""
    head = f'<h2 id="{anchor}">{text(score.name)}{tag}</h2>'
    scored = section(f"{anchor}-scored", "What was scored", _what(described))
    if not score.trials:
        return f"{head}<p>No trial could be scored.</p>{scored}"
    shown = highlighted(described)
    notes = "".join(f"<small>{text(note, 200)}</small>" for note in footnotes(described))
    front = f"{skill_bars(described).html()}<div>{summary_table(described)}{notes}</div>"
    parts = {
        "Error along the movement": _along(described, shown),
        "Groups of trials": _groups(described),
        "Regions and time left": _figures(_claims(described)),
        "Cost": _figures([cost(described)]),
        "Single axis": _single_axis(score, described, shown),
        "Statistics": _statistics(score),
        "Worst trials": _worst(score),
    }
    return "".join(
        [
            head,
            f'<p class="conclusion">{text(conclusion(described), LONGEST_SENTENCE)}</p>',
            f'<div class="front">{front}</div>',
            *(section(f"{anchor}-{i}", title, body) for i, (title, body) in enumerate(parts.items())),
            scored,
        ]
    )


def _figures(drawn: Sequence[Picture | None]) -> str:
    """Figures side by side, where there are any."""
    shown = "".join(one.html() for one in drawn if one is not None)
    return f'<div class="figures">{shown}</div>' if shown else ""


def _along(described: SetSummary, shown: Sequence[str]) -> str:
    """Errors against time and path: curves, then the numbers."""
    tables = series_table(described, "by_time") + series_table(described, "by_path")
    return _figures(_curves(described, shown)) + tables


def _groups(described: SetSummary) -> str:
    if not described.groups:
        return ""
    clean = [clean_against_all(described)] if "clean_trials" in described.groups else []
    return _figures(clean) + groups_table(described)


def _claims(described: SetSummary) -> list[Picture | None]:
    inside = [inside_curves(described, kind) for kind in ("calibration", "time_left")]
    return [*inside, time_left_bars(described)]


def _what(described: SetSummary) -> str:
    """Sizes, skipped trials and what the reader of the recording mended."""
    failed = [(p.name, skip) for p in described.predictors for skip in p.failed]
    notes = "".join(f"<li>{text(note, 400)}</li>" for note in described.notes)
    parts = [
        f"<p>Trials: {described.trials}; people: {described.users}; events: {described.events}; "
        f"predictors: {len(described.predictors)}.</p>",
        f"<ul>{notes}</ul>" if notes else "",
        skipped_table(described),
    ]
    if failed:
        rows = [(text(name), text(s.trial), text(s.reason)) for name, s in failed[:20]]
        caption = f"{described.name}: failures: {len(failed)}, scored as if nothing had been answered"
        parts.append(table(caption, ("predictor", "trial", "reason"), rows, words=True))
    return "".join(parts)


def _curves(described: SetSummary, shown: Sequence[str]) -> list[Picture]:
    kinds = (("by_time", "of_hold"), ("by_time", "px"), ("by_path", "of_hold"), ("by_path", "px"))
    return [curves(described, shown, kind, quantity) for kind, quantity in kinds]


def _single_axis(score: SetScore, described: SetSummary, shown: Sequence[str]) -> str:
    """The thesis's protocol: curve, groups, box plots."""
    known = {predictor.name: predictor for predictor in score.predictors}
    chosen = list(dict.fromkeys((*pair(list(known)), *shown)))[: MOST_BOXES - 1]
    boxed = [axis_profile(known[name]) for name in (*chosen, HOLD)]
    drawn = [
        curves(described, shown, "single_axis"),
        boxes(score.name, boxed, shown, simulated=score.simulated, unit=score.unit),
    ]
    groups = [key for key in GROUPS if key in described.groups]
    if groups:
        drawn.append(group_curves(described, shown, groups))
    order = [predictor.name for predictor in described.predictors]
    below = "below it with outliers replaced by the quartile bound"
    caption = f"{score.name}: single-axis MAE in {score.unit}, {below}"
    return _figures(drawn) + mae_table(caption, [axis_profile(known[name]) for name in order])


def _statistics(score: SetScore) -> str:
    """The analysis of variance of the single-axis error."""
    models = compared(score)
    profiles = [axis_profile(predictor) for predictor in score.predictors if predictor.name in models]
    thesis = models == pair([predictor.name for predictor in score.predictors])
    return statistics_html(score.name, axis_anova(score, models), profiles, thesis=thesis)


def _worst(score: SetScore) -> str:
    """The worst trials of the best predictor, where they were kept."""
    if score.worst is None:
        return "<p>Not drawn: no trials were kept when the set was scored.</p>"
    name, trials = score.worst.predictor, score.worst.trials
    rows = [_worst_row(i, trial) for i, trial in enumerate(trials)]
    unit = f"[{score.unit}]"
    head = ("panel", "user", "trial", f"distance {unit}", "time [s]", f"error {unit}", "answered")
    figure = draw_worst(score.name, score.worst, simulated=score.simulated, unit=score.unit)
    return _figures([figure]) + table(
        f"{score.name}: trials with the largest time-averaged error of {name}", head, rows
    )


def _worst_row(place: int, drawing: WorstTrial) -> tuple[str, ...]:
    about = drawing.trial.trial
    answered = float((drawing.answers.x == drawing.answers.x).mean())
    return (
        str(place + 1),
        text(about.user),
        text(about.trial),
        f"{drawing.trial.distance_px:.0f}",
        f"{drawing.trial.arrival_s:.2f}",
        f"{drawing.error_px:.1f}",
        f"{answered:.0%}",
    )
