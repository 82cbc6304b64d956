"""What a report puts in front: the best predictor, those with a colour, those the statistics compare."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

import msgspec

from pointpred.scoring.report.figures.style import HOLD, MOST_LINES
from pointpred.scoring.results import SetScore
from pointpred.scoring.summary import PredictorSummary, SetSummary

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
        if p.name != HOLD and p.time_averaged.of_hold is not None
    }
    ordered = sorted(shares, key=shares.__getitem__)
    names = {*pair(ordered)}
    for name in ordered:
        if len(names) < MOST_LINES:
            names.add(name)
    return tuple(name for name in ordered if name in names)


def compared(score: SetScore) -> tuple[str, ...]:
    """Models the analysis compares: the pair of the thesis where both were scored, otherwise all but hold."""
    names = [predictor.name for predictor in score.predictors]
    both = pair(names)
    return both if len(both) == 2 else tuple(name for name in names if name != HOLD) or (HOLD,)


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
    others = [p for p in ranked(summary).predictors if p.name != HOLD]
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
