"""The same predictors behind other differentiators: ``python -m pages.differentiators.scored``.

Scores the embedded sample and the sets in the folder that POINTPRED_RECORDINGS names; without one
nothing is kept.
"""

from __future__ import annotations

from typing import Any

from pages.arguments import parse
from pages.data import Table, keep
from pages.scored import named
from pages.sets import folder, recordings
from pointpred import build
from pointpred.pipeline import Pipeline
from pointpred.scoring import score, summarise

PREDICTORS = ("minimum-jerk", "switched-direction")
PRINTED = {"gain_lambda": 5.0, "gain_xi": 2.0, "alpha": -0.2}
CHOICES: dict[str, dict[str, Any]] = {
    "HOMD": {},
    "HOMD, printed gains": PRINTED,
    "kalman": {"differentiator": "kalman"},
}


def patterns() -> list[Pipeline]:
    """Every predictor behind every differentiator, each under a name of its own."""
    pipelines = []
    for predictor in PREDICTORS:
        for choice, parameters in CHOICES.items():
            pipelines.append(named(f"{predictor}, {choice}", build(predictor, **parameters)))
    return pipelines


def main() -> None:
    """Print the table, and keep it where recordings are at hand."""
    source, unread = folder(), {}
    shares: dict[str, dict[str, float]] = {}
    for recording in recordings(source, unread):
        for one in map(summarise, score([recording], patterns())):
            for predictor in one.predictors:
                shares.setdefault(predictor.name, {})[one.name] = predictor.time_averaged.of_hold
    sets = list(shares.pop("hold"))
    rows = []
    for name, values in shares.items():
        predictor, _, choice = name.partition(", ")
        rows.append((predictor, choice, *(f"{values[one]:.3f}" for one in sets)))
    scored = Table.of(("predictor", "differentiator", *sets), rows)
    for row in scored.texts():
        print("  ".join(row))
    for file, reason in unread.items():
        print(f"{file}: {reason}")
    if source:
        keep("differentiators", {"scored": scored})


if __name__ == "__main__":
    parse(__doc__)
    main()
