"""What a report puts in front: which predictors are told apart, and which the statistics compare."""

from __future__ import annotations

from collections.abc import Sequence

from pointpred.report.style import HOLD, MOST_LINES
from pointpred.scoring.results import SetScore
from pointpred.scoring.summary import SetSummary

SWITCHED = ("switched-printed", "switched")
KEP = ("kep-quartic-gated", "kep-quartic", "kep-quadratic-gated", "kep-quadratic")
"""The thesis compared its switched predictor with a quartic KEP that had the stability check."""


def pair(names: Sequence[str]) -> tuple[str, ...]:
    """The thesis's two models, as printed where there is a choice; fewer where they were not scored."""
    firsts = (next((name for name in kind if name in names), None) for kind in (SWITCHED, KEP))
    return tuple(name for name in firsts if name)


def highlighted(described: SetSummary) -> tuple[str, ...]:
    """At most MOST_LINES names, best first: the thesis's pair and those with the lowest error."""
    shares = {
        p.name: p.time_averaged.of_hold
        for p in described.predictors
        if p.name != HOLD and p.time_averaged.of_hold is not None
    }
    ordered = sorted(shares, key=shares.__getitem__)
    kept = {*pair(ordered)}
    for name in ordered:
        if len(kept) < MOST_LINES:
            kept.add(name)
    return tuple(name for name in ordered if name in kept)


def compared(score: SetScore) -> tuple[str, ...]:
    """Models the analysis compares: the pair of the thesis where both were scored, otherwise all but hold."""
    names = [predictor.name for predictor in score.predictors]
    both = pair(names)
    return both if len(both) == 2 else tuple(name for name in names if name != HOLD) or (HOLD,)
