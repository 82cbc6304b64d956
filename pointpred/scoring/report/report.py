"""A scoring run as one HTML file that needs nothing else: no request, no script. Or the files for a paper."""

from __future__ import annotations

import platform
import re
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import numpy as np

from pointpred.drawing import Picture
from pointpred.errors import ParameterError
from pointpred.extras import require
from pointpred.files import write_whole
from pointpred.recording import Skip, kinds_of
from pointpred.records import FloatArray
from pointpred.scoring.report.figures import (
    MOST_LINES,
    boxes,
    clean_against_all,
    cost,
    curves,
    draw_worst,
    group_curves,
    inside_curves,
    skill_bars,
    time_left_bars,
)
from pointpred.scoring.report.tables import tables_of
from pointpred.scoring.results import AXIS_FRACTIONS, PATH_FRACTIONS, SetScore, WorstTrials
from pointpred.scoring.statistics import (
    EVERY_PAIR,
    AnovaSeries,
    AxisProfile,
    Effect,
    axis_anova,
    axis_profile,
)
from pointpred.scoring.summary import FLOOR, PredictorSummary, SetSummary, summarise
from pointpred.scoring.summary.document import about_memory, about_targets, footnotes

if TYPE_CHECKING:
    from jinja2 import Environment

SWITCHED = ("switched-printed", "switched")
KEP = ("kep-quartic-gated", "kep-quartic", "kep-quadratic-gated", "kep-quadratic")
"""The thesis compared its switched predictor with a quartic KEP that had the stability check."""


def pair(names: Sequence[str]) -> tuple[str, ...]:
    """The thesis's two models, as printed where there is a choice; fewer where they were not scored."""
    firsts = (next((name for name in kind if name in names), None) for kind in (SWITCHED, KEP))
    return tuple(name for name in firsts if name)


def highlighted(summary: SetSummary) -> tuple[str, ...]:
    """At most MOST_LINES names, best first: the thesis's pair and those with the lowest error."""
    shares = {
        p.name: p.time_averaged.of_hold
        for p in summary.predictors
        if p.name != FLOOR and p.time_averaged.of_hold is not None
    }
    ordered = sorted(shares, key=shares.__getitem__)
    names = {*pair(ordered)}
    for name in ordered:
        if len(names) < MOST_LINES:
            names.add(name)
    return tuple(name for name in ordered if name in names)


def compared(score: SetScore) -> tuple[str, ...]:
    """Models the analysis compares: the two that were asked for, or the thesis's, otherwise all but hold."""
    if score.contrast and score.contrast != EVERY_PAIR:
        return score.contrast
    names = [predictor.name for predictor in score.predictors]
    both = pair(names)
    return both if len(both) == 2 else tuple(name for name in names if name != FLOOR) or (FLOOR,)


class Conclusion(msgspec.Struct, frozen=True):
    """The sentence at the top of a set: its main result."""

    best: PredictorSummary | None
    """The lowest error, hold apart; fitted to people of the set only where all are."""
    better: bool
    """Whether its error is lower than that of hold."""
    doubtful: bool
    """Whether chance alone may explain that."""
    fitted: tuple[str, ...]
    """Predictors fitted to people of the set whose error is as low: no fair comparison."""


def conclusion(summary: SetSummary) -> Conclusion:
    """Which predictor has the lowest error, and how sure that is."""
    others = [p for p in ranked(summary).predictors if p.name != FLOOR]
    best = next(iter([p for p in others if not p.seen] or others), None)
    if best is None:
        return Conclusion(None, better=False, doubtful=False, fitted=())
    measure = best.time_averaged
    better = measure.of_hold is not None and measure.of_hold < 1.0
    return Conclusion(
        best,
        better,
        better and measure.interval is not None and measure.interval[1] >= 1.0,
        tuple(p.name for p in summary.predictors if p.seen and _error(p) <= _error(best)),
    )


def ranked(summary: SetSummary) -> SetSummary:
    """The same set with its predictors by their time-averaged error, the lowest first."""
    return msgspec.structs.replace(summary, predictors=tuple(sorted(summary.predictors, key=_error)))


def _error(predictor: PredictorSummary) -> float:
    px = predictor.time_averaged.px
    return inf if px is None else px


ALPHA = 0.05
COLUMNS = [AXIS_FRACTIONS.index(fraction) for fraction in PATH_FRACTIONS]

Spans = tuple[tuple[float, float], ...]
"""Runs of neighbouring shares of the path, the first and the last of each."""


class AxisRow(msgspec.Struct, frozen=True):
    """Mean absolute errors of one predictor at PATH_FRACTIONS, and with outliers replaced."""

    name: str
    cells: tuple[tuple[float, float], ...]


class Term(msgspec.Struct, frozen=True):
    """One term of the analysis along the path."""

    name: str
    significant: Spans
    """Where its corrected p is below ALPHA."""
    at: float
    """Share of the path with the largest F, among the significant ones where there are any."""
    effect: Effect
    """There."""
    cells: tuple[Effect | None, ...]
    """At PATH_FRACTIONS."""


class Part(msgspec.Struct, frozen=True):
    """The analysis of all errors, or of those without outliers."""

    title: str
    terms: tuple[Term, ...]
    leads: tuple[tuple[str, Spans], ...]
    """Where each predictor has the lowest mean error: the direction that F does not give."""


class Analysis(msgspec.Struct, frozen=True):
    """The analysis of variance of one set; ``parts`` is empty where it could not be run."""

    series: AnovaSeries
    thesis: bool
    """Whether the models compared are the thesis's two."""
    parts: tuple[Part, ...]


def axis_row(profile: AxisProfile) -> AxisRow:
    """One row of the table of mean absolute errors."""
    pairs = zip(profile.mae[COLUMNS].tolist(), profile.mae_replaced[COLUMNS].tolist(), strict=True)
    return AxisRow(profile.name, tuple(pairs))


def analysis(series: AnovaSeries, profiles: Sequence[AxisProfile], *, thesis: bool = False) -> Analysis:
    """What is shown of an analysis; ``profiles`` are those of the models compared."""
    if not any(series.effects):
        return Analysis(series, thesis, ())
    plain = leads({profile.name: profile.mae for profile in profiles})
    replaced = leads({profile.name: profile.mae_replaced for profile in profiles})
    parts = (
        Part("All errors", terms(series.effects), plain),
        Part("Outliers replaced by the quartile bound", terms(series.effects_replaced), replaced),
    )
    return Analysis(series, thesis, parts)


def terms(effects: Sequence[Sequence[Effect]]) -> tuple[Term, ...]:
    """Each term of the analyses at AXIS_FRACTIONS, in the order in which they first appear."""
    names = dict.fromkeys(effect.factors for at in effects for effect in at)
    return tuple(_term(factors, effects) for factors in names)


def _term(factors: tuple[str, ...], effects: Sequence[Sequence[Effect]]) -> Term:
    along = {i: effect for i, at in enumerate(effects) for effect in at if effect.factors == factors}
    significant = [i for i, effect in along.items() if effect.p_corrected < ALPHA]
    top = max(significant or along, key=lambda i: along[i].f)
    cells = tuple(along.get(i) for i in COLUMNS)
    return Term(" x ".join(factors), _spans(significant), AXIS_FRACTIONS[top], along[top], cells)


def leads(means: Mapping[str, FloatArray]) -> tuple[tuple[str, Spans], ...]:
    """Where along the path each predictor has the lowest error; ``means`` at AXIS_FRACTIONS, by predictor."""
    best = np.array(list(means.values())).argmin(axis=0)
    places = {name: np.flatnonzero(best == i).tolist() for i, name in enumerate(means)}
    return tuple((name, _spans(at)) for name, at in places.items() if at)


def _spans(places: Sequence[int]) -> Spans:
    runs: list[list[int]] = []
    for place in places:
        if runs and place == runs[-1][-1] + 1:
            runs[-1].append(place)
        else:
            runs.append([place])
    return tuple((AXIS_FRACTIONS[run[0]], AXIS_FRACTIONS[run[-1]]) for run in runs)


PACKAGES = ("pointpred", "numpy", "scipy", "statsmodels", "matplotlib")
LONGEST = 80
"""Characters of a name that are shown."""
NOTHING = "–"


def page(name: str, values: Mapping[str, object]) -> str:
    """The template ``name`` filled in."""
    return environment().get_template(name).render(values)


@cache
def environment() -> Environment:
    """The templates, with escaping and the ways to write a number."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("pointpred.scoring.report"),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=_printable,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters.update(short=short, number=number, percent=percent, line=_line)
    environment.globals.update(alpha=ALPHA, shares=PATH_FRACTIONS)
    return environment


def _printable(value: object) -> object:
    """Text without characters that no page may hold; what is HTML already stays."""
    if not isinstance(value, str) or hasattr(value, "__html__"):
        return value
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in value)


def short(value: object, longest: int = LONGEST) -> str:
    """A name or note, cut to ``longest`` characters."""
    shown = str(value)
    return shown if len(shown) <= longest else shown[: longest - 1] + "…"


def number(value: float | None, digits: int = 2) -> str:
    """A number for a cell, a dash where there is none."""
    return NOTHING if value is None else f"{value:.{digits}f}"


def percent(value: float | None) -> str:
    """A share in percent, a dash where there is none."""
    return NOTHING if value is None else f"{value:.0%}"


def _line(value: str) -> str:
    """The same words with one space between them; what is HTML stays HTML."""
    return type(value)(" ".join(value.split()))


def versions() -> list[tuple[str, str]]:
    """What computed the report."""
    packages = [("Python", platform.python_version())]
    for name in PACKAGES:
        try:
            packages.append((name, version(name)))
        except PackageNotFoundError:  # run from a source tree that is not installed
            packages.append((name, "not installed as a package"))
    return packages


MOST_BOXES = 4
MOST_ROWS = 40
"""Rows of a table that fit on a page."""
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
    claims: dict[str, Picture]
    cost: Picture
    axis: tuple[Picture, ...]
    profiles: tuple[AxisRow, ...]
    analysis: Analysis
    worst: WorstTrials | None
    paths: Picture | None

    @property
    def figures(self) -> dict[str, Picture]:
        """Every figure, by the name of its file."""
        named = {"of-hold": self.front, "cost": self.cost}
        named |= zip(("by-time", "by-time-px", "by-path", "by-path-px"), self.along, strict=True)
        named |= zip(("clean",), self.groups, strict=False)
        named |= zip(("single-axis", "single-axis-boxes", "single-axis-groups"), self.axis, strict=False)
        named |= self.claims
        return named if self.paths is None else named | {"worst": self.paths}


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


PAGE = "report.html"
UNSAFE = re.compile(r"[^\w.-]+")


def page_in(path: str | Path) -> Path:
    """The file of the page of a report: ``path``, or in it, where it is a folder or has no extension."""
    path = Path(path)
    return path / PAGE if path.is_dir() or not (path.suffix or path.is_file()) else path


def write_report(scores: Sequence[SetScore], path: str | Path) -> None:
    """Write what was scored, every table and figure, the statistics and the protocol to ``path``.

    A folder, or a name without an extension, gets the page ``report.html`` and for each set a folder with
    each figure as SVG and PDF and each table as CSV and LaTeX (packages booktabs and longtable), which has
    the folder in its label: tab:FOLDER-scores.
    The same scores give the same bytes. The worst trials are drawn where ``score`` was asked to keep them.
    Names in recordings are not trusted: they are escaped. Raises ParameterError for an empty list or a set
    scored without ``hold``, MissingExtraError where the extra ``report`` is not installed, and OSError when
    the file cannot be written.
    """
    require("report", "a report")
    if not scores:
        raise ParameterError("a report needs at least one scored set, received none", field="scores")
    sets = [_shown(score) for score in scores]
    values = {
        "title": "Endpoint prediction: scores" + (" (simulated)" if all(s.simulated for s in scores) else ""),
        "sets": sets,
        "versions": versions(),
    }
    target = page_in(path)
    target.parent.mkdir(exist_ok=True)
    write_whole(target, page(PAGE, values).encode())
    if target != Path(path):
        names: dict[str, int] = {}
        for one in sets:
            plain = UNSAFE.sub("_", one.summary.name).strip("._")[:LONGEST] or "set"
            names[plain.lower()] = again = names.get(plain.lower(), 0) + 1
            _write_files(one, target.parent / (plain if again == 1 else f"{plain}_{again}"))


def _write_files(one: Shown, folder: Path) -> None:
    """The figures of a set as SVG and PDF, its tables as CSV and LaTeX."""
    folder.mkdir(exist_ok=True)
    if one.drawn is None:
        return
    for name, figure in one.drawn.figures.items():
        write_whole(folder / f"{name}.svg", figure.svg.encode())
        write_whole(folder / f"{name}.pdf", figure.pdf())
    for name, (caption, table) in tables_of(one.summary, one.drawn.analysis.series).items():
        write_whole(folder / f"{name}.csv", table.to_csv(index=False, lineterminator="\n").encode())
        tex = table.to_latex(
            index=False,
            escape=True,
            float_format=lambda value: f"{value:#.3g}".rstrip("."),
            na_rep="--",
            caption=caption.replace("%", r"\%"),
            label=f"tab:{folder.name}-{name}",
            longtable=len(table) > MOST_ROWS,
        )
        write_whole(folder / f"{name}.tex", tex.encode())


def _with_short_names(score: SetScore) -> SetScore:
    """The set with shorter names of predictors without memory, which figures have room for."""
    short = {one.name: f"{one.ablates}, no memory" for one in score.predictors if one.ablates}
    replace = msgspec.structs.replace
    worst = score.worst and replace(
        score.worst, predictor=short.get(score.worst.predictor, score.worst.predictor)
    )
    return replace(
        score,
        predictors=tuple(replace(one, name=short.get(one.name, one.name)) for one in score.predictors),
        contrast=tuple(short.get(name, name) for name in score.contrast),
        worst=worst,
    )


def _shown(score: SetScore) -> Shown:
    score = _with_short_names(score)
    summary = ranked(summarise(score))
    return Shown(
        summary,
        tuple((kind, tuple(some)) for kind, some in kinds_of(summary.skipped)),
        tuple((p.name, skip) for p in summary.predictors for skip in p.failed),
        _drawn(score, summary) if score.trials else None,
    )


def _drawn(score: SetScore, summary: SetSummary) -> Drawn:
    shown = highlighted(summary)
    profiles = {predictor.name: axis_profile(predictor) for predictor in score.predictors}
    claims = {
        "regions": inside_curves(summary, "calibration"),
        "arrivals": inside_curves(summary, "time_left"),
        "time-left": time_left_bars(summary),
    }
    kinds = (("by_time", "of_hold"), ("by_time", "px"), ("by_path", "of_hold"), ("by_path", "px"))
    return Drawn(
        conclusion=conclusion(summary),
        footnotes=tuple(filter(None, (about_targets(summary), about_memory(summary), *footnotes(summary)))),
        front=skill_bars(summary),
        along=tuple(curves(summary, shown, kind, quantity) for kind, quantity in kinds),
        groups=(clean_against_all(summary),) if "clean_trials" in summary.groups else (),
        claims={name: one for name, one in claims.items() if one is not None},
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
    boxed = [profiles[name] for name in (*names, FLOOR)]
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
    thesis = not score.contrast and models == pair([predictor.name for predictor in score.predictors])
    return analysis(axis_anova(score, models), compared_profiles, thesis=thesis)
