"""The single-axis errors in a report: means, and where along the path they differ significantly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from pointpred.columns import FloatArray
from pointpred.scoring.results import AXIS_FRACTIONS, PATH_FRACTIONS
from pointpred.scoring.statistics import AnovaSeries, AxisProfile, Effect

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
