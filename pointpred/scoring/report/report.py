"""A scoring run as one HTML file that needs nothing else: no request, no script."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec

from pointpred.drawing.style import Picture
from pointpred.errors import ParameterError
from pointpred.extras import require
from pointpred.files import write_whole
from pointpred.recording import Skip
from pointpred.scoring.report.choice import Conclusion, compared, conclusion, highlighted, pair, ranked
from pointpred.scoring.report.figures.boxes import boxes
from pointpred.scoring.report.figures.claims import inside_curves, time_left_bars
from pointpred.scoring.report.figures.errors import clean_against_all, cost, curves, group_curves, skill_bars
from pointpred.scoring.report.figures.paths import draw_worst
from pointpred.scoring.report.figures.style import HOLD
from pointpred.scoring.report.page import page, versions
from pointpred.scoring.report.statistics import Analysis, AxisRow, analysis, axis_row
from pointpred.scoring.results import SetScore, WorstTrials
from pointpred.scoring.statistics import AxisProfile, axis_anova, axis_profile
from pointpred.scoring.summary import SetSummary, summarise
from pointpred.scoring.summary.document import footnotes

MOST_BOXES = 4
GROUPS = (
    "with_submovements", "without_submovements", "experienced_people", "novice_people", "clean_trials"
)  # fmt: skip


class Drawn(msgspec.Struct, frozen=True):
    """Everything that the template shows of a set with trials."""

    conclusion: Conclusion
    footnotes: tuple[str, ...]
    front: Picture
    along: tuple[Picture, ...]
    groups: tuple[Picture, ...]
    claims: tuple[Picture, ...]
    cost: Picture
    axis: tuple[Picture, ...]
    profiles: tuple[AxisRow, ...]
    analysis: Analysis
    worst: WorstTrials | None
    paths: Picture | None


class Shown(msgspec.Struct, frozen=True):
    """Everything that the template shows of a set."""

    summary: SetSummary
    """Its predictors by their error, the lowest first."""
    skipped: tuple[tuple[str, tuple[Skip, ...]], ...]
    """By reason, the most frequent first."""
    failures: tuple[tuple[str, Skip], ...]
    """Predictors with the trials in which they failed."""
    drawn: Drawn | None
    """``None`` where no trial could be scored."""


def write_report(scores: Sequence[SetScore], path: str | Path) -> None:
    """Write what was scored, every table and figure, the statistics and the protocol to ``path``.

    The same scores give the same bytes. The worst trials are drawn where ``score`` was asked to keep them.
    Names in recordings are not trusted: they are escaped. Raises ParameterError for an empty list or a set
    scored without ``hold``, MissingExtraError where the extra ``report`` is not installed, and OSError when
    the file cannot be written.
    """
    require("report", "a report")
    if not scores:
        raise ParameterError("a report needs at least one scored set, received none", field="scores")
    values = {
        "title": "Endpoint prediction: scores" + (" (simulated)" if all(s.simulated for s in scores) else ""),
        "sets": [_shown(score) for score in scores],
        "versions": versions(),
    }
    write_whole(Path(path), page("report.html", values).encode())


def _shown(score: SetScore) -> Shown:
    summary = ranked(summarise(score))
    reasons: dict[str, list[Skip]] = {}
    for skip in summary.skipped:
        reasons.setdefault(skip.reason, []).append(skip)
    frequent = sorted(reasons, key=lambda reason: -len(reasons[reason]))
    return Shown(
        summary,
        tuple((reason, tuple(reasons[reason])) for reason in frequent),
        tuple((p.name, skip) for p in summary.predictors for skip in p.failed),
        _drawn(score, summary) if score.trials else None,
    )


def _drawn(score: SetScore, summary: SetSummary) -> Drawn:
    shown = highlighted(summary)
    profiles = {predictor.name: axis_profile(predictor) for predictor in score.predictors}
    inside = (inside_curves(summary, kind) for kind in ("calibration", "time_left"))
    kinds = (("by_time", "of_hold"), ("by_time", "px"), ("by_path", "of_hold"), ("by_path", "px"))
    return Drawn(
        conclusion=conclusion(summary),
        footnotes=tuple(footnotes(summary)),
        front=skill_bars(summary),
        along=tuple(curves(summary, shown, kind, quantity) for kind, quantity in kinds),
        groups=(clean_against_all(summary),) if "clean_trials" in summary.groups else (),
        claims=tuple(one for one in (*inside, time_left_bars(summary)) if one is not None),
        cost=cost(summary),
        axis=_single_axis(summary, shown, profiles),
        profiles=tuple(axis_row(profiles[p.name]) for p in summary.predictors),
        analysis=_analysis(score, profiles),
        worst=score.worst,
        paths=draw_worst(score),
    )


def _single_axis(
    summary: SetSummary, shown: Sequence[str], profiles: Mapping[str, AxisProfile]
) -> tuple[Picture, ...]:
    """The thesis's protocol: curve, box plots, groups."""
    names = list(dict.fromkeys((*pair(list(profiles)), *shown)))[: MOST_BOXES - 1]
    boxed = [profiles[name] for name in (*names, HOLD)]
    figures = [
        curves(summary, shown, "single_axis"),
        boxes(summary.name, boxed, shown, simulated=summary.simulated, unit=summary.unit),
    ]
    groups = [key for key in GROUPS if key in summary.groups]
    if groups:
        figures.append(group_curves(summary, shown, groups))
    return tuple(figures)


def _analysis(score: SetScore, profiles: Mapping[str, AxisProfile]) -> Analysis:
    """The analysis of variance of the single-axis error."""
    models = compared(score)
    compared_profiles = [profile for name, profile in profiles.items() if name in models]
    thesis = models == pair([predictor.name for predictor in score.predictors])
    return analysis(axis_anova(score, models), compared_profiles, thesis=thesis)
