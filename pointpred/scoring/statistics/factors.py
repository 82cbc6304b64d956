"""The conditions that the trials of a set have in common, as factors of an analysis of variance."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pointpred.scoring.results import ScoredTrial

FIRST = ("distance", "width", "transfer", "ptf")
"""Factors of the thesis, tried before whatever else a recording knows; a name that begins so counts."""
OUTCOMES = ("hit", "miss", "correct", "error", "clean", "end_", "duration", "onset", "t_", "begins")
"""Conditions that begin so say how or when a trial went: what was measured is no cause of its error."""
MOST_VALUES = 12
"""A number with more values than this is a measurement and no condition, unless its name is in FIRST."""


def factors_of(trials: Sequence[ScoredTrial]) -> dict[str, list[str]]:
    """Every condition that all trials know, as labels with a row a trial, the thesis's factors first.

    Outcomes and measured numbers are not among them. The target's width is a factor where no condition
    says it.
    """
    if not trials:
        return {}
    shared = set.intersection(*(set(trial.trial.condition) for trial in trials))
    shared = {name for name in shared if not name.startswith(OUTCOMES) and not _measured(name, trials)}
    factors = {name: [_label(trial.trial.condition[name]) for trial in trials] for name in sorted(shared)}
    widths = [trial.trial.target_w for trial in trials]
    if not any(name.startswith("width") for name in factors) and np.isfinite(widths).all():
        factors["width"] = [_label(width) for width in widths]
    return {name: factors[name] for name in sorted(factors, key=_rank)}


def _measured(name: str, trials: Sequence[ScoredTrial]) -> bool:
    """Whether a condition is a number that hardly comes twice."""
    values = {trial.trial.condition[name] for trial in trials}
    words = any(isinstance(value, str) for value in values)
    return len(values) > MOST_VALUES and not words and not name.startswith(FIRST)


def _rank(name: str) -> tuple[int, str]:
    places = [place for place, start in enumerate(FIRST) if name.startswith(start)]
    return (places[0] if places else len(FIRST)), name


def _label(value: str | float) -> str:
    return value if isinstance(value, str) else f"{value:g}"
